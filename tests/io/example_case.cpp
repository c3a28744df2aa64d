#include "example_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "io/hdf5_write.hpp"
#include "io/image.hpp"

namespace soft::io::test {
namespace {

/// Two cells side by side along x on a lattice; the nodes of a cell lie where its reference coordinates say.
mesh::Mesh lattice(mesh::CellType type, int dimension) {
    mesh::Mesh mesh;
    mesh.dimension = dimension;
    const int layers = dimension == 3 ? 3 : 1;
    const auto number = [](int i, int j, int k) { return mesh::Index{i} + 5 * (j + 3 * k); };
    for (int k = 0; k < layers; ++k)
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 5; ++i) mesh.points.push_back({0.1 * i, 1.0 / 3 + 0.07 * j, 0.013 * k});
    for (int cell = 0; cell < 2; ++cell) {
        for (const auto& xi : mesh::topology(type).nodes)
            mesh.connectivity.push_back(number(2 * cell + static_cast<int>(std::lround(xi[0])) + 1,
                                               static_cast<int>(std::lround(xi[1])) + 1,
                                               dimension == 3 ? static_cast<int>(std::lround(xi[2])) + 1 : 0));
        mesh.offsets.push_back(static_cast<mesh::Index>(mesh.connectivity.size()));
        mesh.cell_types.push_back(type);
    }
    return mesh;
}

}  // namespace

model::Case section_case() {
    model::Case model;
    model.name = "zweizellig \xc3\xa4";   // UTF-8 must survive
    model.kinematics = model::Kinematics::axisymmetric;
    model.formulation = model::Formulation::mixed;
    model.model_fraction = 0.5;
    model.symmetry_planes = {true, false, false};
    model.mesh = lattice(mesh::CellType::quad9, 2);
    model.mesh.cell_regions = {1, 0};
    model.mesh.region_names = {"rubber", "collar"};
    model.mesh.facet_sets = {{"cavity", {{0, 0}, {1, 0}}}, {"end_disc", {{1, 1}}}, {"inlet", {{0, 3}}}, {"unused", {}}};
    model.mesh.point_sets = {{"tip", {4, 9, 14}}, {"none", {}}};
    model.materials = {
        {"rubber", "neo-hookean", {{"mu", {164400.0}}}, 16.44e6, 1080.0, model::Volumetric::log},
        {"collar", "ogden", {{"mu", {1e5, 2e3, -1e4}}, {"alpha", {1.3, 5.0, -2.0}}}, std::nullopt,
         1200.5, model::Volumetric::quadratic, model::FiberFrame::cylindrical},
    };
    model.supports = {{"end_disc", {true, true, false}}, {"inlet", {false, true, false}}};
    model.cavities = {{"main", "cavity", {"end_disc"}, {{"inlet", 1.9634954084936207e-5, {-1, 0, 0}}}},
                      {"annex", "cavity", {}, {}}};
    model.loads = {{"supply", {"main", "annex"}, true, {0.9e5, 1.1, 5e-6, 1.4}}, {"outside", {"inlet"}, false, {}}};
    model.tractions = {{"inlet", {-1.5e3, 0, 0}}, {"end_disc", {0, 250.0, 0}}};
    model.body_forces = {{"gravity", {-9.81, 0, 0}}};
    model.motions = {{"inlet", {-2e-3, std::nullopt, std::nullopt}}, {"end_disc", {0.0, 1e-3, std::nullopt}}};
    model.outputs = {{"elongation", "inlet", {-1, 0, 0}},
                     {"bend", "cavity", {0.6, 0.8, 0}, model::Measure::bend, "end_disc"}};
    model.path.stages = {
        {"inflate",
         model::Control::arc_length,
         "supply",
         {{"elongation", 0.13}, {"volume_ratio", 5}},
         {{model::Prescription::volume_ratio, 3}, {model::Prescription::pressure, -500}},
         {1, 0.5},
         {1},
         {0, 0}},
        {"hold",
         model::Control::volume,
         "supply",
         {},
         {{model::Prescription::closed, 0}, {model::Prescription::pressure, 0}},
         {1, -0.5},
         {1},
         {0.25, 1}},
        {"vent",
         model::Control::displacement,
         "bend",
         {{"bend", 0.5}},
         {{model::Prescription::mass, -2e-5}, {model::Prescription::pressure, 0}},
         {0, 0},
         {0},
         {1, 0}},
    };
    model.path.branch = model::Branch::follow;
    model.path.imperfection_m = 2.5e-5;
    model.path.contact = model::Contact::ignore;
    model.path.stretch_limit = 7.5;
    model.solver = {3e-10, 11, 0.05, 0.25, 2e-5, 77, 0.004};
    return model;
}

