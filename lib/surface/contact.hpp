#pragma once
/// Where do walls of the deformed body touch? Nothing in the equilibrium keeps them from passing through each other; this
/// finds that they have. A contact is
///   two facets of the surface whose deformed shapes cross,
///   a crease that has closed: the rubber around the edge between two facets fills more than a full turn,
///   a facet that passes a symmetry plane (it meets its mirror image) or, in a section of revolution, the axis.
/// The surface is what surface/free_facets.hpp says; facets are taken as their pieces (surface/divided.hpp), the planes and
/// creases on the curved facets. What crosses or touches in the undeformed body already is left out, pair by pair. Of
/// neighbouring facets, the pieces that have a point in common are not compared. A body wholly inside another is not found.
/// Where the two sides of one wall cross, its cells are inside out: nothing touches, and no state beyond is one of the body. Where
/// a cell is inside out at a plane, so that rubber and not air is between, nothing is said; det F tells.
/// A section of 300 facets takes 0.2 ms, a solid of 5000 some 30 ms, three times that where much overlaps.
/// Tested by surface/contact_test and surface/no_contact_test.
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "mesh/mesh.hpp"
#include "model/case.hpp"

namespace soft::surface {

struct Contact {
    mesh::Point place;                  ///< undeformed, model coordinates, on the first facet
    std::array<mesh::Facet, 2> facets;  ///< ascending; twice the same one where it meets a plane or the axis
    bool inside_out = false;            ///< no walls touch: the one between the facets has passed through itself
    std::string text;  ///< "the faces cavity and outer touch at x = 12.3 mm, r = 4.5 mm of the undeformed part"
};

class ContactFinder {
public:
    /// Keeps what it needs of the case.
    explicit ContactFinder(const model::Case& model);
    ~ContactFinder();
    ContactFinder(ContactFinder&&) noexcept;
    ContactFinder& operator=(ContactFinder&&) noexcept;

    /// The contact whose place has the least x (then the least facets); nullopt without one. `displacement_m`: [point x 3]
    /// as in the result file, finite. std::logic_error for another length.
    [[nodiscard]] std::optional<Contact> find(std::span<const double> displacement_m) const;

private:
    class Surface;
    std::unique_ptr<const Surface> surface_;
};

}  // namespace soft::surface
