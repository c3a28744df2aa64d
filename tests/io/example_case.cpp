#include "example_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "io/hdf5_write.hpp"
#include "io/image.hpp"

namespace soft::io::test {
namespace {

/// Two cells side by side along x on a lattice, with nodes at their reference coordinates.
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

std::vector<double> numbers(int count, double first) {
    std::vector<double> list;
    for (int i = 0; i < count; ++i) list.push_back(first + i / 3.0);
    return list;
}

model::StatePoint example_state(double first) {
    return {numbers(9, first), numbers(9, -first),    numbers(2, first), numbers(2, 3 * first), 0.25, -0.5,
            -1e-3 * first,     numbers(2, 2 * first), 1e-7 * first,      2e-3 * first,          3};
}

}  // namespace

model::Case section_case() {
    model::Case model;
    model.name = "zweizellig \xc3\xa4";  // UTF-8 must survive
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
        {"collar",
         "ogden",
         {{"mu", {1e5, 2e3, -1e4}}, {"alpha", {1.3, 5.0, -2.0}}},
         std::nullopt,
         1200.5,
         model::Volumetric::quadratic,
         model::Strain::small,
         model::FiberFrame::cylindrical,
         "materials.collar",
         model::Fibers{0.6, 5e5, 1.25, 1}},
    };
    model.supports = {{"end_disc", {true, true, false}}, {"inlet", {false, true, false}}};
    model.cavities = {{"main", "cavity", {"end_disc"}, {{"inlet", 1.9634954084936207e-5, {-1, 0, 0}}}},
                      {"annex", "cavity", {}, {}}};
    const model::TimeFunction table{model::TimeFunctionKind::table, 0, 0, {0, 0.05, 0.4}, {0, 1.5, -0.25}};
    model.loads = {{"supply",
                    {"main", "annex"},
                    true,
                    {0.9e5, 1.1, 5e-6, 1.4},
                    model::LoadShape::deformed,
                    table,
                    model::SupplyLine{2.5e8}},
                   {"outside",
                    {"inlet"},
                    false,
                    {},
                    model::LoadShape::undeformed,
                    {model::TimeFunctionKind::ramp, 0.125, 0, {}, {}},
                    {}}};
    using enum model::DeadLoadKind;
    model.dead_loads = {{"inlet", traction, {-1.5e3, 0, 0}, {model::TimeFunctionKind::sine, 0, 12.5, {}, {}}},
                        {"end_disc", force, {0, 250.0, 0}, table, 4.5e-4},
                        {"gravity", gravity, {-9.81, 0, 0}, {model::TimeFunctionKind::step, 0, 0, {}, {}}}};
    model.motions = {{"inlet", {-2e-3, std::nullopt, std::nullopt}}, {"end_disc", {0.0, 1e-3, std::nullopt}}};
    model.obstacles = {{"wall", model::Plane{{0.9, 0, 0}, {-1, 0, 0}}},
                       {"die", model::FacetedSurface{{{0.5, 1, 0}, {1.0 / 3, 1.5, 0}, {0.7, 2, 0}},
                                                     {{0, 1, -1}, {1, 2, -1}, {2, 0, -1}}}}};
    model.contact = {.self = false, .distance = 0.03};
    model.outputs = {{"elongation", "inlet", {-1, 0, 0}},
                     {"bend", "cavity", {0.6, 0.8, 0}, model::Measure::bend, "end_disc"}};
    model.path.stages = {
        {"inflate",
         model::Control::arc_length,
         "supply",
         {{"elongation", 0.13}, {"volume_ratio", 5}},
         {{model::Prescription::volume_ratio, 3}, {model::Prescription::pressure, -500}},
         {1, 0.5, 1},
         {0, 0}},
        {"hold",
         model::Control::volume,
         "supply",
         {},
         {{model::Prescription::closed, 0}, {model::Prescription::pressure, 0}},
         {1, -0.5, 1},
         {0.25, 1}},
        {"vent",
         model::Control::displacement,
         "bend",
         {{"bend", 0.5}},
         {{model::Prescription::mass, -2e-5}, {model::Prescription::pressure, 0}},
         {0, 0, 0},
         {1, 0}},
    };
    model.path.branch = model::Branch::follow;
    model.path.imperfection_m = 2.5e-5;
    model.path.contact = model::Contact::ignore;
    model.path.stretch_limit = 7.5;
    model.path.frequencies = 2;
    model.solver = {.residual_tolerance = 3e-10,
                    .newton = model::NewtonMethod::bfgs,
                    .line_search = model::LineSearch::secant,
                    .tangent = model::TangentSource::finite_difference,
                    .newton_limit = 11,
                    .linear = {model::LinearMethod::krylov, model::Preconditioner::gamg, 3e-6, 123},
                    .scaling = false,
                    .threads = 3,
                    .steps = model::StepRule::iteration_adaptive,
                    .predictor = model::Predictor::tangent,
                    .first_step = 0.05,
                    .max_step = 0.25,
                    .min_step = 2e-5,
                    .wanted_iterations = 7,
                    .step_limit = 77,
                    .step_accuracy = 0.004};
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
    model.materials = {{"rubber",
                        "yeoh",
                        {{"c1", {1e5}}, {"c2", {0.0}}, {"c3", {-7.25}}},
                        std::nullopt,
                        std::nullopt,
                        model::Volumetric::mixed}};
    model.supports = {{"fixed", {true, true, true}}};
    model.loads = {{"end", {"end"}, true, {}}};
    model.outputs = {{"elongation", "end", {1, 0, 0}}};
    model.path.stages.emplace_back().supplies = {{model::Prescription::pressure, -2.5e4}};
    return model;
}

