#include "meshing/gmsh_session.hpp"

#include <dlfcn.h>

#include <filesystem>

#include "core/error.hpp"
#include "core/memory.hpp"

namespace soft::meshing {
namespace {

constexpr const char* module_file = "soft_gmsh.so";

/// With RTLD_DEEPBIND symbols are searched in gmsh and its libraries first, not in the program, which takes less time (not supported by
/// the address sanitizer).
#if defined(SOFT_SANITIZED) || !defined(RTLD_DEEPBIND)
constexpr int load_flags = RTLD_LAZY | RTLD_LOCAL;
#else
constexpr int load_flags = RTLD_LAZY | RTLD_LOCAL | RTLD_DEEPBIND;
#endif

/// With less memory the loader or one of the libraries may abort the program. Measured: 120 MB of address space for the smallest mesh.
constexpr std::size_t memory_to_load = std::size_t{112} << 20;

Error not_loaded() {
    const char* reason = ::dlerror();
    const std::string why = reason != nullptr ? reason : "unknown reason";
    if (why.find("failed to map segment") != std::string::npos) return core::out_of_memory();
    return {ExitCode::cannot_open, module_file, "cannot be loaded: " + why,
            "install gmsh, or rebuild with the installed version"};
}

/// Never closed: some of the libraries crash when they are unloaded.
void* load_module() {
    core::require_memory(memory_to_load);
    std::error_code unknown;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", unknown);
    const auto installed = program.parent_path().parent_path() / "lib" / "soft-actuator" / module_file;
    void* module = ::dlopen(std::filesystem::exists(installed, unknown) ? installed.c_str() : module_file, load_flags);
    if (module == nullptr) throw not_loaded();
    return module;
}

}  // namespace

std::unique_ptr<GmshSession> open_gmsh() {
    static void* const module = load_module();
    auto* open = reinterpret_cast<GmshSession* (*)()>(::dlsym(module, "soft_open_gmsh"));
    if (open == nullptr) throw not_loaded();
    return std::unique_ptr<GmshSession>(open());
}

}  // namespace soft::meshing
