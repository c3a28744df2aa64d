/// Entry point for libFuzzer. A fault aborts the process, as libFuzzer expects.
#include <pthread.h>
#include <sanitizer/common_interface_defs.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "target.hpp"

/// A crash in a subprocess of a reader (core/subprocess.hpp) is not a finding.
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
