#pragma once
/// Bodies for the contact tests, and deformations given as maps of space.
#include <random>

#include "../surface/sample_meshes.hpp"
#include "contact/contact.hpp"
#include "mesh/raise_order.hpp"
#include "mesh/split.hpp"

namespace soft::contact::test {

using namespace surface::test;

using Motion = std::function<Point(const Point&)>;

/// [point x 3], as in the result file.
inline std::vector<double> displacement(const model::Case& model, const Motion& to) {
    std::vector<double> u;
    for (const Point& X : model.mesh.points) {
        const Point x = to(X);
        for (std::size_t d = 0; d < 3; ++d) u.push_back(x[d] - X[d]);
    }
    return u;
}

inline std::optional<Contact> contact(const ContactFinder& finder, const model::Case& model, const Motion& to) {
    return finder.find(displacement(model, to));
}
inline std::optional<Contact> contact(const model::Case& model, const Motion& to) {
    return contact(ContactFinder(model), model, to);
}

struct Interval {
    double from, to;
};

inline Map box(Interval x, Interval y, Interval z = {0, 0}) {
    return [=](double u, double v, double w) {
        return Point{std::lerp(x.from, x.to, u), std::lerp(y.from, y.to, v), std::lerp(z.from, z.to, w)};
    };
}

enum class Cells { second_order, first_order, second_order_simplices, first_order_simplices };
inline constexpr std::array<Cells, 4> all_cells{Cells::second_order, Cells::first_order, Cells::second_order_simplices,
                                                Cells::first_order_simplices};

/// Converts a mesh of second-order quadrilaterals or hexahedra to another kind of cells.
inline mesh::Mesh as(Cells cells, mesh::Mesh mesh) {
    if (cells == Cells::first_order || cells == Cells::first_order_simplices) mesh = lower_order(mesh);
    if (cells == Cells::second_order_simplices || cells == Cells::first_order_simplices)
        mesh = split_into_simplices(mesh);
    return mesh;
}

/// Two meshes side by side without a common node.
inline mesh::Mesh beside(mesh::Mesh a, const mesh::Mesh& b) {
    const auto first = static_cast<Index>(a.points.size());
    const Index cells = a.cell_count();
    a.points.insert(a.points.end(), b.points.begin(), b.points.end());
    for (Index c = 0; c < b.cell_count(); ++c) {
        std::vector<Index> nodes(b.cell_nodes(c).begin(), b.cell_nodes(c).end());
        for (Index& node : nodes) node += first;
        add_cell(a, b.cell_type(c), nodes, 0);
    }
    for (const auto& [name, facets] : b.facet_sets)
        for (const mesh::Facet& facet : facets) a.facet_sets[name].push_back({facet.cell + cells, facet.local});
    return a;
}

/// Restricts a map to z = 0 for a section.
inline Map of_dimension(int dimension, const Map& map) {
    return [=](double u, double v, double w) {
        Point p = map(u, v, w);
        if (dimension == 2) p[2] = 0;
        return p;
    };
}

inline mesh::Mesh block(int dimension, const Map& map, std::array<int, 3> cells, const std::string& name) {
    MeshBuilder builder(dimension);
    builder.add_block(of_dimension(dimension, map), cells[0], cells[1], cells[2]);
    builder.name_facets(name, [](const Point&) { return true; });
    return builder.take();
}

/// Smooth displacements with a Lipschitz constant below one: x = X + u(X) is then one-to-one everywhere, so there is no contact.
inline Motion wobble(unsigned seed, double lipschitz, double wave_number) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    struct Wave {
        Point k, amplitude;
        double phase;
    };
    std::vector<Wave> waves;
    double bound = 0;
    for (int i = 0; i < 4; ++i) {
        Wave wave{};
        for (std::size_t d = 0; d < 3; ++d) {
            wave.k[d] = wave_number * uniform(random);
            wave.amplitude[d] = uniform(random);
        }
        wave.phase = 3 * uniform(random);
        bound += std::hypot(wave.k[0], wave.k[1], wave.k[2]) *
                 std::hypot(wave.amplitude[0], wave.amplitude[1], wave.amplitude[2]);
        waves.push_back(wave);
    }
    return [=](const Point& X) {
        Point x = X;
        for (const Wave& wave : waves) {
            const double s = std::sin(wave.k[0] * X[0] + wave.k[1] * X[1] + wave.k[2] * X[2] + wave.phase);
            for (std::size_t d = 0; d < 3; ++d) x[d] += lipschitz / bound * wave.amplitude[d] * s;
        }
        return x;
    };
}

/// Rotation by these angles about x and about z, with scaling and translation.
inline Motion placed(double about_x, double about_z, double scale, const Point& shift) {
    return [=](const Point& X) {
        const double y = std::cos(about_x) * X[1] - std::sin(about_x) * X[2],
                     z = std::sin(about_x) * X[1] + std::cos(about_x) * X[2];
        return Point{shift[0] + scale * (std::cos(about_z) * X[0] - std::sin(about_z) * y),
                     shift[1] + scale * (std::sin(about_z) * X[0] + std::cos(about_z) * y), shift[2] + scale * z};
    };
}

inline Motion in_plane(const Motion& motion) {
    return [=](const Point& X) {
        const Point x = motion(X);
        return Point{x[0], x[1], 0};
    };
}

/// A wall of this thickness along a sine-generated curve, whose direction is `swing` sin(2 pi s) at arc length s: a fold of
/// a bellows; the larger the swing, the closer its turns are to each other.
struct Meander {
    double swing, thickness = 0.08;
    static constexpr int pieces = 512;  ///< a unit of arc length, for the integral

    [[nodiscard]] Point operator()(double s, double t) const {
        const int n = std::max(1, static_cast<int>(std::lround(s * pieces)));
        const auto direction = [&](double at) { return swing * std::sin(2 * std::numbers::pi * at); };
        Point p{};
        for (int i = 0; i < n; ++i) {  // Simpson
            const double a = s * i / n, h = s / n;
            for (const auto& [at, weight] : {std::pair{a, 1.0}, {a + h / 2, 4.0}, {a + h, 1.0}}) {
                p[0] += weight * h / 6 * std::cos(direction(at));
                p[1] += weight * h / 6 * std::sin(direction(at));
            }
        }
        return {p[0] - t * thickness * std::sin(direction(s)), p[1] + t * thickness * std::cos(direction(s)), 0};
    }
};

/// A block on the left and a lower, narrower one on the right, 1 m apart; each has its own named face.
inline model::Case two_blocks(int dimension, Cells cells, model::Kinematics kinematics) {
    const auto left = block(dimension, box({0, 1}, {0, 1}, {0, 1}), {2, 3, 2}, "left");
    const auto right = block(dimension, box({2, 3}, {0.4, 0.6}, {0.3, 0.7}), {2, 1, 1}, "right");
    return make_case(as(cells, beside(left, right)), kinematics);
}

inline std::string cells_name(Cells cells) {
    const std::array<std::string, 4> names{"SecondOrder", "FirstOrder", "SecondOrderSimplices", "FirstOrderSimplices"};
    return names[static_cast<std::size_t>(cells)];
}

}  // namespace soft::contact::test
