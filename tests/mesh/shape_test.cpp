#include "mesh/shape.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/quadrature.hpp"

namespace soft::mesh {
namespace {

using ReferencePoint = std::array<double, 3>;
constexpr CellType all_types[] = {CellType::line2, CellType::line3, CellType::triangle3, CellType::triangle6,
                                  CellType::quad4, CellType::quad9, CellType::tet4,      CellType::tet10,
                                  CellType::hex8,  CellType::hex27, CellType::wedge6,    CellType::wedge18};
constexpr ReferencePoint inside{0.21, 0.17, 0.13};

/// A complete polynomial of total degree `order`, which the cell must reproduce.
double polynomial(int order, int dimension, const ReferencePoint& x) {
    const double y = dimension > 1 ? x[1] : 0, z = dimension > 2 ? x[2] : 0;
    const double linear = 1.0 + 2.0 * x[0] - 3.0 * y + 0.5 * z;
    return order == 1 ? linear : linear + x[0] * x[0] - 2.0 * x[0] * y + 3.0 * y * y + y * z - z * z;
}

TEST(ShapeFunctions, AreOneAtTheirNodeAndZeroAtTheOthers) {
    for (const auto type : all_types) {
        const auto& cell = topology(type);
        for (int b = 0; b < cell.node_count; ++b) {
            const auto shapes = shape_values(type, cell.nodes[b]);
            for (int a = 0; a < cell.node_count; ++a)
                EXPECT_NEAR(shapes[a].value, a == b ? 1.0 : 0.0, 1e-14) << cell.name << " " << a << " " << b;
        }
    }
}

TEST(ShapeFunctions, ReproducePolynomialsOfTheirOrder) {
    for (const auto type : all_types) {
        const auto& cell = topology(type);
        const auto shapes = shape_values(type, inside);
        double value = 0;
        for (int a = 0; a < cell.node_count; ++a)
            value += shapes[a].value * polynomial(cell.order, cell.dimension, cell.nodes[a]);
        EXPECT_NEAR(value, polynomial(cell.order, cell.dimension, inside), 1e-14) << cell.name;
    }
}

TEST(ShapeFunctions, GradientsAreTheDerivativesOfTheValues) {
    constexpr double h = 1e-6;
    for (const auto type : all_types) {
        const auto& cell = topology(type);
        const auto shapes = shape_values(type, inside);
        for (int d = 0; d < cell.dimension; ++d) {
            auto forward = inside, backward = inside;
            forward[d] += h;
            backward[d] -= h;
            const auto plus = shape_values(type, forward), minus = shape_values(type, backward);
            for (int a = 0; a < cell.node_count; ++a)
                EXPECT_NEAR(shapes[a].gradient[d], (plus[a].value - minus[a].value) / (2 * h), 1e-9) << cell.name;
        }
    }
}

double factorial(int n) { return n < 2 ? 1.0 : n * factorial(n - 1); }

/// Exact integral of x^i y^j z^k over the reference cell.
double exact_monomial(Shape shape, int i, int j, int k) {
    const auto line = [](int n) { return n % 2 == 0 ? 2.0 / (n + 1) : 0.0; };
    switch (shape) {
        case Shape::line: return line(i);
        case Shape::quadrilateral: return line(i) * line(j);
        case Shape::hexahedron: return line(i) * line(j) * line(k);
        case Shape::triangle: return factorial(i) * factorial(j) / factorial(i + j + 2);
        case Shape::tetrahedron: return factorial(i) * factorial(j) * factorial(k) / factorial(i + j + k + 3);
        case Shape::wedge: return factorial(i) * factorial(j) / factorial(i + j + 2) * line(k);
    }
    return 0;
}

TEST(Quadrature, IntegratesMonomialsOfItsDegreeExactly) {
    struct Claim {
        Shape shape;
        int dimension, max_degree;
    };
    for (const auto& [shape, dimension, largest] :
         {Claim{Shape::line, 1, 7}, Claim{Shape::quadrilateral, 2, 7}, Claim{Shape::hexahedron, 3, 7},
          Claim{Shape::triangle, 2, 5}, Claim{Shape::tetrahedron, 3, 5}, Claim{Shape::wedge, 3, 5}})
        for (int degree = 1; degree <= largest; ++degree) {
            const auto rule = quadrature(shape, degree);
            for (int i = 0; i <= degree; ++i)
                for (int j = 0; j <= (dimension > 1 ? degree - i : 0); ++j)
                    for (int k = 0; k <= (dimension > 2 ? degree - i - j : 0); ++k) {
                        double sum = 0;
                        for (const auto& [xi, weight] : rule)
                            sum += weight * std::pow(xi[0], i) * std::pow(xi[1], j) * std::pow(xi[2], k);
                        EXPECT_NEAR(sum, exact_monomial(shape, i, j, k), 1e-14)
                            << static_cast<int>(shape) << " degree " << degree << ": " << i << j << k;
                    }
        }
}

TEST(Quadrature, RejectsUnsupportedDegrees) {
    EXPECT_THROW((void)quadrature(Shape::tetrahedron, 6), std::logic_error);
    EXPECT_THROW((void)quadrature(Shape::quadrilateral, 8), std::logic_error);
}

}  // namespace
}  // namespace soft::mesh
