#include "view/skin.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "model/cavity_surface.hpp"
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
        refuse("the turn is out of range", "above 0, at most 360 degrees");
}

class Builder {
public:
    Builder(const model::Case& model, const fields::RegionPoints& places, const SkinOptions& options)
        : model_(model),
          places_(places),
          options_(options),
          tolerance_m_(model::plane_tolerance * model::extent_m(model.mesh)) {
        skin_.first_source.push_back(0);
        make_placements();
    }

    Skin run() {
        if (is_turned(model_, options_)) {
            add_turned_edges();
            if (!closed_) add_cuts();
        } else if (is_section(model_)) {
            for (mesh::Index cell = 0; cell < model_.mesh.cell_count(); ++cell) location_in(mirrors_, bases_of_cell(cell));
        } else {
            for (const auto& [facet, mirrors] : seen_facets()) location_in(mirrors, bases_of(facet));
        }
        const auto undeformed = vertex_positions(skin_, base_positions(skin_, model_, places_, {}));
        skin_.creases = creases(skin_.faces, undeformed);
        return std::move(skin_);
    }

private:
    /// Pieces of a side with their bases.
    struct Side {
        Ids bases;
        const Patch* patch;
    };

    /// Mirrors of the whole actuator as bits: d where it is one at the plane with zero coordinate d. The axis of a
    /// turned section is none.
    [[nodiscard]] int planes() const {
        int bits = 0;
        for (int d = 0; d < 3; ++d) bits |= model_.symmetry_planes[static_cast<std::size_t>(d)] ? 1 << d : 0;
        if (is_section(model_)) bits &= ~4;
        if (model_.kinematics == model::Kinematics::axisymmetric) bits &= ~2;
        return bits;
    }

    /// Which images of the modelled part are shown.
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
            // also where the image is not shown: what it shares with one that is stands under its name
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

    /// Sides of the boundary with the images in which they are seen: a cut at a symmetry plane only where the image
    /// beyond it is not shown.
    struct Seen {
        mesh::Facet facet;
        std::vector<int> mirrors;
    };
    [[nodiscard]] std::vector<Seen> seen_facets() const {
        std::vector<Seen> list;
        for (const mesh::Facet& facet : mesh::boundary_facets(model_.mesh)) {
            const auto nodes = mesh::facet_nodes(model_.mesh, facet);
            Seen seen{facet, mirrors_};
            for (std::size_t d = 0; d < 3; ++d) {
                if (((planes() >> d) & 1) == 0) continue;
                const bool cut = std::ranges::all_of(
                    nodes, [&](mesh::Index node) { return std::abs(model_.mesh.point(node)[d]) <= tolerance_m_; });
                if (cut) std::erase_if(seen.mirrors, [&](int mirrors) { return is_shown(mirrors ^ (1 << d)); });
            }
            list.push_back(std::move(seen));
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
        const auto cell = places_.of_cell(model_.mesh, facet.cell);
        const auto& topology =
            mesh::topology(model_.mesh.cell_type(facet.cell)).facets[static_cast<std::size_t>(facet.local)];
        Ids points;
        for (int a = 0; a < mesh::node_count(topology.type); ++a)
            points.push_back(cell[static_cast<std::size_t>(topology.nodes[static_cast<std::size_t>(a)])]);
        return side(topology.type, points);
    }

    Side bases_of_cell(mesh::Index cell) {
        const auto points = places_.of_cell(model_.mesh, cell);
        return side(model_.mesh.cell_type(cell), {points.begin(), points.end()});
    }

    /// Equal sums are one base: neighbouring sides give an edge's points the same weights.
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

    /// Whether the undeformed base lies on the plane with zero coordinate d.
    [[nodiscard]] bool lies_on(std::int32_t id, std::size_t d) const {
        const auto b = static_cast<std::size_t>(id);
        for (auto k = skin_.first_source[b]; k < skin_.first_source[b + 1]; ++k) {
            const auto source = static_cast<std::size_t>(skin_.sources[static_cast<std::size_t>(k)]);
            if (std::abs(model_.mesh.point(places_.node[source])[d]) > tolerance_m_) return false;
        }
        return true;
    }

    /// What a map leaves where it is has one vertex: on a mirror, on the axis, where a full turn closes.
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

    /// Collapsed corners go to the end; what has no area goes away.
    void add_face(Face face, bool turn_over) {
        if (turn_over) std::ranges::reverse(face);
        std::vector<std::int32_t> corners;
        for (std::size_t i = 0; i < 4; ++i)
            if (face[i] != face[(i + 1) % 4]) corners.push_back(face[i]);
        if (corners.size() < 3) return;
        corners.push_back(corners.back());
        skin_.faces.push_back({corners[0], corners[1], corners[2], corners[3]});
    }

    static bool turns_over(int mirrors) { return (((mirrors >> 2) ^ (mirrors >> 1) ^ mirrors) & 1) != 0; }

    void place(const Side& side, int mirrors, int step, bool turn_over) {
        for (const auto& piece : side.patch->pieces) {
            Face face;
            for (std::size_t i = 0; i < 4; ++i)
                face[i] = vertex(side.bases[static_cast<std::size_t>(piece[i])], mirrors, step);
            add_face(face, turn_over != turns_over(mirrors));
        }
    }

    void location_in(const std::vector<int>& images, const Side& side) {
        for (const int mirrors : images) place(side, mirrors, 0, false);
    }

    void add_turned_edges() {
        for (const auto& [facet, images] : seen_facets()) {
            const Side edge = bases_of(facet);
            for (const int mirrors : images)
                for (const auto& piece : edge.patch->pieces)
                    for (int k = 0; k < steps_; ++k) {
                        const auto a = edge.bases[static_cast<std::size_t>(piece[0])];
                        const auto b = edge.bases[static_cast<std::size_t>(piece[1])];
                        add_face({vertex(a, mirrors, k), vertex(b, mirrors, k), vertex(b, mirrors, k + 1),
                                  vertex(a, mirrors, k + 1)},
                                 turns_over(mirrors));
                    }
        }
    }

    void add_cuts() {
        for (mesh::Index cell = 0; cell < model_.mesh.cell_count(); ++cell) {
            const Side section = bases_of_cell(cell);
            for (const int mirrors : mirrors_) {
                place(section, mirrors, 0, true);
                place(section, mirrors, steps_, false);
            }
        }
    }

    const model::Case& model_;
    const fields::RegionPoints& places_;
    const SkinOptions& options_;
    double tolerance_m_;
    bool closed_ = false;
    int steps_ = 0;             ///< of the turn
    std::vector<int> mirrors_;  ///< images shown; bit d: mirrored at the plane with zero coordinate d
    std::array<std::int32_t, 8> first_placement_{};
    std::map<mesh::CellType, Patch> patches_;
    std::map<std::vector<std::pair<std::int32_t, std::int64_t>>, std::int32_t> bases_;
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> vertices_;
    Skin skin_;
};

}  // namespace

Skin make_skin(const model::Case& model, const fields::RegionPoints& places, const SkinOptions& options) {
    check(options);
    return Builder(model, places, options).run();
}

}  // namespace soft::view
