#pragma once
/// Which facets may act on each other: those whose boxes meet, without two sides of one wall and without neighbours that are visible
/// from one side. The boxes are larger than the facets, so that the search is repeated only after motions of a fraction of a facet.
/// Private to the module. Tested by contact/potential_test.
#include <vector>

#include "contact/contact_surface.hpp"

namespace soft::contact {

class Candidates {
public:
    /// `surface` must outlive this object. `self`: whether facets of the actuator act on each other, not only those of obstacles.
    Candidates(ContactSurface& surface, bool self);

    /// By free facet: the entries of the surface that may touch it on the way between two configurations (patches of all entries),
    /// ascending; neighbours by their normals at the first.
    [[nodiscard]] std::vector<std::vector<std::size_t>> between(std::span<const Patch> from, std::span<const Patch> to);

private:
    struct Pair {
        std::size_t first, second;
        bool may_fold;  // neighbours
    };
    [[nodiscard]] std::vector<Pair> search(std::span<const Patch> from, std::span<const Patch> to) const;
    [[nodiscard]] bool has_moved(std::span<const Patch> patches) const;

    ContactSurface& surface_;
    bool self_;
    double reach_m_;                // of motions that need no new search
    std::vector<Patch> reference_;  // of the last search
    std::vector<Pair> pairs_;
};

}  // namespace soft::contact
