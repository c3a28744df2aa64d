#pragma once
/// Test matrix of laws and elements: every cell type, form and kinematics with one distorted cell each, and a rubber of
/// every law.
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "../material/samples.hpp"
#include "distorted_cell.hpp"
#include "fem/solid_kernel.hpp"
#include "model/formulation.hpp"

namespace soft::fem {

inline constexpr std::array<mesh::CellType, 10> solid_types{
    mesh::CellType::triangle3, mesh::CellType::triangle6, mesh::CellType::quad4, mesh::CellType::quad9,
    mesh::CellType::tet4,      mesh::CellType::tet10,     mesh::CellType::hex8,  mesh::CellType::hex27,
    mesh::CellType::wedge6,    mesh::CellType::wedge18};
inline constexpr std::array<Form, 3> forms{Form::displacement, Form::mixed, Form::f_bar};

struct Combination {
    mesh::CellType type;
    model::Kinematics kinematics;
    Form form;
};

inline std::vector<model::Kinematics> kinematics_of(mesh::CellType type) {
    using model::Kinematics;
    if (mesh::dimension(type) == 3) return {Kinematics::solid};
    return {Kinematics::axisymmetric, Kinematics::plane_strain};
}

/// Every combination of cell, kinematics and form, including unsupported ones.
inline std::vector<Combination> every_combination() {
    std::vector<Combination> list;
    for (const auto form : forms)
        for (const auto type : solid_types)
            for (const auto kinematics : kinematics_of(type)) list.push_back({type, kinematics, form});
    return list;
}

/// The supported combinations.
inline std::vector<Combination> all_combinations() {
    auto list = every_combination();
    std::erase_if(list, [](const Combination& c) { return !model::explain_incompatibility(c.type, c.form).empty(); });
    return list;
}

inline std::string label(const Combination& c) {
    static constexpr std::array<const char*, 3> form_names{" displacement", " mixed", " F-bar"};
    static constexpr std::array<const char*, 3> kinematics_names{" axisymmetric", " plane strain", ""};
    return std::string(mesh::topology(c.type).name) + kinematics_names[static_cast<std::size_t>(c.kinematics)] +
           form_names[static_cast<std::size_t>(c.form)];
}

/// A rubber of the law with all terms nonzero; fibres in the cylindrical frame, which varies over the cell of a solid.
inline material::AnyRubber rubber_of(const material::LawInfo& law) {
    auto description = material::sample::description_of(law.name);
    description.fiber_frame = material::FiberFrame::cylindrical;
    return material::make_rubber(description);
}

inline material::AnyRubber neo_hookean() { return rubber_of(*material::find_law("neo-hookean")); }

/// A distorted cell with values of its unknowns. Displacements are of the order of `length`, pressure unknowns of order one.
struct Sample {
    static constexpr double length = 0.01;

    Combination combination;
    material::AnyRubber rubber;
    ReferenceCell cell;
    std::vector<double> X, unknowns;
    material::StepMemory memory;  ///< used by inelastic rubber; of the next two
    std::vector<double> W_max;
    std::vector<material::SymmetricTensor> overstress;

    explicit Sample(const Combination& c, material::AnyRubber law = neo_hookean())
        : combination(c),
          rubber(std::move(law)),
          cell(make_reference_cell(c.type, c.form)),
          X(distorted_nodes(c.type)),
          unknowns(smooth_displacement(c.type, X, 1.0)) {
        for (int s = 0; s < cell.pressure_dofs; ++s) unknowns.push_back(0.3 + 0.1 * s);
    }
    [[nodiscard]] CellInput input(const std::vector<double>& values) const {
        const auto split = static_cast<std::size_t>(cell.displacement_dofs());
        const bool is_inelastic = material::inelastic_of(rubber) != nullptr;
        return {X,
                {values.data(), split},
                {values.data() + split, values.size() - split},
                1e5,
                is_inelastic ? &memory : nullptr};
    }
    [[nodiscard]] CellOutput integrate(const std::vector<double>& values) const {
        CellOutput out(cell);
        std::visit(
            [&](const auto& r) {
                integrate_cell(cell, combination.kinematics, r, input(values), material::Wanted::stress_and_tangent,
                               out);
            },
            rubber);
        return out;
    }
    [[nodiscard]] std::vector<PointState> points(const std::vector<double>& values) const {
        std::vector<PointState> states;
        const auto frame = std::visit([](const auto& r) { return r.fiber_frame; }, rubber);
        CellPoints work(cell);
        sample_cell(cell, combination.kinematics, frame, input(values), work, states);
        return states;
    }
    /// W integrated over the cell; its derivative is the residual.
    [[nodiscard]] double energy(const std::vector<double>& values) const {
        double sum = 0;
        for (const auto& point : points(values))
            sum += point.weight_m3 *
                   std::visit([&](const auto& r) { return energy_density(combination.form, r, point); }, rubber);
        return sum;
    }
    /// A direction in the space of the unknowns, scaled by the unit of each.
    [[nodiscard]] std::vector<double> direction() const {
        std::vector<double> d(unknowns.size());
        for (std::size_t i = 0; i < d.size(); ++i)
            d[i] = (i < X.size() ? length : 1.0) * std::sin(1.0 + 1.7 * static_cast<double>(i));
        return d;
    }
};

inline std::vector<double> moved(std::vector<double> x, const std::vector<double>& d, double h) {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += h * d[i];
    return x;
}

inline double inner_product(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

inline double norm(const std::vector<double>& a) { return std::sqrt(inner_product(a, a)); }

/// K d.
inline std::vector<double> product(const std::vector<double>& K, const std::vector<double>& d) {
    std::vector<double> result(d.size(), 0.0);
    for (std::size_t i = 0; i < d.size(); ++i)
        for (std::size_t j = 0; j < d.size(); ++j) result[i] += K[i * d.size() + j] * d[j];
    return result;
}

}  // namespace soft::fem
