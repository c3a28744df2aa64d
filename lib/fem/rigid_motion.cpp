#include "fem/rigid_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

namespace soft::fem {

namespace {

using mesh::Index;

/// Parts of the mesh that share no node: the part index of every node, -1 for points that no cell uses.
std::vector<int> connected_parts(const mesh::Mesh& mesh, int& count) {
    std::vector<Index> parent(mesh.points.size());
    std::iota(parent.begin(), parent.end(), Index{0});
    const auto root = [&parent](Index node) {
        while (parent[node] != node) node = parent[node] = parent[parent[node]];
        return node;
    };
    std::vector<char> used(mesh.points.size(), 0);
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
        const auto nodes = mesh.cell_nodes(cell);
        for (const Index node : nodes) {
            parent[root(node)] = root(nodes[0]);
            used[node] = 1;
        }
    }
    std::map<Index, int> numbers;
    std::vector<int> part(mesh.points.size(), -1);
    for (std::size_t node = 0; node < part.size(); ++node)
        if (used[node])
            part[node] =
                numbers.try_emplace(root(static_cast<Index>(node)), static_cast<int>(numbers.size())).first->second;
    count = static_cast<int>(numbers.size());
    return part;
}

/// Rows of constrained components, one per node and component, as values of the modes.
using Row = std::array<double, 6>;

/// A mode outside the row space of the constrained components is free: Gram-Schmidt, the row of largest remainder first.
/// Returns the mode with the largest free part, -1 if none is free.
int free_mode(std::vector<Row> rows, std::size_t modes) {
    // Constraints that act on a motion at all have a component far above this; smaller ones are rounding.
    constexpr double visible = 1e-6;
    std::vector<Row> basis;
    const auto dot = [modes](const Row& a, const Row& b) {
        return std::inner_product(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(modes), b.begin(), 0.0);
    };
    while (basis.size() < modes && !rows.empty()) {
        const auto largest = std::ranges::max_element(rows, {}, [&](const Row& row) { return dot(row, row); });
        const double length = std::sqrt(dot(*largest, *largest));
        if (length < visible) break;
        Row unit = *largest;
        for (double& u : unit) u /= length;
        basis.push_back(unit);
        for (auto& row : rows) {
            const double along = dot(row, unit);
            for (std::size_t m = 0; m < modes; ++m) row[m] -= along * unit[m];
        }
    }
    int free = -1;
    double max_share = visible;
    for (std::size_t m = 0; m < modes && basis.size() < modes; ++m) {
        double share = 1.0;
        for (const auto& unit : basis) share -= unit[m] * unit[m];
        if (share > max_share) {
            max_share = share;
            free = static_cast<int>(m);
        }
    }
    return free;
}

}  // namespace

std::vector<RigidMode> rigid_modes(model::Kinematics kinematics) {
    const RigidMode x{"translation along x", {1, 0, 0}, {}}, y{"translation along y", {0, 1, 0}, {}},
        z{"translation along z", {0, 0, 1}, {}}, about_x{"rotation about an axis along x", {}, {1, 0, 0}},
        about_y{"rotation about an axis along y", {}, {0, 1, 0}},
        about_z{"rotation about an axis along z", {}, {0, 0, 1}};
    switch (kinematics) {
        case model::Kinematics::axisymmetric: return {x};
        case model::Kinematics::plane_strain: return {x, y, about_z};
        case model::Kinematics::solid: return {x, y, z, about_x, about_y, about_z};
    }
    return {};
}

std::optional<std::string> free_rigid_motion(const model::Case& input) {
    const auto& mesh = input.mesh;
    const auto modes = rigid_modes(input.kinematics);
    int parts = 0;
    const auto part_of = connected_parts(mesh, parts);
    std::vector<mesh::Point> low(parts, {1e300, 1e300, 1e300}), high(parts, {-1e300, -1e300, -1e300});
    for (std::size_t node = 0; node < mesh.points.size(); ++node)
        for (int i = 0; i < 3 && part_of[node] >= 0; ++i) {
            low[part_of[node]][i] = std::min(low[part_of[node]][i], mesh.points[node][i]);
            high[part_of[node]][i] = std::max(high[part_of[node]][i], mesh.points[node][i]);
        }
    std::vector<std::vector<Row>> rows(parts);
    const auto constrain = [&](const std::string& face, const std::array<bool, 3>& fixed) {
        const auto set = mesh.facet_sets.find(face);
        if (set == mesh.facet_sets.end()) return;  // reported where the unknowns are numbered
        for (const auto& facet : set->second)
            for (const Index node : mesh::facet_nodes(mesh, facet)) {
                const int part = part_of[node];
                mesh::Point centre{};
                double extent = 0;
                for (int i = 0; i < 3; ++i) {
                    centre[i] = 0.5 * (low[part][i] + high[part][i]);
                    extent = std::max(extent, high[part][i] - low[part][i]);
                }
                Vector3 r = difference(mesh.point(node), centre);  // in units of the size of the part
                for (double& component : r) component /= extent;
                for (int i = 0; i < mesh.dimension; ++i) {
                    if (!fixed[i]) continue;
                    Row row{};
                    for (std::size_t m = 0; m < modes.size(); ++m) row[m] = modes[m].velocity(r)[i];
                    rows[part].push_back(row);
                }
            }
    };
    for (const auto& support : input.supports) constrain(support.face, support.fixed);
    for (const auto& moving : input.motions)  // a prescribed displacement constrains like a support
        if (!model::moves_obstacle(input, moving))
            constrain(moving.face, {moving.displacement_m[0].has_value(), moving.displacement_m[1].has_value(),
                                    moving.displacement_m[2].has_value()});
    for (int part = 0; part < parts; ++part)
        if (const int free = free_mode(std::move(rows[part]), modes.size()); free >= 0) {
            std::string text = modes[free].name;
            if (parts > 1)
                text += " of the part near x = " + std::to_string(0.5e3 * (low[part][0] + high[part][0])) + " mm";
            return text;
        }
    return std::nullopt;
}

}  // namespace soft::fem
