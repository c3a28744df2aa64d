#pragma once
/// How a program was run. One record per program, in /provenance/<tool>. Records contain no dates and no host names, because two
/// runs with the same input must give the same bytes.
#include <string>
#include <vector>

namespace soft::io {

struct Provenance {
    std::string tool;                    ///< "mesh-gen"; also the record's name in the file
    std::string version;                 ///< "0.1.0"
    std::string revision;                ///< git revision of the source
    std::vector<std::string> libraries;  ///< one entry per library: "HDF5 1.10.8"
    std::string command_line;            ///< as typed, with the name of the program without its path

    friend bool operator==(const Provenance&, const Provenance&) = default;
};

}  // namespace soft::io
