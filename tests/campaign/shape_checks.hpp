#pragma once
/// What the deformed mesh of a case shows by itself: walls that meet, cells that are flattened. Plain and slow; made for
/// tests, of other parts than the solver's own search. Tested by campaign/shape_checks_test,
/// Pipeline.ACampaignConfirmsWhyPathsEnd.
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

    /// "walls meet", "a crease closes", "a wall passes a mirror"; empty where nothing does. `u`: [point x 3]; `before`: of the
    /// row before.
    [[nodiscard]] std::string contact(std::span<const double> u, std::span<const double> before) const;
    /// At corners, mid nodes and centres of the cells.
    [[nodiscard]] double min_det_F(std::span<const double> u) const;
    /// Longest side of the undeformed body's box.
    [[nodiscard]] double extent_m() const { return extent_m_; }

private:
    using Pairs = std::set<std::array<int, 2>>;
    [[nodiscard]] mesh::Mesh moved(std::span<const double> u) const;
    [[nodiscard]] Pairs meeting(const mesh::Mesh& mesh) const;
    [[nodiscard]] bool passes_a_mirror(const mesh::Mesh& mesh) const;

    const model::Case& model_;
    std::vector<mesh::Facet> skin_;
    Creases creases_;
    Pairs from_the_start_;  ///< that meet in the undeformed body
    double extent_m_ = 0;
};

}  // namespace soft::campaign
