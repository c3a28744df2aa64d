#include "view/skin.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "mesh/mesh.hpp"
#include "view/creases.hpp"
#include "view/patch.hpp"

namespace soft::view {

namespace {

using std::numbers::pi;
using Ids = std::vector<std::int32_t>;

constexpr int max_segments = 16;

bool is_section(const model::Case& model) { return model.mesh.dimension == 2; }
bool is_turned(const model::Case& model, const SkinOptions& options) {
    return model.kinematics == model::Kinematics::axisymmetric && options.extent != Extent::flat;
}

void check(const SkinOptions& options) {
    const auto refuse = [](const char* what, const char* range) { throw Error(ExitCode::usage, "skin", what, range); };
    if (options.segments < 1 || options.segments > max_segments) refuse("segments are out of range", "from 1 to 16");
    if (options.sectors < 3 || options.sectors > 3600) refuse("sectors are out of range", "from 3 to 3600");
    if (!(options.turn_rad > 0) || options.turn_rad > 2 * pi)
        refuse("the angle of revolution is out of range", "above 0, at most 360 degrees");
}

class Builder {
public:
    Builder(const model::Case& model, const post::RegionPoints& region_points, const SkinOptions& options)
        : model_(model),
          region_points_(region_points),
          options_(options),
          tolerance_m_(mesh::plane_tolerance * mesh::extent_m(model.mesh)) {
        skin_.first_source.push_back(0);
        make_placements();
    }

    Skin run() {
        if (is_turned(model_, options_)) {
            add_turned_edges();
            if (!closed_) add_cuts();
        } else if (is_section(model_)) {
            for (mesh::Index cell = 0; cell < model_.mesh.cell_count(); ++cell)
                add_images(mirrors_, bases_of_cell(cell));
        } else {
            for (const auto& [facet, mirrors] : visible_facets()) add_images(mirrors, bases_of(facet));
        }
        const auto undeformed = vertex_positions(skin_, base_positions(skin_, model_, region_points_, {}));
        skin_.creases = creases(skin_.faces, undeformed);
        return std::move(skin_);
    }

private:
    /// Pieces of a facet with their bases.
    struct Side {
        Ids bases;
        const Patch* patch;
    };

    /// Mirror planes of the whole actuator as bits: bit d is set if the plane with coordinate d = 0 is a mirror. The axis of a
    /// revolved section is not a mirror.
    [[nodiscard]] int planes() const {
        int bits = 0;
        for (int d = 0; d < 3; ++d) bits |= model_.symmetry_planes[static_cast<std::size_t>(d)] ? 1 << d : 0;
        if (is_section(model_)) bits &= ~4;
        if (model_.kinematics == model::Kinematics::axisymmetric) bits &= ~2;
        return bits;
    }

    /// Whether an image of the modelled part is shown.
    [[nodiscard]] bool is_shown(int mirrors) const {
        constexpr int across = 2 | 4;  // y and z
        const int all = planes();
        if ((mirrors & ~all) != 0) return false;
        const bool plane = model_.kinematics == model::Kinematics::plane_strain && options_.extent == Extent::opened;
        if (plane || options_.extent == Extent::modelled || options_.extent == Extent::flat) return mirrors == 0;
        return options_.extent == Extent::whole || (all & across) == 0 || (mirrors & across) != 0;
    }

    void make_placements() {
        closed_ = options_.extent == Extent::whole || options_.turn_rad > 2 * pi * (1 - 1e-9);
        const double turn = closed_ ? 2 * pi : options_.turn_rad;
        const bool turned = is_turned(model_, options_);
        steps_ = turned ? std::max(1, static_cast<int>(std::lround(options_.sectors * turn / (2 * pi)))) : 0;
        for (int mirrors = 0; mirrors < 8; ++mirrors) {
            if (is_shown(mirrors)) mirrors_.push_back(mirrors);
            // also for images that are not shown: vertices shared with a shown image may use their placements
            if ((mirrors & ~planes()) == 0) add_placements(mirrors, turned ? turn : 0.0);
        }
    }

