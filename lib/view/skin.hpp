#pragma once
/// The surface of the body as flat polygons, built once per case and moved through the steps, for pictures and reports.
///
/// Two levels. Bases: points on the surface of the modelled part, each a sum over region points (post/region_points.hpp)
/// with shape functions as weights; their positions and values change with the step. Vertices: a base mapped into space by
/// one of a few linear maps (`placements`): the identity, reflections, rotations about the x axis. A step therefore needs only
/// one small array of bases.
///     base   x_b = sum_k weight_k (X + u)_k                       (x, y, z), of a section (x, r, 0)
///     vertex x_v = A_placement(v) x_base(v)
/// Second-order facets are divided into `segments` pieces along each edge by their own shape functions, so curved facets
/// stay smooth (the deviation of the chords is 1/segments^2 of the sagitta). Neighbours share bases, so the surface has
/// no gaps within a region. Lengths in m. Tested by view/skin_test.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "model/case.hpp"
#include "post/region_points.hpp"

namespace soft::view {

using mesh::Point;

/// opened: cut open to show the inside. A section is revolved by `turn_rad` and leaves a gap between +y and +z; a solid is mirrored
///   at its symmetry planes y = 0 and z = 0 but omits the image where both are positive; both are mirrored at
///   x = 0. A section of plane strain is shown as modelled.
/// whole: a section revolved by a full turn, a solid mirrored at all its symmetry planes.
/// modelled: the part that is in the mesh; a section is revolved by `turn_rad`.
/// flat: a section in its own plane (a solid as modelled).
enum class Extent { opened, whole, modelled, flat };

struct SkinOptions {
    Extent extent = Extent::modelled;
    double turn_rad = 4.71238898038469;  ///< 270 degrees: angle of revolution of a section unless it is whole
    int segments = 4;                    ///< per second-order edge (1 to 16); a first-order edge has one
    int sectors = 72;                    ///< per full turn (at least 3)
};

/// Vertices, counter-clockwise seen from outside; a triangle repeats its last.
using Face = std::array<std::int32_t, 4>;

struct Skin {
    std::vector<std::int32_t> first_source;  ///< base b is the sum over sources first_source[b] .. first_source[b + 1]
    std::vector<std::int32_t> sources;       ///< region points
    std::vector<double> weights;

    struct Vertex {
        std::int32_t base, placement;
    };
    std::vector<Vertex> vertices;
    std::vector<std::array<double, 9>> placements;  ///< row-major; rotations and reflections
    std::vector<Face> faces;
    /// Pairs of vertices: edges that are sharp in the undeformed body, boundaries of cuts and of regions; also used for the undeformed
    /// outline.
    std::vector<std::array<std::int32_t, 2>> creases;

    [[nodiscard]] std::size_t base_count() const noexcept { return first_source.size() - 1; }
};

/// Throws Error(usage) for options out of range.
[[nodiscard]] Skin make_skin(const model::Case& model, const post::RegionPoints& region_points,
                             const SkinOptions& options);

/// Positions of the bases. `displacement_m` [point, 3]; empty: the undeformed body.
[[nodiscard]] std::vector<Point> base_positions(const Skin& skin, const model::Case& model,
                                                const post::RegionPoints& region_points,
                                                std::span<const double> displacement_m);
/// A field over the region points at the bases; one that is nowhere negative stays so between the nodes.
[[nodiscard]] std::vector<double> base_values(const Skin& skin, std::span<const double> nodal);

/// Applies the placements to the bases: one position per vertex.
[[nodiscard]] std::vector<Point> vertex_positions(const Skin& skin, std::span<const Point> bases);

/// The faces as triangles (quadrilaterals are split along their first diagonal); no triangle repeats a vertex.
[[nodiscard]] std::vector<std::array<std::int32_t, 3>> triangles(const Skin& skin);

}  // namespace soft::view