model::Case solid_case() {
    model::Case model;
    model.name = "solid";
    model.kinematics = model::Kinematics::solid;
    model.formulation = model::Formulation::f_bar;
    model.mesh = lattice(mesh::CellType::hex27, 3);
    model.mesh.cell_regions = {0, 0};
    model.mesh.region_names = {"rubber"};
    model.mesh.facet_sets = {{"fixed", {{0, 0}}}, {"end", {{1, 1}}}};
    model.materials = {{"rubber", "yeoh", {{"c1", {1e5}}, {"c2", {0.0}}, {"c3", {-7.25}}}, std::nullopt,
                        std::nullopt, model::Volumetric::mixed}};
    model.supports = {{"fixed", {true, true, true}}};
    model.loads = {{"end", {"end"}, true, {}}};
    model.outputs = {{"elongation", "end", {1, 0, 0}}};
    model.path.stages.emplace_back().supplies = {{model::Prescription::pressure, -2.5e4}};
    return model;
}

DesignText example_design() {
    return {"tube", "family: tube\nname: \xc3\xa4\n", {"geometry.wall=2.5mm", "load.pressure=60kPa"}};
}

Provenance example_provenance(const std::string& tool) {
    return {tool, "0.1.0", "0123abc", {"HDF5 1.10.8", "gmsh 4.8.4"}, tool + " designs/tube.yaml --set \"a.b=c d\""};
}

std::vector<std::byte> section_image() {
    return write_case(section_case(), example_design(), example_provenance("mesh-gen"));
}

solution::Step example_step(int number) {
    const double t = 0.1 * number;
    solution::Step step;
    step.stage = std::min(number / 2, 2);
    step.load_factor = t;
    step.pressure_Pa = 3e4 * t;
    step.pressures_Pa = {3e4 * t, -500 * t};
    step.volumes_m3 = {1e-5 * (1 + t), 0.49627e-5 * (1 + t)};
    step.volume_m3 = 1.49627e-5 * (1 + t);
    step.outputs = {0.013 * t, -0.002 * t * t};
    step.tangent_load_factor = 1 - t;
    step.tangent_pressure = 3e4 * (1 - t);
    step.tangent_volume = 1.49627e-5;
    step.tangent_pressures = {3e4 * (1 - t), -500};
    step.tangent_volumes = {1e-5, 0.49627e-5};
    step.tangent_outputs = {0.013, -0.004 * t};
    step.newton_iterations = 3 + number;
    step.factorizations = 2 + number;
    step.stable = number != 2;
    step.stretch_p99 = 1 + t / 2;
    step.max_stretch = 1 + t;
    step.min_jacobian = 1 - t / 100;
    return step;
}

std::vector<double> example_displacement(int number) {
    std::vector<double> values(section_case().mesh.points.size() * 3);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = 1e-3 * number * std::sin(static_cast<double>(i));
    return values;
}

