#pragma once
/// Designs drawn at random over all families of the catalogue, all laws and all kinds of load, whose loads go far beyond
/// what most bodies bear: their paths run to their limit. Each fourth is a motion or a tiny load instead, whose answer is known. Tested by Pipeline.ACampaignConfirmsWhyPathsEnd.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "design/design.hpp"

namespace soft::campaign {

/// `index` within a campaign of this seed; each draw depends on these two alone.
struct Number {
    std::uint32_t seed = 0;
    int index = 0;
};

struct Drawn {
    std::string family, law, load;  ///< "tube", "yeoh", "cavity pressure"
    std::string design_yaml;        ///< effective; a section's table by its name below the folder of designs
    std::string table;              ///< name of that table; empty without
    std::string table_text;
    int refused = 0;  ///< attempts before this one that the parser or the mesher has refused, or that were too large
};

/// A design that mesh-gen accepts and whose mesh is small enough for a campaign. `folder`: where the designs, and tables
/// beside them, are written. std::runtime_error after a hundred attempts.
[[nodiscard]] Drawn draw(const Number& number, const std::filesystem::path& folder);

}  // namespace soft::campaign
