#pragma once
/// Reads a file in a subprocess first. With damaged metadata, HDF5 (1.10.8) may crash, loop, or allocate unlimited memory. The seal
/// excludes this for files that these programs wrote. Files without a seal, which other programs wrote or changed, are first read
/// in a subprocess. Internal to the module. Tested by io/damage_test.
///     limits   memory 256 MiB + 64 times the file size; CPU time 10 s + 1 s per 10 MB; wall time ten times the CPU time
///     cost     reading twice, and the fork (a few ms)
#include <functional>

#include "io/hdf5_checks.hpp"

namespace soft::io {

/// Calls `read` in a subprocess, with an origin that records the location being read. Throws the Error that `read` throws. If the
/// subprocess crashes or exceeds its limits, throws Error (bad_input) with the recorded location and the reason.
void read_in_subprocess(const Origin& origin, const std::function<void(const Origin& noted)>& read);

}  // namespace soft::io
