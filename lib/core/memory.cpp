#include "core/memory.hpp"

#include <sys/mman.h>

namespace soft::core {

Error out_of_memory() {
    return {ExitCode::io_error, "", "out of memory",
            "use a coarser mesh, or allow more (ulimit -v, the limit of the job)"};
}

void require_memory(std::size_t bytes) {
    void* probe = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (probe == MAP_FAILED) throw out_of_memory();
    ::munmap(probe, bytes);
}

}  // namespace soft::core
