/// libFuzzer's way in. A fault ends the process, as the fuzzer wants it.
#include <pthread.h>
#include <sanitizer/common_interface_defs.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "target.hpp"

/// A process that a reader makes for itself (core/subprocess.hpp) may crash: that is no find.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
    return pthread_atfork(nullptr, nullptr, [] { __sanitizer_set_death_callback(nullptr); });
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (const auto fault = soft::fuzz::fault_of({reinterpret_cast<const std::byte*>(data), size})) {
        std::fprintf(stderr, "FAULT: %s\n", fault->c_str());
        std::abort();
    }
    return 0;
}
