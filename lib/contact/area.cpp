#include "contact/area.hpp"

namespace soft::contact {

namespace {

Vector3 unit_vector(std::size_t i) {
    Vector3 e{};
    e[i] = 1;
    return e;
}

/// Where the derivative by component p of the nodes of the factor is in a block.
std::size_t place(const Block& block, const AreaStretch& stretch, std::size_t p) {
    const std::size_t own = stretch.gradient.size() / block.dimension;
    return p / own * block.points() + p % own;
}

}  // namespace

double area_stretch(const Patch& undeformed, const Patch& now, const surface::FacetPoint& xi, bool is_revolved) {
    const auto before = undeformed(xi), at = now(xi);
    const double along = norm(cross(at.t1, at.t2)) / norm(cross(before.t1, before.t2));
    if (!is_revolved) return along;
    return along * (is_on_axis(before.x[1], norm(before.t1)) ? along : at.x[1] / before.x[1]);
}

AreaFactor area_factor(double stretch) {
    constexpr double full = 4;
    const double u = stretch / full - 1, below = 1 + u * u;
    if (u <= 0) return {};
    return {1 + u * u * u / below, u * u * (3 + u * u) / (below * below * full),
            2 * u * (3 - u * u) / (below * below * below * full * full)};
}

AreaStretch area_stretch(const ContactSurface::Entry& entry, const Patch& now, std::size_t q,
                         const ContactSurface& surface, Wanted wanted) {
    AreaStretch stretch;
    stretch.stretch = area_stretch(entry.undeformed, now, entry.rule->xi[q], surface.is_revolved());
    const AreaFactor factor = area_factor(stretch.stretch);
    stretch.factor = factor.value;
    if (factor.by_stretch == 0) return stretch;
    const auto before = entry.undeformed(entry.rule->xi[q]), at = now(entry.rule->xi[q]);
    const Vector3 c = cross(at.t1, at.t2);
    const double length = norm(c), undeformed = norm(cross(before.t1, before.t2));
    // On the axis the stretch of the circumference is that along the meridian.
    const bool on_axis = surface.is_revolved() && is_on_axis(before.x[1], norm(before.t1));
    double ratio = 1, by_radius_1_m = 0;
    if (on_axis) {
        ratio = length / undeformed;
    } else if (surface.is_revolved()) {
        ratio = at.x[1] / before.x[1];
        by_radius_1_m = 1 / before.x[1];
    }
    const std::size_t n = entry.nodes.size(), dimension = surface.dimension(), size = n * dimension;
    const Vector3 m = along({}, 1 / length, c);
    std::array<std::array<Vector3, 3>, 2> dc{};  // by each component of the first tangent, and of the second
    for (std::size_t i = 0; i < dimension; ++i) {
        dc[0][i] = cross(unit_vector(i), at.t2);
        dc[1][i] = cross(at.t1, unit_vector(i));
    }
    const double* N = &entry.rule->N[q * n];
    const auto* dN = &entry.rule->dN[q * n];
    std::vector<double> along_surface(size), by_position(size);
    const auto ratio_by = [&](std::size_t i, std::size_t a) {
        if (on_axis) return along_surface[i * n + a];
        return i == 1 ? by_radius_1_m * N[a] : 0;
    };
    for (std::size_t i = 0; i < dimension; ++i)
        for (std::size_t a = 0; a < n; ++a) {
            along_surface[i * n + a] = (dN[a][0] * dot(m, dc[0][i]) + dN[a][1] * dot(m, dc[1][i])) / undeformed;
            by_position[i * n + a] = ratio * along_surface[i * n + a] + ratio_by(i, a) * length / undeformed;
        }
    for (const double slope : by_position) stretch.gradient.push_back(factor.by_stretch * slope);
    if (wanted != Wanted::hessian) return stretch;
    stretch.hessian.assign(size * size, 0);
    for (std::size_t i = 0; i < dimension; ++i)
        for (std::size_t j = 0; j < dimension; ++j) {
            std::array<std::array<double, 2>, 2> K{};  // of |c| by both tangents
            for (std::size_t s = 0; s < 2; ++s)
                for (std::size_t t = 0; t < 2; ++t)
                    K[s][t] = (dot(dc[s][i], dc[t][j]) - dot(m, dc[s][i]) * dot(m, dc[t][j])) / length;
            const double turn = dot(m, cross(unit_vector(i), unit_vector(j)));
            K[0][1] += turn;
            K[1][0] -= turn;
            for (std::size_t a = 0; a < n; ++a)
                for (std::size_t b = 0; b < n; ++b) {
                    const std::size_t p = i * n + a, r = j * n + b;
                    double sum = 0;
                    for (std::size_t s = 0; s < 2; ++s)
                        for (std::size_t t = 0; t < 2; ++t) sum += dN[a][s] * K[s][t] * dN[b][t];
                    stretch.hessian[p * size + r] =
                        factor.by_stretch * ((on_axis ? 2 : 1) * ratio * sum / undeformed +
                                             ratio_by(i, a) * along_surface[r] + ratio_by(j, b) * along_surface[p]) +
                        factor.second_by_stretch * by_position[p] * by_position[r];
                }
        }
    return stretch;
}

void add_area_stretch(Block& block, const AreaStretch& stretch, double e, const Vector3& g,
                      std::span<const double> weights) {
    if (stretch.gradient.empty()) return;
    const std::size_t n = block.points(), size = n * block.dimension, own_size = stretch.gradient.size();
    const auto at = [&](std::size_t p) { return place(block, stretch, p); };
    for (std::size_t p = 0; p < own_size; ++p) block.gradient[at(p)] += e * stretch.gradient[p];
    if (block.hessian.empty()) return;
    for (std::size_t p = 0; p < own_size; ++p) {
        for (std::size_t q = 0; q < own_size; ++q)
            block.hessian[at(p) * size + at(q)] += e * stretch.hessian[p * own_size + q];
        for (std::size_t j = 0; j < block.dimension; ++j)
            for (std::size_t b = 0; b < n; ++b) {
                const double product = stretch.gradient[p] * g[j] * weights[b];
                block.hessian[at(p) * size + j * n + b] += product;
                block.hessian[(j * n + b) * size + at(p)] += product;
            }
    }
}

void add_area_stretch(Block& block, const AreaStretch& stretch, const Vector3& force, std::span<const double> weights) {
    if (block.hessian.empty()) return;
    const std::size_t n = block.points(), size = n * block.dimension;
    for (std::size_t i = 0; i < block.dimension; ++i)
        for (std::size_t a = 0; a < n; ++a)
            for (std::size_t p = 0; p < stretch.gradient.size(); ++p)
                block.hessian[(i * n + a) * size + place(block, stretch, p)] +=
                    force[i] * weights[a] * stretch.gradient[p] / stretch.factor;
}

}  // namespace soft::contact
