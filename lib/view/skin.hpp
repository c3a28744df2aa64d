#pragma once
/// The surface of the body as flat polygons, made once for a case and moved through the steps: what pictures, the
/// report and the eye need.
///
/// Two levels. Bases: places on the modelled body's surface, each a sum over region points (fields/region_points.hpp)
/// with shape functions as weights; their positions and values change with the step. Vertices: a base put into space by
/// one of a few linear maps (`placements`): the identity, mirrors, turns about the x axis. So a step costs one small
/// array of bases.
///     base   x_b = sum_k weight_k (X + u)_k                       (x, y, z), of a section (x, r, 0)
///     vertex x_v = A_placement(v) x_base(v)
/// Second-order sides are divided into `segments` pieces along each edge by their own shape functions, so curved sides
/// stay smooth (the chords stray from the curve by 1/segments^2 of its rise). Neighbours share bases: the surface has
/// no cracks within a region. Lengths in m. Tested by view/skin_test.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "fields/region_points.hpp"
#include "model/case.hpp"

namespace soft::view {

using mesh::Point;

/// opened: one sees inside. A section is turned by `turn_rad` and leaves a gap between +y and +z, a solid is mirrored
///   at its symmetry planes y = 0 and z = 0 but leaves out the side where both are positive; both are mirrored at
///   x = 0. A section of plane strain: as modelled.
/// whole: a section turned all round, a solid mirrored at all its symmetry planes.
/// modelled: the part that is in the mesh; a section is turned by `turn_rad`.
/// flat: a section as it is, in its own plane (a solid: as modelled).
enum class Extent { opened, whole, modelled, flat };

struct SkinOptions {
    Extent extent = Extent::modelled;
    double turn_rad = 4.71238898038469;  ///< 270 degrees: how far a section is turned unless it is whole
    int segments = 4;                    ///< of a second-order edge (1 to 16); a first-order edge has one
    int sectors = 72;                    ///< of a full turn (at least 3)
};

using Face =
    std::array<std::int32_t, 4>;  ///< vertices, counter-clockwise seen from outside; a triangle repeats its last

struct Skin {
    std::vector<std::int32_t> first_source;  ///< base b is the sum over sources first_source[b] .. first_source[b + 1]
    std::vector<std::int32_t> sources;       ///< region points
    std::vector<double> weights;

    struct Vertex {
        std::int32_t base, placement;
    };
    std::vector<Vertex> vertices;
    std::vector<std::array<double, 9>> placements;  ///< row by row; proper and improper
    std::vector<Face> faces;
    std::vector<std::array<std::int32_t, 2>>
        creases;  ///< vertices: edges sharp in the undeformed body, rims of cuts and of
                  ///< regions; the undeformed outline is drawn with them

    [[nodiscard]] std::size_t base_count() const noexcept { return first_source.size() - 1; }
};

/// Throws Error(usage) for options out of range.
[[nodiscard]] Skin make_skin(const model::Case& model, const fields::RegionPoints& places, const SkinOptions& options);

/// Positions of the bases. `displacement_m` [point, 3]; empty: the undeformed body.
[[nodiscard]] std::vector<Point> base_positions(const Skin& skin, const model::Case& model,
                                                const fields::RegionPoints& places,
                                                std::span<const double> displacement_m);
/// A field over the region points at the bases.
[[nodiscard]] std::vector<double> base_values(const Skin& skin, std::span<const double> nodal);

/// Bases put into space: one position a vertex.
[[nodiscard]] std::vector<Point> vertex_positions(const Skin& skin, std::span<const Point> bases);

/// The faces as triangles (quadrilaterals cut along their first diagonal), none of them degenerate in vertices.
[[nodiscard]] std::vector<std::array<std::int32_t, 3>> triangles(const Skin& skin);

}  // namespace soft::view
