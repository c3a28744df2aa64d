/// Fuzz target: HDF5 files as bytes. Nearly all inputs lack a seal and are therefore first read in a subprocess.
#include "geometry/build.hpp"
#include "io/case_file.hpp"
#include "io/result_file.hpp"
#include "target.hpp"

void soft::fuzz::read(std::span<const std::byte> bytes) {
    even_so([&] {
        const io::Result result =
            io::read_result(std::vector<std::byte>{bytes.begin(), bytes.end()}, "fuzz.h5", geometry::rebuild_case);
        for (const std::int64_t step : result.fields.steps()) static_cast<void>(result.fields.read(step));
    });
    static_cast<void>(io::read_case_file(bytes, "fuzz.h5", geometry::rebuild_case));
}
