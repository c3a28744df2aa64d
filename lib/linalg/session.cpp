#include "linalg/session.hpp"

#include <dlfcn.h>
#include <omp.h>
#include <petscksp.h>
#include <unistd.h>

#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "core/error.hpp"
#include "core/memory.hpp"
#include "linalg/petsc.hpp"
#include "linalg/small_matrix.hpp"

namespace soft::linalg {

namespace {

const auto petsc_print = PetscVFPrintf;  // PETSc's original function, before it is replaced

/// stdout is reserved for data, but -log_view, -ksp_monitor and -help print to it. PetscInitialize resets PETSC_STDOUT and prints
/// before it returns, so only this hook redirects all output.
PetscErrorCode print_to_stderr(FILE* file, const char* format, va_list arguments) {
    return petsc_print(file == stdout ? stderr : file, format, arguments);
}

/// If memory runs out during start-up, MPI crashes and OpenBLAS hangs. Measured: both need 260 MB of address space.
constexpr std::size_t memory_to_start = std::size_t{288} << 20;

/// OpenBLAS allocates its buffer at the first call that needs one, and keeps it.
void allocate_blas_buffer() {
    SmallMatrix one(1);
    one.at(0, 0) = 1.0;
    static_cast<void>(solve(one, {1.0}));
}

/// Open MPI searches for networks when it starts, which takes longer than a small solve. The search is skipped if all ranks are on
/// one machine. Values set by the user are kept (overwrite = 0).
void set_mpi_defaults() {
    const auto text = [](const char* variable) -> std::string_view {
        const char* value = std::getenv(variable);
        return value != nullptr ? value : "";
    };
    const std::string_view ranks = text("OMPI_COMM_WORLD_SIZE");
    // Started by mpirun, by srun with PMIx, with PMI.
    const bool alone = ranks.empty() && text("PMIX_NAMESPACE").empty() && text("PMI_RANK").empty();
    if (alone) {
        setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
        // The session folder is shared: a process that ends removes it while another starts.
        setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
    }
    if (!alone && (ranks.empty() || ranks != text("OMPI_COMM_WORLD_LOCAL_SIZE"))) return;
    setenv("OMPI_MCA_pml", "ob1", 0);
    setenv("OMPI_MCA_btl", "self,vader", 0);
}

/// Checked here because PETSc reports a missing options file with a stack trace.
void check_options_files(const std::vector<std::string>& options) {
    for (std::size_t i = 0; i + 1 < options.size(); ++i)
        if (options[i] == "-options_file" && access(options[i + 1].c_str(), R_OK) != 0)
            throw Error(ExitCode::cannot_open, "-options_file " + options[i + 1], "cannot be opened");
}

}  // namespace

Session::Session(const std::vector<std::string>& options) {
    check_options_files(options);
    set_mpi_defaults();
    // With threads the partition is not reproducible, and last digits would differ.
    setenv("SCOTCH_PTHREAD_NUMBER", "1", 1);
    core::require_memory(memory_to_start);
    allocate_blas_buffer();
    std::vector<std::string> words{"solve", "-no_signal_handler", "-skip_petscrc"};
    words.insert(words.end(), options.begin(), options.end());
    std::vector<char*> pointers;
    for (auto& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    int argc = static_cast<int>(words.size());
    char** argv = pointers.data();
    PetscVFPrintf = print_to_stderr;
    SOFT_PETSC(PetscInitialize(&argc, &argv, nullptr, nullptr));
    SOFT_PETSC(PetscPopErrorHandler());
    SOFT_PETSC(PetscPushErrorHandler(PetscReturnErrorHandler, nullptr));
    MPI_Comm_rank(PETSC_COMM_WORLD, &rank_);
    MPI_Comm_size(PETSC_COMM_WORLD, &size_);
    if (size_ > 1 && std::getenv("OMP_NUM_THREADS") == nullptr) omp_set_num_threads(1);
}

Session::~Session() {
    (void)PetscOptionsSetValue(nullptr, "-options_left", "no");
    (void)PetscFinalize();
}

std::vector<std::string> Session::unused_options() const {
    PetscInt count = 0;
    char** names = nullptr;
    char** values = nullptr;
    SOFT_PETSC(PetscOptionsLeftGet(nullptr, &count, &names, &values));
    std::vector<std::string> left;
    for (PetscInt i = 0; i < count; ++i)
        if (const std::string_view name(names[i]); name != "no_signal_handler" && name != "skip_petscrc")
            left.emplace_back(names[i]);
    SOFT_PETSC(PetscOptionsLeftRestore(nullptr, &count, &names, &values));
    return left;
}

std::string petsc_version() {
    return std::to_string(PETSC_VERSION_MAJOR) + "." + std::to_string(PETSC_VERSION_MINOR) + "." +
           std::to_string(PETSC_VERSION_SUBMINOR);
}

namespace {

/// Looks up an OpenBLAS function at run time: libblas.so.3 may be any BLAS.
const char* openblas_text(const char* function) {
    using TextFunction = char* (*)();
    void* symbol = dlsym(RTLD_DEFAULT, function);
    return symbol != nullptr ? reinterpret_cast<TextFunction>(symbol)() : nullptr;
}

}  // namespace

std::string blas_name() {
    if (const char* core = openblas_text("openblas_get_corename")) {
        const char* config = openblas_text("openblas_get_config");
        std::string text{config != nullptr ? config : "OpenBLAS"};
        const auto second_space = text.find(' ', text.find(' ') + 1);
        return text.substr(0, second_space) + " " + core;
    }
    if (dlsym(RTLD_DEFAULT, "bli_info_get_version_str") != nullptr)
        return "BLIS " + std::string(openblas_text("bli_info_get_version_str"));
    if (dlsym(RTLD_DEFAULT, "MKL_Get_Version_String") != nullptr) return "MKL";
    return "reference BLAS (slow: install libopenblas0-serial or another optimised BLAS)";
}

bool is_blas_kernel_slow(std::string& better) {
    const char* core = openblas_text("openblas_get_corename");
    if (core == nullptr) return false;
    const std::string_view kernel{core};
    const bool old_kernel =
        kernel == "Prescott" || kernel == "Core2" || kernel == "Nehalem" || kernel == "Generic" || kernel == "generic";
#if defined(__x86_64__)
    if (old_kernel && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl")) {
        better = "SkylakeX";
        return true;
    }
    if (old_kernel && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
        better = "Haswell";
        return true;
    }
#endif
    (void)old_kernel;
    return false;
}

void choose_blas_kernel(char** argv) {
    std::string better;
    if (std::getenv("OPENBLAS_CORETYPE") != nullptr || !is_blas_kernel_slow(better)) return;
    setenv("OPENBLAS_CORETYPE", better.c_str(), 0);
    std::error_code unknown;
    // The real path, so that ps and top show the program's name.
    const auto program = std::filesystem::read_symlink("/proc/self/exe", unknown);
    if (!unknown) execv(program.c_str(), argv);
}

}  // namespace soft::linalg
