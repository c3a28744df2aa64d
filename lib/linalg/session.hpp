#pragma once
/// MPI and PETSc for the life of one object, made once in a tool's main (or a test's).
#include <string>
#include <vector>

namespace soft::linalg {

class Session {
public:
    /// Starts MPI and PETSc; `options` are PETSc's own, as after `--` on the command line. A single process started
    /// without mpirun skips the launcher's daemons, which cost 0.3 s. PETSc's signal handler stays off: with a closed
    /// pipe it can hang. A petscrc in the working or home folder is not read: it would change results unseen. What PETSc
    /// prints (-log_view, -help) goes to stderr. Throws core::out_of_memory() where the address space that is left is too little
    /// for MPI and BLAS to start. Tested by tests/faults/memory.sh.
    explicit Session(const std::vector<std::string>& options);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    [[nodiscard]] int rank() const noexcept { return rank_; }
    [[nodiscard]] int size() const noexcept { return size_; }

    /// Options that nothing has asked for by now (a misspelt PETSc option), for a warning.
    [[nodiscard]] std::vector<std::string> unused_options() const;

private:
    int rank_ = 0;
    int size_ = 1;
};

[[nodiscard]] std::string petsc_version();

/// Name of the BLAS that the process runs with, kernel included where it tells: "OpenBLAS 0.3.21 SkylakeX".
[[nodiscard]] std::string blas_name();

/// True where OpenBLAS has picked kernels far below what the processor can do (an unknown newer processor falls back
/// to SSE3 kernels, 2.5 times slower); `better` then names the value for OPENBLAS_CORETYPE, which is read when the
/// library loads, so the process must be started again with it.
[[nodiscard]] bool blas_kernel_is_poor(std::string& better);

/// To be called first in a main, before anything is read or written: where the kernels are poor the program starts itself again
/// with the right name set. A value that the user has set is left alone; where the start fails it runs on, slower.
void choose_blas_kernel(char** argv);

}  // namespace soft::linalg
