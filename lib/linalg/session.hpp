#pragma once
/// RAII initialisation of MPI and PETSc. Create one object in the main function of a tool or a test.
#include <string>
#include <vector>

namespace soft::linalg {

class Session {
public:
    /// Starts MPI and PETSc; `options` are PETSc options, as after `--` on the command line. A single process started without mpirun
    /// skips the launcher's daemons, which cost 0.3 s. PETSc's signal handler is off: it can hang on a closed pipe. A petscrc file in
    /// the working or home directory is not read: it would change results unnoticed. PETSc's output (-log_view, -help) goes to
    /// stderr. Throws core::out_of_memory() if the remaining address space is too small for MPI and BLAS to start.
    /// Tested by tests/faults/memory.sh.
    explicit Session(const std::vector<std::string>& options);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    [[nodiscard]] int rank() const noexcept { return rank_; }
    [[nodiscard]] int size() const noexcept { return size_; }

    /// Options that PETSc has not used so far (such as a misspelt option), for a warning.
    [[nodiscard]] std::vector<std::string> unused_options() const;

private:
    int rank_ = 0;
    int size_ = 1;
};

[[nodiscard]] std::string petsc_version();

/// Name of the BLAS library in use, with its kernel where available: "OpenBLAS 0.3.21 SkylakeX".
[[nodiscard]] std::string blas_name();

/// True if OpenBLAS has selected kernels far slower than the processor allows (for an unknown newer processor it falls back to SSE3
/// kernels, 2.5 times slower). `better` is then the value for OPENBLAS_CORETYPE. OpenBLAS reads it when the library is loaded, so the
/// process must be restarted.
[[nodiscard]] bool is_blas_kernel_slow(std::string& better);

/// Call first in main, before any input or output. If the kernels are slow, the program restarts itself with OPENBLAS_CORETYPE set. A
/// value set by the user is kept. If the restart fails, the program continues with the slow kernels.
void choose_blas_kernel(char** argv);

}  // namespace soft::linalg