model::Case dynamic_case() {
    model::Case model = solid_case();
    model.materials[0].density_kg_m3 = 1070;
    model.dynamics = model::Dynamics{.integrator = model::Integrator::rosenbrock,
                                     .duration_s = 0.75,
                                     .step_s = 2e-4,
                                     .accuracy = 3e-5,
                                     .spectral_radius = 0.25,
                                     .mass_damping_1_s = 1.5,
                                     .stiffness_damping_s = 4e-5,
                                     .rows = 321};
    return model;
}

model::Step moving_step(int number) {
    model::Step step;
    step.load_factor = 0.1 * number;
    step.pressure_Pa = -2.5e4 * step.load_factor;
    step.outputs = {1e-3 * number};
    step.tangent_load_factor = 1 / 0.75;
    step.tangent_outputs = {0.5};
    step.motion = {.time_s = 0.075 * number,
                   .kinetic_energy_J = 1e-3 * number,
                   .stored_energy_J = 2e-3 * number,
                   .load_work_J = 3.5e-3 * number,
                   .damping_work_J = 5e-4 * number};
    return step;
}

DesignText example_design() {
    return {"family: tube\nname: \xc3\xa4\n", {"geometry.wall=2.5mm", "load.pressure=60kPa"}};
}

Provenance example_provenance(const std::string& tool) {
    return {tool, "0.1.0", "0123abc", {"HDF5 1.10.8", "gmsh 4.8.4"}, tool + " designs/tube.yaml --set \"a.b=c d\""};
}

model::Shape shape_of(const model::Case& model) {
    model::Shape shape{model.kinematics,
                       model.model_fraction,
                       model.symmetry_planes,
                       {0.6, 0.8, 0},
                       model.supports,
                       model.cavities,
                       {},
                       {},
                       {}};
    for (const model::Obstacle& obstacle : model.obstacles)
        if (const auto* faceted = std::get_if<model::FacetedSurface>(&obstacle.shape))
            shape.obstacles[obstacle.name] = *faceted;
    for (const model::Material& material : model.materials) {
        shape.region_materials[material.name] = "paper";
        if (material.fibers) shape.region_fibers[material.name] = {*material.fibers, material.fiber_frame};
    }
    return shape;
}

std::vector<std::byte> write_case(const model::Case& model, const DesignText& design, const Provenance& provenance) {
    return io::write_case(model.mesh, shape_of(model), design, provenance);
}

