/// Replays stored inputs without a fuzzer:  replay FILE|FOLDER...   Exit code 1 with the first file that triggers a fault or exceeds
/// the time or memory limits of README.md.
#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <set>

#include "core/files.hpp"
#include "target.hpp"

namespace {

constexpr std::chrono::seconds longest{10};
constexpr long max_kib = 1L << 20;

long peak_kib() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

std::string fault_of(const std::filesystem::path& file) {
    const auto bytes = soft::core::read_file(file);
    const auto start = std::chrono::steady_clock::now();
    const auto fault = soft::fuzz::fault_of(bytes);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    if (fault) return *fault;
    if (took > longest) return "takes " + std::to_string(took.count()) + " s";
    if (peak_kib() > max_kib) return "takes " + std::to_string(peak_kib()) + " KiB";
    return {};
}

}  // namespace

int main(int argc, char** argv) {
    std::set<std::filesystem::path> files;
    for (int i = 1; i < argc; ++i) {
        if (std::filesystem::is_regular_file(argv[i])) files.insert(argv[i]);
        if (!std::filesystem::is_directory(argv[i])) continue;
        for (const auto& entry : std::filesystem::directory_iterator(argv[i]))
            if (entry.is_regular_file()) files.insert(entry.path());
    }
    for (const auto& file : files) {
        const std::string fault = fault_of(file);
        if (fault.empty()) continue;
        std::fprintf(stderr, "%s: %s\n", file.c_str(), fault.c_str());
        return 1;
    }
    std::printf("%zu files, %ld MiB at most\n", files.size(), peak_kib() >> 10);
    return files.empty() ? 1 : 0;
}
