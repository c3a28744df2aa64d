#pragma once
/// Contact acts per undeformed area, which adds no tension to the surface, until the area has grown fourfold; then per deformed area, as
/// otherwise walls at large stretch would press through. The factor of the undeformed area is
///   psi(J) = 1 + u^3/(1 + u^2),   u = J/J_0 - 1 where that is positive, else 0;   J_0 = 4,
/// with two continuous derivatives, and J the deformed over the undeformed area at a sample point, the circumference of a body of revolution
/// included:  J = |t1 x t2| / |T1 x T2|,  in a body of revolution times r/R.
/// Derived here. Private to the module. Tested by contact/potential_test.
#include <vector>

#include "contact/block.hpp"
#include "contact/contact_surface.hpp"

namespace soft::contact {

/// Deformed over undeformed area of a facet at xi.
[[nodiscard]] double area_stretch(const Patch& undeformed, const Patch& now, const surface::FacetPoint& xi,
                                  bool is_revolved);

struct AreaFactor {
    double value = 1, by_stretch = 0, second_by_stretch = 0;
};
[[nodiscard]] AreaFactor area_factor(double stretch);

/// psi with its derivatives by the positions of the facet's nodes.
struct AreaStretch {
    double stretch = 1, factor = 1;  ///< J, psi
    std::vector<double> gradient;    ///< [1/m] [component][node]; empty where the factor is constant
    std::vector<double> hessian;     ///< [1/m^2] square, row-major; empty if not wanted
};

/// `now`: the facet of `entry`.
[[nodiscard]] AreaStretch area_stretch(const ContactSurface::Entry& entry, const Patch& now, std::size_t q,
                                       const ContactSurface& surface, Wanted wanted);

/// Adds to a block what an energy has in derivatives because it is in proportion to psi: E = psi e(r), r = sum over points of weight x
/// position, where psi dE/dr at fixed psi has been added already. `g`: the gradient of e by r. The nodes of psi are the first of the block.
void add_area_stretch(Block& block, const AreaStretch& stretch, double e, const Vector3& g,
                      std::span<const double> weights);

/// Adds to the Hessian the derivative by psi of a force in proportion to psi, which has been added with the same weights.
void add_area_stretch(Block& block, const AreaStretch& stretch, const Vector3& force, std::span<const double> weights);

}  // namespace soft::contact
