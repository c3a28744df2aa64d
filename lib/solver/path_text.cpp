#include "solver/path_text.hpp"

#include "core/text.hpp"

namespace soft::solver {

std::string short_text(double value) { return core::rounded_text(value, 6); }

std::string state_text(const PathPoint& point, const model::Case& input) {
    std::string text;
    switch (model::leading_load(input)) {
        case model::LeadingLoad::pressure:
        case model::LeadingLoad::traction: text = short_text(1e-3 * point.leading) + " kPa"; break;
        case model::LeadingLoad::force: text = short_text(point.leading) + " N"; break;
        case model::LeadingLoad::load_factor: text = "load factor " + short_text(point.leading); break;
    }
    for (std::size_t i = 0; i < point.outputs.size(); ++i) {
        const model::MeasureUnit& unit = model::unit_of(input.outputs[i].measure);
        text += ", " + input.outputs[i].name + " " + short_text(point.outputs[i] / unit.SI_per_shown) + " " +
                std::string{unit.shown};
    }
    if (!point.volumes_m3.empty()) text += ", volume " + short_text(1e6 * point.load_volumes_m3[0]) + " mL";
    return text;
}

std::string location_text(mesh::Index cell, const model::Case& input) {
    if (cell < 0) return "in an unknown cell";
    mesh::Point centre{};
    const auto nodes = input.mesh.cell_nodes(cell);
    for (const auto node : nodes)
        for (int i = 0; i < 3; ++i) centre[i] += input.mesh.point(node)[i] / static_cast<double>(nodes.size());
    const char* second = input.kinematics == model::Kinematics::axisymmetric ? "r" : "y";
    std::string text = "in cell " + std::to_string(cell) + " at x = " + short_text(1e3 * centre[0]) + " mm, " + second +
                       " = " + short_text(1e3 * centre[1]) + " mm";
    if (input.mesh.dimension == 3) text += ", z = " + short_text(1e3 * centre[2]) + " mm";
    return text + " of the undeformed part";
}

std::string attempt_text(double step, double next, const NewtonResult& result) {
    return "step of " + short_text(step) + " failed (" + std::string(text_of(result.end)) + ", " +
           core::counted(result.iterations, "iteration") + ", " + core::counted(result.halvings, "halving") +
           " of the line search, residual " + short_text(result.residual) + ", min det F " +
           short_text(result.min_jacobian) + "): cut to " + short_text(next);
}

std::string row_text(const PathPoint& point, const PredictorError& error, int iterations) {
    const auto& modes = point.tangent.unstable_modes;
    return ", predictor error " + short_text(error.state) + " (load " + short_text(error.load) + "), " +
           core::counted(iterations, "iteration") + (modes ? ", unstable modes " + std::to_string(*modes) : "");
}

}  // namespace soft::solver