model::CaseBuilder builder_of(const model::Case& like) {
    return [like](mesh::Mesh mesh, const model::Shape& shape, std::string_view, std::string_view) {
        model::Case model = like;
        model.mesh = std::move(mesh);
        model.kinematics = shape.kinematics;
        model.supports = shape.supports;
        model.cavities = shape.cavities;
        for (model::Obstacle& obstacle : model.obstacles)
            if (const auto faceted = shape.obstacles.find(obstacle.name); faceted != shape.obstacles.end())
                obstacle.shape = faceted->second;
        return model;
    };
}

CaseFile read_case_file(std::span<const std::byte> image, std::string_view source, const model::Case& like) {
    return io::read_case_file(image, source, builder_of(like));
}

Result read_result(std::vector<std::byte> image, std::string_view source, const model::Case& like) {
    return io::read_result(std::move(image), source, builder_of(like));
}

InterruptedSolve read_interrupted(std::span<const std::byte> image, std::string_view source, const model::Case& like) {
    return io::read_interrupted(image, source, builder_of(like));
}

void expect_stored(std::span<const std::byte> image, const model::Case& model) {
    const auto build = [&](const mesh::Mesh& mesh, const model::Shape& shape, std::string_view, std::string_view) {
        expect_equal(mesh, model.mesh);
        expect_equal(shape, shape_of(model));
        return model;
    };
    static_cast<void>(io::read_case_file(image, "case.h5", build));
}

std::vector<std::byte> section_image() {
    return write_case(section_case(), example_design(), example_provenance("mesh-gen"));
}

model::Step example_step(int number) {
    const double t = 0.1 * number;
    model::Step step;
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
    step.stable_under_control = number != 1;
    step.stretch_p99 = 1 + t / 2;
    step.max_stretch = 1 + t;
    step.min_jacobian = 1 - t / 100;
    step.extremes = {{0.1 * number, 0.2, -0.3}, 1e4 * t};
    step.energies = {2e-3 * t, 2.1e-3 * t, 2.05e-3 + t};
    step.frequencies_Hz = {0.5 - number, 12.25 + t};
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

model::PathEnd example_end() {
    model::PathEnd end{model::StopReason::limit_point, "the pressure has a maximum", {}, {}, {}, 21, 17};
    end.limit_points = {{1, 44338.7, 2e-5, {0.01345, 0}}};
    end.bifurcations.resize(2);
    end.bifurcations[0].at = {0, 26e3, 1.8e-5, {0.011, 0.1}};
    end.bifurcations[0].modes = 2;
    end.bifurcations[1].at = {1, 27e3, 1.9e-5, {0.012, 0.2}};
    end.bifurcations[1].mode = example_displacement(7);
    return end;
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

model::Checkpoint example_checkpoint(int rows) {
    model::Checkpoint checkpoint;
    checkpoint.ranks = 2;
    checkpoint.rows = rows;
    checkpoint.stage = 1;
    checkpoint.stage_first_row = 2;
    checkpoint.start = {numbers(2, 5), numbers(2, 6), numbers(2, 7), numbers(3, 8), numbers(2, 10)};
    checkpoint.control = 3;
    checkpoint.controlled = 1;
    checkpoint.user_control_failed = true;
    checkpoint.confirmed_pivots = 3;
    checkpoint.pending_factorizations = 2;
    checkpoint.before = example_state(11);
    checkpoint.last = example_state(12);
    checkpoint.last.unstable_modes.reset();
    checkpoint.step = 0.125;
    checkpoint.first_step = 0.0625;
    checkpoint.first_slope = 17.5;
    checkpoint.visited = numbers(64, 3);
    checkpoint.so_far = example_end();
    return checkpoint;
}

void overwrite(hid_t file, const char* dataset, std::size_t first, const std::vector<double>& values) {
    overwrite_typed(file, dataset, first, values);
}
void overwrite(hid_t file, const char* dataset, std::size_t first, const std::vector<std::int64_t>& values) {
    overwrite_typed(file, dataset, first, values);
}

std::string refusal(const std::vector<std::byte>& image, std::string_view source) {
    try {
        static_cast<void>(read_case_file(image, source));
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input) << error.what();
        return error.what();
    }
    ADD_FAILURE() << "the image was accepted";
    return {};
}

}  // namespace soft::io::test
