#pragma once
/// Reading on trial. HDF5 (1.10.8) crashes, loops or asks for any amount of memory on damaged metadata. Our own files carry
/// a seal, so that it never sees such; files without one, which other programs wrote or changed, are read in a process of its
/// own first, which may come to harm. Internal to the module. Tested by io/damage_test.
///     bounds   memory 256 MiB + 64 times the file; 10 s of computing + 1 s for each 10 MB; ten times that on the clock
///     cost     a second reading, and the fork (a few ms)
#include <functional>

#include "io/hdf5_checks.hpp"

namespace soft::io {

/// Runs `read` there, with an origin that notes how far it comes. Returns where that went well; throws the Error that `read`
/// has thrown, or Error (bad_input) "case.h5:/mesh/points: HDF5 cannot read on from here: it crashes (Segmentation fault); ...".
void try_apart(const Origin& origin, const std::function<void(const Origin& noted)>& read);

}  // namespace soft::io
