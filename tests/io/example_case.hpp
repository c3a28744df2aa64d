#pragma once
/// Hand-written cases with two cells, and functions that modify HDF5 files.
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "../model/equal.hpp"
#include "core/error.hpp"
#include "io/case_file.hpp"
#include "io/handle.hpp"
#include "io/result_file.hpp"

namespace soft::io::test {

[[nodiscard]] model::Case section_case();           ///< two quad9, axisymmetric
[[nodiscard]] model::Case solid_case();             ///< two hex27; no cavity, incompressible
[[nodiscard]] model::Case dynamic_case();           ///< solid_case as a dynamic case
[[nodiscard]] model::Step moving_step(int number);  ///< a row of dynamic_case
[[nodiscard]] DesignText example_design();
[[nodiscard]] Provenance example_provenance(const std::string& tool);
[[nodiscard]] std::vector<std::byte> section_image();

/// The shape of an example, with every optional part.
[[nodiscard]] model::Shape shape_of(const model::Case& model);
[[nodiscard]] std::vector<std::byte> write_case(const model::Case& model, const DesignText& design,
                                                const Provenance& provenance);
/// These builders take mesh and shape from the file, and all else from `like`.
[[nodiscard]] model::CaseBuilder builder_of(const model::Case& like);
[[nodiscard]] CaseFile read_case_file(std::span<const std::byte> image, std::string_view source,
                                      const model::Case& like = section_case());
[[nodiscard]] Result read_result(std::vector<std::byte> image, std::string_view source,
                                 const model::Case& like = section_case());
[[nodiscard]] InterruptedSolve read_interrupted(std::span<const std::byte> image, std::string_view source,
                                                const model::Case& like = section_case());
/// Expects that the file contains mesh and shape of `model`.
void expect_stored(std::span<const std::byte> image, const model::Case& model);

[[nodiscard]] model::Step example_step(int number);
[[nodiscard]] std::vector<double> example_displacement(int number);  ///< of section_case
[[nodiscard]] std::vector<double> example_pressure(int number);
[[nodiscard]] model::PathEnd example_end();
[[nodiscard]] model::Checkpoint example_checkpoint(int rows);  ///< every member has a distinct value

using model::test::expect_all, model::test::expect_equal;
void expect_equal(const model::Step& left, const model::Step& right);
void expect_equal(const model::PathEnd& left, const model::PathEnd& right);
void expect_equal(const model::Checkpoint& left, const model::Checkpoint& right);

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A modification that makes a file inconsistent.
struct Corruption {
    const char* what;  ///< name of the test
    std::function<void(hid_t file)> change;
    const char* location;  ///< must occur in the message
};

/// The image after another program has applied `change`: a valid HDF5 file without seal.
[[nodiscard]] std::vector<std::byte> tampered(const std::vector<std::byte>& image,
                                              const std::function<void(hid_t file)>& change);
/// Replaces elements of a dataset, starting at the flat index `first`.
void overwrite(hid_t file, const char* dataset, std::size_t first, const std::vector<double>& values);
void overwrite(hid_t file, const char* dataset, std::size_t first, const std::vector<std::int64_t>& values);

/// The message of the Error (bad_input) that is thrown when the image is read as a case. Adds a test failure and returns "" if none is
/// thrown.
[[nodiscard]] std::string refusal(const std::vector<std::byte>& image, std::string_view source = "case.h5");

}  // namespace soft::io::test
