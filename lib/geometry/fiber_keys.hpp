#pragma once
/// Keys of the fibres in a part of a body, below a prefix such as "geometry.fibers": angle, families, k1, k2
/// (material/fibers.hpp). Tested by geometry/fiber_tube_test and geometry/segment_test.
#include <string>
#include <vector>

#include "design/design.hpp"
#include "model/case.hpp"

namespace soft::geometry {

struct FiberDefaults {
    std::string angle, angle_meaning;
    std::string k1;  ///< "0 MPa": no fibres unless the design states k1
};
[[nodiscard]] std::vector<design::Key> fiber_keys(const std::string& prefix, const FiberDefaults& defaults);

/// k1 = 0 means no fibres.
[[nodiscard]] model::Fibers fibers_of(const design::Values& values, const std::string& prefix);

}  // namespace soft::geometry
