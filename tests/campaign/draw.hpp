#pragma once
/// Random designs over all families of the catalogue, all laws and all kinds of load. The loads exceed the limit load of most designs.
/// Every fourth design has a prescribed motion or a tiny load instead, with a known response. Of the others a third has rigid obstacles
/// close to it, some with friction.
/// Tested by Pipeline.CampaignConfirmsTheStopReasons.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "design/design.hpp"

namespace soft::campaign {

/// Number `index` of the campaign with this seed; a design depends on these two only.
struct DesignIndex {
    std::uint32_t seed = 0;
    int index = 0;
};

struct Drawn {
    std::string family, law, load;  ///< "tube", "yeoh", "cavity pressure"
    std::string
        design_yaml;    ///< effective design; refers to the table of a section by its name in the folder of designs
    std::string table;  ///< name of that table; empty if none
    std::string table_text;
    int refused = 0;  ///< previous attempts that the parser or the mesher rejected, or that were too large
};

/// A design that mesh-gen accepts and whose mesh is small enough for a campaign. `folder` receives the designs and their tables. Throws
/// std::runtime_error after a hundred attempts.
[[nodiscard]] Drawn draw(const DesignIndex& number, const std::filesystem::path& folder);

}  // namespace soft::campaign
