#pragma once
/// Reads and writes provenance records. Internal to the module.
#include <vector>

#include "io/hdf5_read.hpp"
#include "io/provenance.hpp"

namespace soft::io {

/// Adds the record to the group /provenance.
void write_provenance(hid_t provenance_group, const Provenance& provenance);
[[nodiscard]] std::vector<Provenance> read_provenance(const GroupReader& root);

}  // namespace soft::io