std::vector<double> example_pressure(int number) {
    std::vector<double> values(section_case().mesh.points.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = 1e4 * number * std::cos(static_cast<double>(i));
    return values;
}

solution::PathEnd example_end() {
    solution::PathEnd end{solution::StopReason::limit_point, "the pressure has a maximum", {}, {}, 21, 17};
    end.limit_points = {{1, 44338.7, 2e-5, {0.01345, 0}}};
    end.bifurcations.resize(2);
    end.bifurcations[0].at = {0, 26e3, 1.8e-5, {0.011, 0.1}};
    end.bifurcations[0].modes = 2;
    end.bifurcations[1].at = {1, 27e3, 1.9e-5, {0.012, 0.2}};
    end.bifurcations[1].mode = example_displacement(7);
    return end;
}

namespace {

void expect_equal(const model::Material& left, const model::Material& right) {
    EXPECT_EQ(left.name, right.name);
    EXPECT_EQ(left.law, right.law);
    EXPECT_EQ(left.constants, right.constants);
    EXPECT_EQ(left.bulk_modulus_Pa, right.bulk_modulus_Pa);
    EXPECT_EQ(left.density_kg_m3, right.density_kg_m3);
    EXPECT_EQ(left.volumetric, right.volumetric);
    EXPECT_EQ(left.fiber_frame, right.fiber_frame);
}

void expect_equal(const model::Cavity& left, const model::Cavity& right) {
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

void expect_equal(const model::SolverSettings& left, const model::SolverSettings& right) {
    EXPECT_EQ(left.residual_tolerance, right.residual_tolerance);
    EXPECT_EQ(left.newton_limit, right.newton_limit);
    EXPECT_EQ(left.first_step, right.first_step);
    EXPECT_EQ(left.largest_step, right.largest_step);
    EXPECT_EQ(left.smallest_step, right.smallest_step);
    EXPECT_EQ(left.step_limit, right.step_limit);
    EXPECT_EQ(left.step_accuracy, right.step_accuracy);
}

template <class List, class Same>
void expect_all(const List& left, const List& right, Same same) {
    ASSERT_EQ(left.size(), right.size());
    for (std::size_t i = 0; i < left.size(); ++i) same(left[i], right[i]);
}

void expect_equal(const model::Stage& left, const model::Stage& right) {
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
    EXPECT_EQ(left.tractions, right.tractions);
    EXPECT_EQ(left.body_forces, right.body_forces);
    EXPECT_EQ(left.motions, right.motions);
}

void expect_equal(const solution::LimitPoint& left, const solution::LimitPoint& right) {
    EXPECT_EQ(left.step, right.step);
    EXPECT_EQ(left.pressure_Pa, right.pressure_Pa);
    EXPECT_EQ(left.volume_m3, right.volume_m3);
    EXPECT_EQ(left.outputs, right.outputs);
}

}  // namespace

void expect_equal(const model::Case& left, const model::Case& right) {
    EXPECT_EQ(left.name, right.name);
    EXPECT_EQ(left.kinematics, right.kinematics);
    EXPECT_EQ(left.formulation, right.formulation);
    EXPECT_EQ(left.model_fraction, right.model_fraction);
    EXPECT_EQ(left.symmetry_planes, right.symmetry_planes);
    expect_equal(left.mesh, right.mesh);
    expect_all(left.materials, right.materials, [](const auto& a, const auto& b) { expect_equal(a, b); });
    expect_all(left.supports, right.supports, [](const auto& a, const auto& b) {
        EXPECT_EQ(a.face, b.face);
        EXPECT_EQ(a.fixed, b.fixed);
    });
    expect_all(left.cavities, right.cavities, [](const auto& a, const auto& b) { expect_equal(a, b); });
    expect_all(left.loads, right.loads, [](const auto& a, const auto& b) {
        EXPECT_EQ(a.name, b.name);
        EXPECT_EQ(a.targets, b.targets);
        EXPECT_EQ(a.sealed, b.sealed);
        EXPECT_EQ(a.gas.ambient_Pa, b.gas.ambient_Pa);
        EXPECT_EQ(a.gas.ambient_density_kg_m3, b.gas.ambient_density_kg_m3);
        EXPECT_EQ(a.gas.dead_volume_m3, b.gas.dead_volume_m3);
        EXPECT_EQ(a.gas.exponent, b.gas.exponent);
    });
    expect_all(left.tractions, right.tractions, [](const auto& a, const auto& b) {
        EXPECT_EQ(a.face, b.face);
        EXPECT_EQ(a.traction_Pa, b.traction_Pa);
    });
    expect_all(left.body_forces, right.body_forces, [](const auto& a, const auto& b) {
        EXPECT_EQ(a.name, b.name);
        EXPECT_EQ(a.acceleration_m_s2, b.acceleration_m_s2);
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
    });
    expect_all(left.path.stages, right.path.stages, [](const auto& a, const auto& b) { expect_equal(a, b); });
    EXPECT_EQ(left.path.branch, right.path.branch);
    EXPECT_EQ(left.path.imperfection_m, right.path.imperfection_m);
    EXPECT_EQ(left.path.contact, right.path.contact);
    EXPECT_EQ(left.path.stretch_limit, right.path.stretch_limit);
    expect_equal(left.solver, right.solver);
}

void expect_equal(const solution::Step& left, const solution::Step& right) {
    EXPECT_EQ(left.stage, right.stage);
    EXPECT_EQ(left.pressures_Pa, right.pressures_Pa);
    EXPECT_EQ(left.volumes_m3, right.volumes_m3);
    EXPECT_EQ(left.tangent_pressures, right.tangent_pressures);
    EXPECT_EQ(left.tangent_volumes, right.tangent_volumes);
    EXPECT_EQ(left.load_factor, right.load_factor);
    EXPECT_EQ(left.pressure_Pa, right.pressure_Pa);
    EXPECT_EQ(left.volume_m3, right.volume_m3);
    EXPECT_EQ(left.outputs, right.outputs);
    EXPECT_EQ(left.tangent_load_factor, right.tangent_load_factor);
    EXPECT_EQ(left.tangent_pressure, right.tangent_pressure);
    EXPECT_EQ(left.tangent_volume, right.tangent_volume);
    EXPECT_EQ(left.tangent_outputs, right.tangent_outputs);
    EXPECT_EQ(left.newton_iterations, right.newton_iterations);
    EXPECT_EQ(left.factorizations, right.factorizations);
    EXPECT_EQ(left.stable, right.stable);
    EXPECT_EQ(left.stretch_p99, right.stretch_p99);
    EXPECT_EQ(left.max_stretch, right.max_stretch);
    EXPECT_EQ(left.min_jacobian, right.min_jacobian);
    EXPECT_EQ(left.pressure_error_Pa, right.pressure_error_Pa);
    EXPECT_EQ(left.output_errors, right.output_errors);
}

void expect_equal(const solution::PathEnd& left, const solution::PathEnd& right) {
    EXPECT_EQ(left.reason, right.reason);
    EXPECT_EQ(left.detail, right.detail);
    EXPECT_EQ(left.newton_iterations, right.newton_iterations);
    EXPECT_EQ(left.factorizations, right.factorizations);
    expect_all(left.limit_points, right.limit_points, [](const auto& a, const auto& b) { expect_equal(a, b); });
    expect_all(left.bifurcations, right.bifurcations, [](const auto& a, const auto& b) {
        expect_equal(a.at, b.at);
        EXPECT_EQ(a.modes, b.modes);
        EXPECT_EQ(a.mode, b.mode);
    });
}

std::vector<std::byte> tampered(const std::vector<std::byte>& image, const std::function<void(hid_t file)>& change) {
    const FileHandle file = open_memory_copy(split_image(image, "image").hdf5);
    change(file.get());
    return memory_image(file.get());
}

namespace {

template <class T>
void overwrite_typed(hid_t file, const char* name, std::size_t first, const std::vector<T>& values) {
    const DatasetHandle dataset{H5Dopen2(file, name, H5P_DEFAULT)};
    ASSERT_TRUE(dataset) << name;
    const SpaceHandle space{H5Dget_space(dataset.get())};
    std::vector<T> all(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get())));
    ASSERT_LE(first + values.size(), all.size());
    H5Dread(dataset.get(), memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data());
    std::copy(values.begin(), values.end(), all.begin() + static_cast<std::ptrdiff_t>(first));
    ASSERT_GE(H5Dwrite(dataset.get(), memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()), 0);
}

}  // namespace

void overwrite(hid_t file, const char* dataset, std::size_t first, const std::vector<double>& values) {
    overwrite_typed(file, dataset, first, values);
}
void overwrite(hid_t file, const char* dataset, std::size_t first, const std::vector<std::int64_t>& values) {
    overwrite_typed(file, dataset, first, values);
}

std::string refusal(const std::vector<std::byte>& image, std::string_view source) {
    try {
        static_cast<void>(read_case(image, source));
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input) << error.what();
        return error.what();
    }
    ADD_FAILURE() << "the image was accepted";
    return {};
}

}  // namespace soft::io::test