    void add_placements(int mirrors, double turn) {
        const auto sign = [mirrors](int d) { return (mirrors >> d) & 1 ? -1.0 : 1.0; };
        first_placement_[static_cast<std::size_t>(mirrors)] = static_cast<std::int32_t>(skin_.placements.size());
        for (int k = 0; k <= steps_; ++k) {
            const double angle = turn * k / std::max(1, steps_) - turn, c = std::cos(angle), s = std::sin(angle);
            skin_.placements.push_back({sign(0), 0, 0, 0, c * sign(1), -s * sign(2), 0, s * sign(1), c * sign(2)});
        }
    }

    /// A boundary facet with the images in which it is visible: a facet on a symmetry plane is visible only if the image
    /// beyond that plane is not shown.
    struct VisibleFacet {
        mesh::Facet facet;
        std::vector<int> mirrors;
    };
    [[nodiscard]] std::vector<VisibleFacet> visible_facets() const {
        std::vector<VisibleFacet> list;
        for (const mesh::Facet& facet : mesh::boundary_facets(model_.mesh)) {
            const auto nodes = mesh::facet_nodes(model_.mesh, facet);
            VisibleFacet visible{facet, mirrors_};
            for (std::size_t d = 0; d < 3; ++d) {
                if (((planes() >> d) & 1) == 0) continue;
                const bool cut = std::ranges::all_of(
                    nodes, [&](mesh::Index node) { return std::abs(model_.mesh.point(node)[d]) <= tolerance_m_; });
                if (cut) std::erase_if(visible.mirrors, [&](int mirrors) { return is_shown(mirrors ^ (1 << d)); });
            }
            list.push_back(std::move(visible));
        }
        return list;
    }

    const Patch& patch_of(mesh::CellType type) {
        const auto found = patches_.find(type);
        return found != patches_.end() ? found->second
                                       : patches_.emplace(type, make_patch(type, options_.segments)).first->second;
    }

    Side side(mesh::CellType type, const Ids& points) {
        Side made{{}, &patch_of(type)};
        const std::size_t n = points.size();
        for (std::size_t q = 0; q * n < made.patch->N.size(); ++q)
            made.bases.push_back(base(points, {&made.patch->N[q * n], n}));
        return made;
    }

    Side bases_of(const mesh::Facet& facet) {
        const auto cell = region_points_.of_cell(model_.mesh, facet.cell);
        const auto& topology =
            mesh::topology(model_.mesh.cell_type(facet.cell)).facets[static_cast<std::size_t>(facet.local)];
        Ids points;
        for (int a = 0; a < mesh::node_count(topology.type); ++a)
            points.push_back(cell[static_cast<std::size_t>(topology.nodes[static_cast<std::size_t>(a)])]);
        return side(topology.type, points);
    }

    Side bases_of_cell(mesh::Index cell) {
        const auto points = region_points_.of_cell(model_.mesh, cell);
        return side(model_.mesh.cell_type(cell), {points.begin(), points.end()});
    }

    /// Equal weighted sums are one base: neighbouring facets give the points of a common edge the same weights.
    std::int32_t base(const Ids& points, std::span<const double> N) {
        constexpr double one = 1LL << 40;
        std::vector<std::pair<std::int32_t, std::int64_t>> key;
        for (std::size_t a = 0; a < points.size(); ++a)
            if (const auto weight = std::llround(N[a] * one); weight != 0) key.emplace_back(points[a], weight);
        std::ranges::sort(key);
        const auto [found, is_new] = bases_.emplace(std::move(key), static_cast<std::int32_t>(bases_.size()));
        if (!is_new) return found->second;
        for (const auto& [point, weight] : found->first) {
            skin_.sources.push_back(point);
            skin_.weights.push_back(static_cast<double>(weight) / one);
        }
        skin_.first_source.push_back(static_cast<std::int32_t>(skin_.sources.size()));
        return found->second;
    }

    /// Whether the undeformed base lies on the plane with coordinate d = 0.
    [[nodiscard]] bool lies_on(std::int32_t id, std::size_t d) const {
        const auto b = static_cast<std::size_t>(id);
        for (auto k = skin_.first_source[b]; k < skin_.first_source[b + 1]; ++k) {
            const auto source = static_cast<std::size_t>(skin_.sources[static_cast<std::size_t>(k)]);
            if (std::abs(model_.mesh.point(region_points_.node[source])[d]) > tolerance_m_) return false;
        }
        return true;
    }

