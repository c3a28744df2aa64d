#include "mesh/quadrature.hpp"

#include <cmath>
#include <stdexcept>

namespace soft::mesh {

namespace {

struct LinePoint {
    double x, weight;
};

std::vector<LinePoint> gauss_legendre(int degree) {
    switch ((degree + 2) / 2) {
        case 1: return {{0.0, 2.0}};
        case 2: {
            const double x = 1.0 / std::sqrt(3.0);
            return {{-x, 1.0}, {x, 1.0}};
        }
        case 3: {
            const double x = std::sqrt(0.6);
            return {{-x, 5.0 / 9.0}, {0.0, 8.0 / 9.0}, {x, 5.0 / 9.0}};
        }
        case 4: {
            const double root = 2.0 / 7.0 * std::sqrt(1.2);
            const double inner = std::sqrt(3.0 / 7.0 - root), outer = std::sqrt(3.0 / 7.0 + root);
            const double s = std::sqrt(30.0);
            const double w_inner = (18.0 + s) / 36.0, w_outer = (18.0 - s) / 36.0;
            return {{-outer, w_outer}, {-inner, w_inner}, {inner, w_inner}, {outer, w_outer}};
        }
        default: throw std::logic_error("gauss_legendre: degree above 7");
    }
}

std::vector<QuadraturePoint> triangle_rule(int degree) {
    if (degree <= 1) return {{{1.0 / 3.0, 1.0 / 3.0, 0}, 0.5}};
    if (degree <= 2)
        return {{{1.0 / 6.0, 1.0 / 6.0, 0}, 1.0 / 6.0},
                {{2.0 / 3.0, 1.0 / 6.0, 0}, 1.0 / 6.0},
                {{1.0 / 6.0, 2.0 / 3.0, 0}, 1.0 / 6.0}};
    if (degree > 5) throw std::logic_error("triangle_rule: degree above 5");
    const double s = std::sqrt(15.0);
    std::vector<QuadraturePoint> rule{{{1.0 / 3.0, 1.0 / 3.0, 0}, 9.0 / 80.0}};
    for (const double sign : {1.0, -1.0}) {
        const double a = (6.0 - sign * s) / 21.0, weight = (155.0 - sign * s) / 2400.0;
        const double b = 1.0 - 2.0 * a;
        rule.push_back({{a, a, 0}, weight});
        rule.push_back({{b, a, 0}, weight});
        rule.push_back({{a, b, 0}, weight});
    }
    return rule;
}

std::vector<QuadraturePoint> tetrahedron_rule(int degree) {
    if (degree <= 1) return {{{0.25, 0.25, 0.25}, 1.0 / 6.0}};
    std::vector<QuadraturePoint> rule;
    const auto vertex_orbit = [&rule](double a, double weight) {
        const double b = 1.0 - 3.0 * a;
        for (const auto& xi : {std::array{a, a, a}, std::array{b, a, a}, std::array{a, b, a}, std::array{a, a, b}})
            rule.push_back({xi, weight});
    };
    if (degree <= 2) {
        vertex_orbit((5.0 - std::sqrt(5.0)) / 20.0, 1.0 / 24.0);
        return rule;
    }
    if (degree > 5) throw std::logic_error("tetrahedron_rule: degree above 5");
    vertex_orbit(0.31088591926330060980, 0.11268792571801585080 / 6.0);
    vertex_orbit(0.092735250310891226402, 0.073493043116361949544 / 6.0);
    const double c = 0.045503704125649649492, d = 0.5 - c;
    for (const auto& xi : {std::array{c, c, d}, std::array{c, d, c}, std::array{d, c, c}, std::array{c, d, d},
                           std::array{d, c, d}, std::array{d, d, c}})
        rule.push_back({xi, 0.042546020777081466438 / 6.0});
    return rule;
}

std::vector<QuadraturePoint> tensor_rule(int dimension, int degree) {
    const auto line = gauss_legendre(degree);
    std::vector<QuadraturePoint> rule{{{0, 0, 0}, 1.0}};
    for (int d = 0; d < dimension; ++d) {
        std::vector<QuadraturePoint> next;
        for (const auto& point : rule)
            for (const auto& [x, weight] : line) {
                auto extended = point;
                extended.xi[d] = x;
                extended.weight *= weight;
                next.push_back(extended);
            }
        rule = std::move(next);
    }
    return rule;
}

}  // namespace

std::vector<QuadraturePoint> quadrature(Shape shape, int degree) {
    switch (shape) {
        case Shape::line: return tensor_rule(1, degree);
        case Shape::quadrilateral: return tensor_rule(2, degree);
        case Shape::hexahedron: return tensor_rule(3, degree);
        case Shape::triangle: return triangle_rule(degree);
        case Shape::tetrahedron: return tetrahedron_rule(degree);
        case Shape::wedge: {
            std::vector<QuadraturePoint> rule;
            for (const auto& flat : triangle_rule(degree))
                for (const auto& [z, weight] : gauss_legendre(degree))
                    rule.push_back({{flat.xi[0], flat.xi[1], z}, flat.weight * weight});
            return rule;
        }
    }
    throw std::logic_error("quadrature: unknown shape");
}

}  // namespace soft::mesh
