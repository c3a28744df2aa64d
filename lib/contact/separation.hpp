#pragma once
/// Pairs of facets that stay apart: a pair whose distance has been computed needs no other computation until it may have moved by as
/// much as this distance. Motions are seen from the first facet (its centre and axes), so that a pair that moves as a whole stays apart.
/// Private to the module. Tested by contact/potential_test.
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "contact/patch.hpp"

namespace soft::contact {

class Separations {
public:
    explicit Separations(std::size_t facets) : facets_(facets) {}

    /// Remembers that the points of facet i must approach facet j by `clearance_m` before they touch; not if it is 0 or less.
    void set(std::size_t i, std::size_t j, double clearance_m, std::span<const Patch> patches);
    /// A lower bound of this clearance in another configuration; 0 or less where nothing is known.
    [[nodiscard]] double clearance_m(std::size_t i, std::size_t j, std::span<const Patch> patches) const;

private:
    struct Pair {
        double clearance_m;
        std::vector<Vector3> nodes;  // of both facets, seen from i
    };
    [[nodiscard]] std::uint64_t key(std::size_t i, std::size_t j) const { return i * facets_ + j; }

    std::size_t facets_;
    std::unordered_map<std::uint64_t, Pair> pairs_;
};

}  // namespace soft::contact
