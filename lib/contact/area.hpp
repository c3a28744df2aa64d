#pragma once
/// Deformed over undeformed area at a sample point of a facet, the circumference of a body of revolution included, with its first and second
/// derivatives by the positions of the facet's nodes:
///   J = |t1 x t2| / |T1 x T2|,   in a body of revolution times r/R.
/// Derived here. Private to the module. Tested by contact/potential_test.
#include <vector>

#include "contact/contact_surface.hpp"

namespace soft::contact {

struct AreaStretch {
    double value = 1;
    std::vector<double> gradient;  ///< [1/m] [component][node]
    std::vector<double> hessian;   ///< [1/m^2] square, row-major; empty if not wanted
};

/// `now`: the facet of `entry`. On the axis of a body of revolution, where sample points have no area: 1, without derivatives.
[[nodiscard]] AreaStretch area_stretch(const ContactSurface::Entry& entry, const Patch& now, std::size_t q,
                                       const ContactSurface& surface, Wanted wanted);

/// Adds to a block what an energy has in derivatives because it is in proportion to J: E = J e(r), r = sum over points of weight x position,
/// where J dE/dr at fixed J has been added already. `g`: the gradient of e by r. The nodes of J are the first of the block.
void add_area_stretch(Block& block, const AreaStretch& stretch, double e, const Vector3& g,
                      std::span<const double> weights);

/// Adds to the Hessian the derivative by J of a force in proportion to J, which has been added with the same weights.
void add_area_stretch(Block& block, const AreaStretch& stretch, const Vector3& force, std::span<const double> weights);

}  // namespace soft::contact
