#include "run_design.hpp"

#include <chrono>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "contact/contact.hpp"
#include "design/design.hpp"
#include "fem/system.hpp"
#include "geometry/build.hpp"
#include "geometry/family.hpp"
#include "post/curve.hpp"
#include "post/interpolate.hpp"
#include "solver/motion.hpp"

namespace soft::verification {
namespace {

std::string read_text(const std::string& path) {
    std::ifstream stream(path);
    if (!stream) throw std::runtime_error("cannot read " + path);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
}

std::string describe(const model::Case& input, PetscInt unknowns) {
    std::map<std::string, int> counts;
    for (const auto type : input.mesh.cell_types) ++counts[std::string(mesh::topology(type).name)];
    std::string text;
    for (const auto& [name, count] : counts) text += (text.empty() ? "" : " + ") + std::to_string(count) + ' ' + name;
    return text + ", " + std::to_string(unknowns) + " unknowns";
}

post::Curve curve_of(const Run& run) { return post::make_curve(run.model, run.steps); }

/// Name of the column of the leading load.
std::string leading_quantity(const model::Case& input) {
    switch (model::leading_load(input)) {
        case model::LeadingLoad::pressure: return "pressure";
        case model::LeadingLoad::traction: return "traction";
        case model::LeadingLoad::force: return "load";
        case model::LeadingLoad::load_factor: return "load_factor";
    }
    throw std::logic_error("leading_quantity");
}

/// For one rank only.
solver::ContactCheck contact_check(fem::System& system) {
    if (system.input().path.contact == model::Contact::ignore) return {};
    // std::function requires a copyable target, but a finder cannot be copied.
    const auto finder = std::make_shared<const contact::ContactFinder>(system.input());
    return [&system, finder](Vec x) -> std::optional<solver::ContactEvent> {
        const auto contact = finder->find(system.fields().gather(x).displacement_m, system.contact().shifts(x));
        if (!contact) return std::nullopt;
        return solver::ContactEvent{contact->text, contact->is_inverted ? model::StopReason::inverted_element
                                                                        : model::StopReason::self_contact};
    };
}

}  // namespace

model::Case read_case(const std::string& design, const std::vector<std::string>& sets) {
    const std::string path = std::string(SOFT_SOURCE_DIR) + "/designs/" + design;
    std::vector<design::Override> overrides;
    for (const auto& set : sets) overrides.push_back(design::parse_override(set));
    return geometry::build_case(design::read_design(read_text(path), path, geometry::catalogue_keys(), overrides));
}

Run run_design(const std::string& design, const std::vector<std::string>& sets, Energy energy) {
    const auto begin = std::chrono::steady_clock::now();
    Run run;
    run.model = read_case(design, sets);
    fem::System system(run.model, PETSC_COMM_WORLD);
    const auto sink = [&](const model::Step& step, Vec x) {
        run.steps.push_back(step);
        run.displacement_m = system.fields().gather(x).displacement_m;
        if (energy == Energy::recorded)
            run.energy_J.push_back(system.fields().stored_energy(x) / run.model.model_fraction);
    };
    const solver::Listeners listeners{.step = sink, .contact = contact_check(system)};
    run.end = run.model.dynamics ? solver::integrate_motion(system, listeners) : solver::follow_path(system, listeners);
    if (run.end.reason == model::StopReason::diverged)
        throw std::runtime_error(design + ": the path diverged: " + run.end.detail);
    run.mesh = describe(run.model, system.dofs().total);
    run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return run;
}

bool Run::reaches(const std::string& quantity, double value) const {
    const auto curve = curve_of(*this);
    const post::Column* column = curve.find(quantity);
    if (column == nullptr) throw std::runtime_error("the path has no " + quantity);
    const auto index = static_cast<std::size_t>(column - curve.columns.data());
    return !post::Path(curve).crossings(index, value / column->SI_per_unit).empty();
}

Run::Point Run::at(const std::string& quantity, double value) const {
    const auto curve = curve_of(*this);
    const post::Column* column = curve.find(quantity);
    if (column == nullptr) throw std::runtime_error("the path has no " + quantity);
    const post::Path path(curve);
    const auto index = static_cast<std::size_t>(column - curve.columns.data());
    const auto crossings = path.crossings(index, value / column->SI_per_unit);
    if (crossings.empty()) throw std::runtime_error("the path never has this " + quantity);
    const auto row = path.at(crossings.front());
    const auto SI = [&](const std::string& name) {
        const post::Column* wanted = curve.find(name);
        return row[static_cast<std::size_t>(wanted - curve.columns.data())] * wanted->SI_per_unit;
    };
    Point point{.pressure_Pa = SI(leading_quantity(model)), .outputs = {}, .volume_m3 = {}, .volumes_m3 = {}};
    for (const auto& output : model.outputs) point.outputs.push_back(SI(output.name));
    if (curve.find("volume") != nullptr) point.volume_m3 = SI("volume");
    const auto cavities = model::measured_cavities(model);
    if (cavities.size() > 1)
        for (const auto* cavity : cavities) point.volumes_m3.push_back(SI("volume_" + cavity->name));
    return point;
}

std::size_t nearest_node(const Run& run, const std::array<double, 3>& position_m) {
    std::size_t best = 0;
    double nearest = -1;
    for (std::size_t node = 0; node < run.model.mesh.points.size(); ++node) {
        double distance = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double d = run.model.mesh.points[node][i] - position_m[i];
            distance += d * d;
        }
        if (nearest < 0 || distance < nearest) {
            best = node;
            nearest = distance;
        }
    }
    return best;
}

}  // namespace soft::verification