    /// Points that are fixed under a placement share one vertex: on a mirror plane, on the axis, and at the seam of a full turn.
    std::int32_t vertex(std::int32_t id, int mirrors, int step) {
        for (std::size_t d = 0; d < 3; ++d)
            if (((mirrors >> d) & 1) && lies_on(id, d)) mirrors &= ~(1 << d);
        if (steps_ > 0 && lies_on(id, 1)) step = 0;
        if (closed_ && step == steps_) step = 0;
        const std::int32_t placement = first_placement_[static_cast<std::size_t>(mirrors)] + step;
        const auto [found, is_new] =
            vertices_.emplace(std::pair{id, placement}, static_cast<std::int32_t>(skin_.vertices.size()));
        if (is_new) skin_.vertices.push_back({id, placement});
        return found->second;
    }

    /// Moves collapsed corners to the end and drops faces with fewer than three corners.
    void add_face(Face face, bool turn_over) {
        if (turn_over) std::ranges::reverse(face);
        std::vector<std::int32_t> corners;
        for (std::size_t i = 0; i < 4; ++i)
            if (face[i] != face[(i + 1) % 4]) corners.push_back(face[i]);
        if (corners.size() < 3) return;
        corners.push_back(corners.back());
        skin_.faces.push_back({corners[0], corners[1], corners[2], corners[3]});
    }

    static bool reverses_orientation(int mirrors) { return (((mirrors >> 2) ^ (mirrors >> 1) ^ mirrors) & 1) != 0; }

    void add_side(const Side& side, int mirrors, int step, bool turn_over) {
        for (const auto& piece : side.patch->pieces) {
            Face face;
            for (std::size_t i = 0; i < 4; ++i)
                face[i] = vertex(side.bases[static_cast<std::size_t>(piece[i])], mirrors, step);
            add_face(face, turn_over != reverses_orientation(mirrors));
        }
    }

    void add_images(const std::vector<int>& images, const Side& side) {
        for (const int mirrors : images) add_side(side, mirrors, 0, false);
    }

    void add_turned_edges() {
        for (const auto& [facet, images] : visible_facets()) {
            const Side edge = bases_of(facet);
            for (const int mirrors : images)
                for (const auto& piece : edge.patch->pieces)
                    for (int k = 0; k < steps_; ++k) {
                        const auto a = edge.bases[static_cast<std::size_t>(piece[0])];
                        const auto b = edge.bases[static_cast<std::size_t>(piece[1])];
                        add_face({vertex(a, mirrors, k), vertex(b, mirrors, k), vertex(b, mirrors, k + 1),
                                  vertex(a, mirrors, k + 1)},
                                 reverses_orientation(mirrors));
                    }
        }
    }

    void add_cuts() {
        for (mesh::Index cell = 0; cell < model_.mesh.cell_count(); ++cell) {
            const Side section = bases_of_cell(cell);
            for (const int mirrors : mirrors_) {
                add_side(section, mirrors, 0, true);
                add_side(section, mirrors, steps_, false);
            }
        }
    }

    const model::Case& model_;
    const post::RegionPoints& region_points_;
    const SkinOptions& options_;
    double tolerance_m_;
    bool closed_ = false;
    int steps_ = 0;             ///< angular steps of the revolution
    std::vector<int> mirrors_;  ///< images shown; bit d: mirrored at the plane with coordinate d = 0
    std::array<std::int32_t, 8> first_placement_{};
    std::map<mesh::CellType, Patch> patches_;
    std::map<std::vector<std::pair<std::int32_t, std::int64_t>>, std::int32_t> bases_;
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> vertices_;
    Skin skin_;
};

}  // namespace

Skin make_skin(const model::Case& model, const post::RegionPoints& region_points, const SkinOptions& options) {
    check(options);
    return Builder(model, region_points, options).run();
}

}  // namespace soft::view
