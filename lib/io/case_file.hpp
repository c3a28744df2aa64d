#pragma once
/// The case as an HDF5 file image (schema: lib/io/README.md). What is written here reads back equal in every field,
/// and equal input gives equal bytes. Tested by io/case_file_test, io/damage_test.
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/provenance.hpp"
#include "model/case.hpp"

namespace soft::io {

/// The design a case was made from.
struct DesignText {
    std::string family;
    std::string effective_yaml;          ///< defaults and overrides in place
    std::vector<std::string> overrides;  ///< "geometry.wall=2.5mm", as given to --set

    friend bool operator==(const DesignText&, const DesignText&) = default;
};

struct CaseFile {
    model::Case model;
    DesignText design;
    std::vector<Provenance> provenance;  ///< in alphabetical order of the tools
};

/// The whole file as bytes, ready for a pipe or a core::AtomicFile. Throws Error (internal) for a case that
/// read_case would refuse: what leaves this program can be read by the next.
[[nodiscard]] std::vector<std::byte> write_case(const model::Case& model, const DesignText& design,
                                                const Provenance& provenance);

/// Reads a case, or the case within a result. Nothing in the image is trusted: type, shape, range, sense of every
/// value and the SHA-256 seal of the whole are checked before use; links out of the file are never followed.
/// `source` names the image in errors ("case.h5", "<stdin>").
/// Throws Error (bad_input), e.g.
///     case.h5:/mesh/facets/cavity[12]: cell 9000 does not exist; rebuild the case with mesh-gen
[[nodiscard]] CaseFile read_case_file(std::span<const std::byte> image, std::string_view source);
[[nodiscard]] model::Case read_case(std::span<const std::byte> image, std::string_view source);

}  // namespace soft::io
