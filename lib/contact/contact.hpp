#pragma once
/// Detects contact between walls of the deformed body. The equilibrium has no contact constraint, so walls can pass through each
/// other. A contact is one of
///   two facets of the surface whose deformed shapes intersect,
///   a closed crease: the angle filled by the rubber around the edge between two facets exceeds a full turn,
///   a facet that crosses a symmetry plane (it touches its mirror image) or, in a section of revolution, the axis,
///   where contact is solved, a facet with a point inside an obstacle.
/// The surface is defined in surface/free_facets.hpp. Intersections are tested on the subdivided facets (contact/divided.hpp), planes
/// and creases on the curved facets. Pairs that intersect or touch in the undeformed body are excluded. For neighbouring facets,
/// pieces that share a point are not compared. A body that lies completely inside another one is not detected.
/// If the two sides of one wall intersect, or a facet and a plane with rubber and not air between them, the cells between them are
/// inverted: this is reported as `is_inverted`, not as contact, and later states are not physical.
/// Where contact is solved (path.contact), walls that overlap by less than the contact distance are not reported, nor are closed creases,
/// but a facet beyond a symmetry plane is where a cell next to it is inverted: what limits its overlap is not resolved.
/// Cost: 0.2 ms for a section of 300 facets, about 30 ms for a solid of 5000 facets, three times that if many boxes overlap.
/// Tested by contact/contact_test and contact/no_contact_test.
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "mesh/mesh.hpp"
#include "model/case.hpp"

namespace soft::contact {

struct Contact {
    mesh::Point location;  ///< undeformed, model coordinates, on the first facet
    std::array<mesh::Facet, 2>
        facets;                ///< ascending; twice the same facet for contact with a plane, the axis or an obstacle
    bool is_inverted = false;  ///< not a contact: the wall has passed through itself
    bool is_driven = false;    ///< into an obstacle by its prescribed displacement
    std::string text;          ///< "the faces cavity and outer touch at x = 12.3 mm, r = 4.5 mm of the undeformed part"
};

class ContactFinder {
public:
    /// Copies what it needs from the case.
    explicit ContactFinder(const model::Case& model);
    ~ContactFinder();
    ContactFinder(ContactFinder&&) noexcept;
    ContactFinder& operator=(ContactFinder&&) noexcept;

    /// The contact with the smallest x of its location (then the smallest facets); nullopt if there is none. `displacement_m`:
    /// [point x 3] as in the result file, finite. `shifts`: displacement of each obstacle; empty: none has moved. std::logic_error if a
    /// length is wrong.
    [[nodiscard]] std::optional<Contact> find(std::span<const double> displacement_m,
                                              std::span<const Vector3> shifts = {}) const;

private:
    class Surface;
    std::unique_ptr<const Surface> surface_;
};

}  // namespace soft::contact
