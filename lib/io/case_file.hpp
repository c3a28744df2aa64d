#pragma once
/// The case as an HDF5 file image (format: lib/io/README.md): mesh, shape and effective design. Reading gives the same values as
/// were written, and equal input gives equal bytes. Tested by io/case_file_test, io/damage_test.
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/provenance.hpp"
#include "model/shape.hpp"

namespace soft::io {

/// The design from which a case was generated.
struct DesignText {
    std::string effective_yaml;          ///< the design with defaults and overrides applied
    std::vector<std::string> overrides;  ///< "geometry.wall=2.5mm", as given to --set

    friend bool operator==(const DesignText&, const DesignText&) = default;
};

struct CaseFile {
    model::Case model;  ///< rebuilt from mesh, shape and design
    DesignText design;
    std::vector<Provenance> provenance;  ///< in alphabetical order of the tools
    /// The cases with the lower and the higher value of each of model.parameters.
    std::vector<std::array<model::Case, 2>> variations = {};
};

/// The complete file as bytes, for a pipe or a core::AtomicFile. Throws Error (internal) for a mesh or a shape that read_case_file
/// would reject, so the next program can read every file that is written.
[[nodiscard]] std::vector<std::byte> write_case(const mesh::Mesh& mesh, const model::Shape& shape,
                                                const DesignText& design, const Provenance& provenance,
                                                std::span<const model::Variation> variations = {});

/// Reads a case, or the case contained in a result, and lets `build` build the model. The image is untrusted: the SHA-256 seal and the
/// type, shape, range and consistency of every value are checked before use, the design by `build`; links to other files are never
/// followed. `source` names the image in errors ("case.h5", "<stdin>").
/// Throws Error (bad_input), e.g.
///     case.h5:/mesh/facets/cavity[12]: cell 9000 does not exist; rebuild the case with mesh-gen
///     case.h5:/design/effective_yaml:4:9: material.mu: -1 kPa is out of range; it must be more than 0
[[nodiscard]] CaseFile read_case_file(std::span<const std::byte> image, std::string_view source,
                                      const model::CaseBuilder& build);

}  // namespace soft::io
