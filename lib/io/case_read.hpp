#pragma once
/// Reads the case from an open file. Internal to the module.
#include "io/case_file.hpp"
#include "io/hdf5_read.hpp"

namespace soft::io {

/// The contents of the file, checked except for the design.
struct StoredCase {
    mesh::Mesh mesh;
    model::Shape shape;
    DesignText design;
    std::vector<Provenance> provenance;
    std::vector<model::Variation> variations;
};
[[nodiscard]] StoredCase read_stored_case(const GroupReader& root);

/// Of the variations.
[[nodiscard]] std::vector<model::DesignParameter> parameters_of(std::span<const model::Variation> variations);

/// Effective YAML and overrides.
[[nodiscard]] DesignText read_design_text(const GroupReader& group);

/// Location of a design of the file, for errors in it: "case.h5:/design/effective_yaml".
[[nodiscard]] std::string design_location(const Origin& origin, std::string_view group);

}  // namespace soft::io
