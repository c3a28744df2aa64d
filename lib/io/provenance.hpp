#pragma once
/// How a stage was run. One record a stage, under /provenance/<tool>. No times of day and no host names: two runs of
/// the same input must give the same bytes.
#include <string>
#include <vector>

namespace soft::io {

struct Provenance {
    std::string tool;                    ///< "mesh-gen"; also the record's name in the file
    std::string version;                 ///< "0.1.0"
    std::string revision;                ///< git revision of the source
    std::vector<std::string> libraries;  ///< "HDF5 1.10.8", one each
    std::string command_line;            ///< as typed, program by its bare name

    friend bool operator==(const Provenance&, const Provenance&) = default;
};

}  // namespace soft::io
