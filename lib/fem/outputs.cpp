#include "fem/outputs.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "linalg/profile.hpp"
#include "model/face_symmetry.hpp"

namespace soft::fem {

Outputs::Outputs(const Discretization& fe, const Loads& loads, Contact& contact, LocalState& state)
    : fe_(fe), loads_(loads), contact_(contact), state_(state) {
    for (const auto& output : fe.input.outputs) forms_.push_back(make(output));
}

Outputs::Form Outputs::make(const model::Output& output) const {
    const bool solid = fe_.input.kinematics == model::Kinematics::solid;
    const auto require = [&output](bool possible) {
        if (!possible)
            throw Error(ExitCode::bad_input, "outputs." + output.name, "this measure is available only in solid models",
                        "use model: solid, half or quarter");
    };
    if (!output.obstacle.empty() && output.measure == model::Measure::displacement) return make_obstacle_motion(output);
    if (!output.obstacle.empty()) return make_contact(output);
    switch (output.measure) {
        case model::Measure::displacement: return make_mean(output, output.direction);
        case model::Measure::radial:
            if (solid) return make_whole_face(output);
            return make_mean(output, {0, 1, 0});  // r is the second coordinate of a section
        case model::Measure::bend:
        case model::Measure::twist:
            require(fe_.input.kinematics != model::Kinematics::axisymmetric);
            return make_rotation(fe_, output, state_);
        case model::Measure::rotation:
        case model::Measure::curvature: require(solid); return make_whole_face(output);
        case model::Measure::force:
        case model::Measure::moment:
        case model::Measure::contact_area:
        case model::Measure::contact_pressure: break;
    }
    if (fe_.input.dynamics)
        throw Error(ExitCode::bad_input, "outputs." + output.name, "reactions are available only in static cases",
                    "remove dynamics, or use measure: displacement");
    return make_reaction(fe_, loads_, output);
}

Outputs::Mean Outputs::make_mean(const model::Output& output, const Vector3& direction) const {
    const auto weights = output.point_m
                             ? point_displacement(fe_.input, fe_.dofs, output.name, *output.point_m, direction)
                             : mean_displacement(fe_.input, fe_.dofs, output.face, direction);
    Mean mean{fe_.make_vector(weights), std::vector(fe_.input.motions.size(), 0.0)};
    for (std::size_t i = 0; i < weights.dofs.size(); ++i)
        if (const int slot = motion_slot(weights.dofs[i]); slot >= 0)
            mean.by_motion[slot / 3] += weights.values[i] * fe_.moved_by(weights.dofs[i]);
    return mean;
}

Outputs::Mean Outputs::make_obstacle_motion(const model::Output& output) const {
    Mean mean{fe_.make_vector(), {}};
    for (const model::Motion& motion : fe_.input.motions) {
        double along = 0;
        for (std::size_t i = 0; i < 3 && motion.face == output.obstacle; ++i)
            along += output.direction[i] * motion.displacement_m[i].value_or(0);
        mean.by_motion.push_back(along);
    }
    return mean;
}

Outputs::WholeFace Outputs::make_whole_face(const model::Output& output) const {
    const model::Case& input = fe_.input;
    const auto symmetry = model::face_symmetry(input.mesh, {input.kinematics, input.symmetry_planes}, output.face);
    const auto weights = model::face_weights(input.mesh, input.kinematics, output.face);
    WholeFace face{{output.measure, output.direction, {}, {}}, nodes_on_rank_0(fe_, weights.nodes), {}};
    for (std::size_t mirrors = 0; mirrors < 8; ++mirrors) {
        Vector3 signs{1, 1, 1};
        bool wanted = true;
        for (std::size_t i = 0; i < 3; ++i)
            if ((mirrors >> i & 1U) != 0) {
                signs[i] = -1;
                wanted = wanted && symmetry.mirrored[i];
            }
        for (std::size_t a = 0; a < face.at_nodes.nodes.size() && wanted; ++a) {
            const auto& X = input.mesh.point(face.at_nodes.nodes[a]);
            face.images.push_back({a, signs});
            face.shape.X.push_back({signs[0] * X[0], signs[1] * X[1], signs[2] * X[2]});
            face.shape.weights.push_back(weights.weights_m2[a]);
        }
    }
    return face;
}

double Outputs::value(std::size_t index, Vec x, Vec gradient, LoadLevels* by_levels) {
    const linalg::ScopedTimer timed(linalg::Phase::measures);
    if (by_levels != nullptr) *by_levels = no_loads(fe_.input);
    const std::span<double> by_motion =
        by_levels != nullptr ? std::span<double>(by_levels->motions) : std::span<double>();
    const Form& form = forms_.at(index);
    if (const auto* linear = std::get_if<Mean>(&form)) return mean(*linear, x, gradient, by_motion);
    state_.read(x);
    if (const auto* of_contact = std::get_if<ContactMeasure>(&form)) {
        Slopes slopes(fe_, gradient, by_motion);
        return contact(*of_contact, slopes);
    }
    if (const auto* of_face = std::get_if<Reaction>(&form)) return reaction(*of_face, gradient, by_levels);
    Slopes slopes(fe_, gradient, by_motion);
    const auto* angle = std::get_if<Rotation>(&form);
    const double value =
        angle != nullptr ? value_of(*angle, fe_, state_, slopes) : shape(std::get<WholeFace>(form), slopes);
    slopes.finish();
    return value;
}

Outputs::ContactMeasure Outputs::make_contact(const model::Output& output) const {
    const auto& obstacles = fe_.input.obstacles;
    const auto known = std::ranges::find(obstacles, output.obstacle, &model::Obstacle::name);
    ContactMeasure made{output.measure, static_cast<std::size_t>(known - obstacles.begin()), output.direction};
    for (std::size_t i = 0; i < 3; ++i)  // across a symmetry plane: on one of the obstacle and its image
        if (fe_.input.symmetry_planes[i]) made.direction[i] *= 0.5;
    return made;
}

double Outputs::contact(const ContactMeasure& output, Slopes& slopes) const {
    double force = 0;
    std::vector<double> slope;
    const auto summary = contact_.evaluate(
        slopes.wanted() ? contact::Wanted::hessian : contact::Wanted::gradient,
        [&](std::span<const PetscInt> dofs, const contact::Block& block) {
            if (output.measure != model::Measure::force || block.obstacle != static_cast<int>(output.obstacle)) return;
            const std::size_t n = block.points(), size = dofs.size();
            slope.assign(slopes.wanted() ? size : 0, 0.0);
            for (std::size_t i = 0; i < block.dimension; ++i) {
                const std::size_t row = i * n + n - 1;  // the obstacle's displacement
                force -= output.direction[i] * block.gradient[row];
                for (std::size_t j = 0; j < slope.size(); ++j)
                    slope[j] -= output.direction[i] * block.hessian[row * size + j] / fe_.input.model_fraction;
            }
            if (slopes.wanted()) slopes.add(dofs, slope);
        });
    slopes.finish();
    MPI_Allreduce(MPI_IN_PLACE, &force, 1, MPI_DOUBLE, MPI_SUM, fe_.comm);
    if (output.measure == model::Measure::contact_pressure) return summary.pressure_Pa[output.obstacle];
    return (output.measure == model::Measure::contact_area ? summary.area_m2[output.obstacle] : force) /
           fe_.input.model_fraction;
}

double Outputs::mean(const Mean& output, Vec x, Vec gradient, std::span<double> by_motion) const {
    if (gradient != nullptr) linalg::copy(output.weights, gradient);
    if (!by_motion.empty()) std::ranges::copy(output.by_motion, by_motion.begin());
    double value = linalg::dot(output.weights, x);
    for (std::size_t m = 0; m < output.by_motion.size(); ++m) value += state_.levels().motions[m] * output.by_motion[m];
    return value;
}

double Outputs::shape(const WholeFace& output, Slopes& slopes) const {
    double value = 0;
    if (fe_.rank == 0) {
        const std::size_t n = output.at_nodes.nodes.size();
        std::vector<double> x, slope(3 * n, 0.0);
        state_.positions(output.at_nodes, x);
        std::vector<Vector3> points, by_points;
        for (const auto& image : output.images)
            points.push_back({image.signs[0] * x[image.node], image.signs[1] * x[n + image.node],
                              image.signs[2] * x[2 * n + image.node]});
        value = value_of(output.shape, points, slopes.wanted() ? &by_points : nullptr);
        for (std::size_t k = 0; k < by_points.size(); ++k)
            for (std::size_t i = 0; i < 3; ++i)
                slope[i * n + output.images[k].node] += output.images[k].signs[i] * by_points[k][i];
        slopes.add(output.at_nodes.dofs, slope);
    }
    MPI_Bcast(&value, 1, MPI_DOUBLE, 0, fe_.comm);
    return value;
}

double Outputs::reaction(const Reaction& output, Vec gradient, LoadLevels* by_levels) const {
    std::vector<double> none;
    Slopes slopes(fe_, gradient, by_levels != nullptr ? by_levels->motions : none);
    double value = output.copies * own_value(output, {fe_, loads_, contact_, state_}, slopes, by_levels);
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_SUM, fe_.comm);
    slopes.finish();
    if (gradient != nullptr) SOFT_PETSC(VecScale(gradient, output.copies));
    if (by_levels == nullptr) return value;
    for (auto* list : {&by_levels->pressures_Pa, &by_levels->dead_loads, &by_levels->motions}) {
        for (double& slope : *list) slope *= output.copies;
        if (!list->empty() && list != &by_levels->motions)  // those have been summed
            MPI_Allreduce(MPI_IN_PLACE, list->data(), static_cast<int>(list->size()), MPI_DOUBLE, MPI_SUM, fe_.comm);
    }
    return value;
}

}  // namespace soft::fem
