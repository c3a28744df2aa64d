#include "equal.hpp"

namespace soft::model::test {
namespace {

void expect_equal(const Material& left, const Material& right) {
    EXPECT_EQ(left.name, right.name);
    EXPECT_EQ(left.law, right.law);
    EXPECT_EQ(left.constants, right.constants);
    EXPECT_EQ(left.bulk_modulus_Pa, right.bulk_modulus_Pa);
    EXPECT_EQ(left.density_kg_m3, right.density_kg_m3);
    EXPECT_EQ(left.volumetric, right.volumetric);
    EXPECT_EQ(left.strain, right.strain);
    EXPECT_EQ(left.fiber_frame, right.fiber_frame);
    EXPECT_EQ(left.fibers, right.fibers);
    EXPECT_EQ(left.source, right.source);
}

void expect_equal(const FacetedSurface& left, const FacetedSurface& right) {
    EXPECT_EQ(left.points, right.points);
    EXPECT_EQ(left.facets, right.facets);
}

void expect_equal(const Plane& left, const Plane& right) {
    EXPECT_EQ(left.point, right.point);
    EXPECT_EQ(left.normal, right.normal);
}

void expect_equal(const Cylinder& left, const Cylinder& right) {
    EXPECT_EQ(left.point, right.point);
    EXPECT_EQ(left.axis, right.axis);
    EXPECT_EQ(left.radius_m, right.radius_m);
    EXPECT_EQ(left.side, right.side);
}

void expect_equal(const Sphere& left, const Sphere& right) {
    EXPECT_EQ(left.center, right.center);
    EXPECT_EQ(left.radius_m, right.radius_m);
    EXPECT_EQ(left.side, right.side);
}

void expect_equal(const Box& left, const Box& right) {
    EXPECT_EQ(left.low, right.low);
    EXPECT_EQ(left.high, right.high);
    EXPECT_EQ(left.radius_m, right.radius_m);
}

void expect_equal(const Obstacle& left, const Obstacle& right) {
    EXPECT_EQ(left.name, right.name);
    ASSERT_EQ(left.shape.index(), right.shape.index());
    std::visit([&]<class Shape>(const Shape& shape) { expect_equal(shape, std::get<Shape>(right.shape)); }, left.shape);
}

void expect_equal(const Support& left, const Support& right) {
    EXPECT_EQ(left.face, right.face);
    EXPECT_EQ(left.fixed, right.fixed);
}

void expect_equal(const Cavity& left, const Cavity& right) {
    EXPECT_EQ(left.name, right.name);
    EXPECT_EQ(left.wall, right.wall);
    EXPECT_EQ(left.inner_faces, right.inner_faces);
    ASSERT_EQ(left.openings.size(), right.openings.size());
    for (std::size_t i = 0; i < left.openings.size(); ++i) {
        EXPECT_EQ(left.openings[i].face, right.openings[i].face);
        EXPECT_EQ(left.openings[i].area_m2, right.openings[i].area_m2);
        EXPECT_EQ(left.openings[i].direction, right.openings[i].direction);
    }
}

void expect_equal(const TimeFunction& left, const TimeFunction& right) {
    EXPECT_EQ(left.kind, right.kind);
    EXPECT_EQ(left.time_s, right.time_s);
    EXPECT_EQ(left.frequency_Hz, right.frequency_Hz);
    EXPECT_EQ(left.times_s, right.times_s);
    EXPECT_EQ(left.shares, right.shares);
}

void expect_equal(const std::optional<Dynamics>& left, const std::optional<Dynamics>& right) {
    ASSERT_EQ(left.has_value(), right.has_value());
    if (!left) return;
    EXPECT_EQ(left->integrator, right->integrator);
    EXPECT_EQ(left->duration_s, right->duration_s);
    EXPECT_EQ(left->step_s, right->step_s);
    EXPECT_EQ(left->accuracy, right->accuracy);
    EXPECT_EQ(left->spectral_radius, right->spectral_radius);
    EXPECT_EQ(left->mass_damping_1_s, right->mass_damping_1_s);
    EXPECT_EQ(left->stiffness_damping_s, right->stiffness_damping_s);
    EXPECT_EQ(left->rows, right->rows);
}

void expect_equal(const SolverSettings& left, const SolverSettings& right) {
    EXPECT_EQ(left.residual_tolerance, right.residual_tolerance);
    EXPECT_EQ(left.newton, right.newton);
    EXPECT_EQ(left.line_search, right.line_search);
    EXPECT_EQ(left.tangent, right.tangent);
    EXPECT_EQ(left.newton_limit, right.newton_limit);
    EXPECT_EQ(left.linear.method, right.linear.method);
    EXPECT_EQ(left.linear.preconditioner, right.linear.preconditioner);
    EXPECT_EQ(left.linear.tolerance, right.linear.tolerance);
    EXPECT_EQ(left.linear.iteration_limit, right.linear.iteration_limit);
    EXPECT_EQ(left.scaling, right.scaling);
    EXPECT_EQ(left.threads, right.threads);
    EXPECT_EQ(left.steps, right.steps);
    EXPECT_EQ(left.predictor, right.predictor);
    EXPECT_EQ(left.wanted_iterations, right.wanted_iterations);
    EXPECT_EQ(left.first_step, right.first_step);
    EXPECT_EQ(left.max_step, right.max_step);
    EXPECT_EQ(left.min_step, right.min_step);
    EXPECT_EQ(left.step_limit, right.step_limit);
    EXPECT_EQ(left.step_accuracy, right.step_accuracy);
}

void expect_equal(const Stage& left, const Stage& right) {
    EXPECT_EQ(left.name, right.name);
    EXPECT_EQ(left.control, right.control);
    EXPECT_EQ(left.controlled, right.controlled);
    expect_all(left.until, right.until, [](const auto& a, const auto& b) {
        EXPECT_EQ(a.quantity, b.quantity);
        EXPECT_EQ(a.value, b.value);
    });
    expect_all(left.supplies, right.supplies, [](const auto& a, const auto& b) {
        EXPECT_EQ(a.what, b.what);
        EXPECT_EQ(a.value, b.value);
    });
    EXPECT_EQ(left.dead_loads, right.dead_loads);
    EXPECT_EQ(left.motions, right.motions);
}

}  // namespace

void expect_equal(const mesh::Mesh& left, const mesh::Mesh& right) {
    EXPECT_EQ(left.dimension, right.dimension);
    EXPECT_EQ(left.points, right.points);
    EXPECT_EQ(left.cell_types, right.cell_types);
    EXPECT_EQ(left.offsets, right.offsets);
    EXPECT_EQ(left.connectivity, right.connectivity);
    EXPECT_EQ(left.cell_regions, right.cell_regions);
    EXPECT_EQ(left.region_names, right.region_names);
    EXPECT_TRUE(left.facet_sets == right.facet_sets);
    EXPECT_EQ(left.point_sets, right.point_sets);
}

void expect_equal(const Shape& left, const Shape& right) {
    EXPECT_EQ(left.kinematics, right.kinematics);
    EXPECT_EQ(left.model_fraction, right.model_fraction);
    EXPECT_EQ(left.symmetry_planes, right.symmetry_planes);
    EXPECT_EQ(left.axis, right.axis);
    expect_all(left.supports, right.supports, [](const auto& a, const auto& b) { expect_equal(a, b); });
    expect_all(left.cavities, right.cavities, [](const auto& a, const auto& b) { expect_equal(a, b); });
    EXPECT_EQ(left.region_materials, right.region_materials);
    ASSERT_EQ(left.obstacles.size(), right.obstacles.size());
    for (const auto& [name, surface] : left.obstacles) {
        ASSERT_TRUE(right.obstacles.contains(name)) << name;
        expect_equal(surface, right.obstacles.at(name));
    }
    ASSERT_EQ(left.region_fibers.size(), right.region_fibers.size());
    for (const auto& [region, winding] : left.region_fibers) {
        ASSERT_TRUE(right.region_fibers.contains(region)) << region;
        EXPECT_EQ(winding.fibers, right.region_fibers.at(region).fibers);
        EXPECT_EQ(winding.frame, right.region_fibers.at(region).frame);
    }
}

void expect_equal(const Case& left, const Case& right) {
    EXPECT_EQ(left.name, right.name);
    EXPECT_EQ(left.kinematics, right.kinematics);
    EXPECT_EQ(left.formulation, right.formulation);
    EXPECT_EQ(left.model_fraction, right.model_fraction);
    EXPECT_EQ(left.symmetry_planes, right.symmetry_planes);
    expect_equal(left.mesh, right.mesh);
    expect_all(left.materials, right.materials, [](const auto& a, const auto& b) { expect_equal(a, b); });
    expect_all(left.supports, right.supports, [](const auto& a, const auto& b) { expect_equal(a, b); });
    expect_all(left.cavities, right.cavities, [](const auto& a, const auto& b) { expect_equal(a, b); });
    expect_all(left.loads, right.loads, [](const auto& a, const auto& b) {
        EXPECT_EQ(a.name, b.name);
        EXPECT_EQ(a.targets, b.targets);
        EXPECT_EQ(a.sealed, b.sealed);
        EXPECT_EQ(a.plug_thrust, b.plug_thrust);
        EXPECT_EQ(a.gas.ambient_Pa, b.gas.ambient_Pa);
        EXPECT_EQ(a.gas.ambient_density_kg_m3, b.gas.ambient_density_kg_m3);
        EXPECT_EQ(a.gas.dead_volume_m3, b.gas.dead_volume_m3);
        EXPECT_EQ(a.gas.exponent, b.gas.exponent);
        EXPECT_EQ(a.shape, b.shape);
        expect_equal(a.time_function, b.time_function);
        ASSERT_EQ(a.line.has_value(), b.line.has_value());
        EXPECT_EQ(a.line.value_or(SupplyLine{}).resistance_Pa_s_m3, b.line.value_or(SupplyLine{}).resistance_Pa_s_m3);
    });
    expect_all(left.dead_loads, right.dead_loads, [](const auto& a, const auto& b) {
        EXPECT_EQ(a.name, b.name);
        EXPECT_EQ(a.kind, b.kind);
        EXPECT_EQ(a.vector_SI, b.vector_SI);
        EXPECT_EQ(a.sign, b.sign);
        EXPECT_EQ(a.area_m2, b.area_m2);
        expect_equal(a.time_function, b.time_function);
    });
    expect_all(left.motions, right.motions, [](const auto& a, const auto& b) {
        EXPECT_EQ(a.face, b.face);
        EXPECT_EQ(a.displacement_m, b.displacement_m);
    });
    expect_all(left.outputs, right.outputs, [](const auto& a, const auto& b) {
        EXPECT_EQ(a.name, b.name);
        EXPECT_EQ(a.face, b.face);
        EXPECT_EQ(a.direction, b.direction);
        EXPECT_EQ(a.measure, b.measure);
        EXPECT_EQ(a.reference, b.reference);
        EXPECT_EQ(a.point_m, b.point_m);
        EXPECT_EQ(a.obstacle, b.obstacle);
    });
    expect_all(left.obstacles, right.obstacles, [](const auto& a, const auto& b) { expect_equal(a, b); });
    EXPECT_EQ(left.contact.self, right.contact.self);
    EXPECT_EQ(left.contact.distance, right.contact.distance);
    expect_all(left.path.stages, right.path.stages, [](const auto& a, const auto& b) { expect_equal(a, b); });
    EXPECT_EQ(left.path.branch, right.path.branch);
    EXPECT_EQ(left.path.imperfection_m, right.path.imperfection_m);
    EXPECT_EQ(left.path.contact, right.path.contact);
    EXPECT_EQ(left.path.stretch_limit, right.path.stretch_limit);
    EXPECT_EQ(left.path.frequencies, right.path.frequencies);
    expect_equal(left.solver, right.solver);
    expect_equal(left.dynamics, right.dynamics);
}

}  // namespace soft::model::test
