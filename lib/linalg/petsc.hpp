#pragma once
/// RAII owners of PETSc handles. The raw handle is always accessible. Every PETSc call goes through `check`, which turns a non-zero
/// error code of PETSc's C interface into an Error (internal).
#include <petscksp.h>

#include <span>
#include <utility>
#include <vector>

namespace soft::linalg {

/// Throws Error(internal) with the call and PETSc's message if `code` is not zero. Throws Error(usage) for an unknown PETSc type,
/// which only PETSc options can request.
void check(PetscErrorCode code, const char* call);
#define SOFT_PETSC(call) ::soft::linalg::check((call), #call)

template <class Handle, PetscErrorCode (*Destroy)(Handle*)>
class Owned {
public:
    Owned() = default;
    explicit Owned(Handle handle) : handle_(handle) {}
    Owned(Owned&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
    Owned& operator=(Owned&& other) noexcept {
        std::swap(handle_, other.handle_);
        return *this;
    }
    Owned(const Owned&) = delete;
    Owned& operator=(const Owned&) = delete;
    ~Owned() {
        if (handle_ != nullptr) (void)Destroy(&handle_);
    }
    [[nodiscard]] Handle get() const noexcept { return handle_; }
    operator Handle() const noexcept { return handle_; }  // NOLINT(google-explicit-constructor): for PETSc's calls
    [[nodiscard]] Handle release() noexcept { return std::exchange(handle_, nullptr); }
    [[nodiscard]] Handle* out() noexcept { return &handle_; }  ///< for PETSc's create functions

private:
    Handle handle_ = nullptr;
};

using Vector = Owned<Vec, VecDestroy>;
using Matrix = Owned<Mat, MatDestroy>;
using KrylovSolver = Owned<KSP, KSPDestroy>;
using Scatter = Owned<VecScatter, VecScatterDestroy>;
using IndexSet = Owned<IS, ISDestroy>;
using NullSpace = Owned<MatNullSpace, MatNullSpaceDestroy>;

[[nodiscard]] Vector duplicate(Vec like);  ///< same layout, zero
[[nodiscard]] double dot(Vec a, Vec b);
[[nodiscard]] double norm(Vec a);
/// gather: all values of a distributed vector on rank 0, empty on the others. spread: sets each rank's values from `all`, which every
/// rank holds in full.
[[nodiscard]] std::vector<double> gather(Vec distributed);
void spread(std::span<const double> all, Vec distributed);
void copy(Vec from, Vec to);
void add(Vec y, double factor, Vec x);  ///< y += factor x
/// Y += factor X, whose pattern that of Y contains.
void add(Mat Y, double factor, Mat X);
/// Completes the insertion or addition of entries. Collective.
void assemble(Vec x);
void assemble(Mat K);

}  // namespace soft::linalg
