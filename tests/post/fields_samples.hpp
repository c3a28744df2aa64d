#pragma once
/// Blocks with displacements given by a formula, and the fields that step_fields computes for them.
#include <functional>

#include "../fem/block_mesh.hpp"
#include "post/step_fields.hpp"

namespace soft::post::test {

using Point = mesh::Point;
using Motion = std::function<Point(const Point&)>;  ///< x(X)
using Field = std::function<double(const Point&)>;

struct Sampled {
    RegionPoints region_points;
    std::vector<double> displacement_m, pressure_Pa;
    StepFields fields;

    [[nodiscard]] NodalState state() const { return {displacement_m, pressure_Pa}; }
};

/// `pressure` is used in mixed form only.
inline Sampled sample(
    const model::Case& model, const Motion& motion, const Field& pressure = [](const Point&) { return 0.0; }) {
    Sampled made{
        .region_points = make_region_points(model.mesh), .displacement_m = {}, .pressure_Pa = {}, .fields = {}};
    for (const Point& X : model.mesh.points) {
        const Point x = motion(X);
        for (std::size_t i = 0; i < 3; ++i) made.displacement_m.push_back(x[i] - X[i]);
        if (model.formulation == model::Formulation::mixed) made.pressure_Pa.push_back(pressure(X));
    }
    made.fields = step_fields(model, made.region_points, made.state());
    return made;
}

inline Motion linear(const Tensor& F) {
    return [F](const Point& X) {
        Point x{};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) x[i] += F[3 * i + j] * X[j];
        return x;
    };
}

/// The states at all points, cells and nodes.
inline std::vector<LocalState> all_states(const Sampled& sampled) {
    std::vector<LocalState> all = sampled.fields.points;
    all.insert(all.end(), sampled.fields.cells.begin(), sampled.fields.cells.end());
    all.insert(all.end(), sampled.fields.nodes.begin(), sampled.fields.nodes.end());
    return all;
}

inline model::Material neo_hookean(double mu_Pa, std::optional<double> bulk_Pa = {}) {
    model::Material material;
    material.name = "rubber";
    material.law = "neo-hookean";
    material.constants = {{"mu", {mu_Pa}}};
    material.bulk_modulus_Pa = bulk_Pa;
    return material;
}

inline void expect_tensor(const Tensor& found, const Tensor& expected, double tolerance) {
    for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(found[i], expected[i], tolerance) << "component " << i;
}

}  // namespace soft::post::test
