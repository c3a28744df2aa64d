#pragma once
/// Checks of the deformed mesh: self-contact and nearly inverted cells. Simple and slow, for tests; independent of the solver's contact
/// search. Tested by campaign/shape_checks_test, Pipeline.CampaignConfirmsTheStopReasons.
#include <array>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "creases.hpp"
#include "model/case.hpp"

namespace soft::campaign {

class ShapeChecks {
public:
    explicit ShapeChecks(const model::Case& model);

    /// "walls intersect", "a crease closes", "a wall crosses a symmetry plane"; empty without contact.
    /// `u`: displacements [point x 3]; `before`: those of the previous row. Walls that overlap by at most `allowed_m`, or
    /// reach as far beyond a symmetry plane, do not intersect.
    [[nodiscard]] std::string contact(std::span<const double> u, std::span<const double> before,
                                      double allowed_m = 0) const;
    /// Smallest det F at corners, mid nodes and centres of the cells.
    [[nodiscard]] double min_det_F(std::span<const double> u) const;
    /// Of the points of the free facets: how far the deepest is inside an obstacle that has not moved, and its name. Faceted obstacles are
    /// not considered.
    struct Depth {
        double depth_m = 0;
        std::string obstacle;
    };
    [[nodiscard]] Depth deepest_in_obstacle(std::span<const double> u) const;
    /// The largest of the model.
    [[nodiscard]] double contact_distance_m() const;
    /// Longest side of the bounding box of the undeformed model.
    [[nodiscard]] double extent_m() const { return extent_m_; }

private:
    using Pairs = std::set<std::array<int, 3>>;  // division of the facets, and two pieces
    [[nodiscard]] mesh::Mesh moved(std::span<const double> u) const;
    [[nodiscard]] Pairs intersecting_pairs(const mesh::Mesh& mesh, double allowed_m) const;
    [[nodiscard]] bool crosses_symmetry_plane(const mesh::Mesh& mesh, double allowed_m) const;

    const model::Case& model_;
    std::vector<mesh::Facet> skin_;
    Creases creases_;
    Pairs initial_pairs_;  ///< pairs that intersect in the undeformed model
    double extent_m_ = 0;
};

}  // namespace soft::campaign
