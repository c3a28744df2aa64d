#include "math/threads.hpp"

#include <omp.h>

#include <algorithm>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace soft {

namespace {

/// Starts a team of at most `wanted` threads and returns its size.
int start_team(int wanted) {
    std::vector<std::thread> threads;
    std::mutex gate;
    std::unique_lock closed(gate);  // all threads exist at once
    int size = 1;
    try {
        for (; size < wanted; ++size) threads.emplace_back([&] { const std::lock_guard wait(gate); });
    } catch (const std::system_error&) {
        size = std::max(1, size - 1);  // libgomp needs some memory of its own
    }
    closed.unlock();
    for (std::thread& thread : threads) thread.join();
#pragma omp parallel num_threads(size) if (size > 1)
    {}
    return size;
}

}  // namespace

int thread_count(int stated) {
    static int asked = 1, started = 1;  // called by one thread, outside of parallel loops
    const int wanted = stated > 0 ? stated : omp_get_max_threads();
    if (wanted > asked) {
        started = start_team(wanted);
        asked = wanted;
    }
    return std::min(wanted, started);
}

void for_ranges(std::size_t count, int threads, const std::function<void(std::size_t begin, std::size_t end)>& work) {
    const auto parts = static_cast<std::size_t>(std::max(threads, 1));
    std::vector<std::exception_ptr> thrown(parts);  // an exception must not leave a parallel region
#pragma omp parallel for num_threads(threads) schedule(static) if (threads > 1)
    for (std::size_t part = 0; part < parts; ++part) {
        try {
            work(count * part / parts, count * (part + 1) / parts);
        } catch (...) {
            thrown[part] = std::current_exception();
        }
    }
    for (const std::exception_ptr& exception : thrown)
        if (exception) std::rethrow_exception(exception);
}

}  // namespace soft
