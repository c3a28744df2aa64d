/// The outputs of a case: means of displacements, angles and shapes of faces. Reactions: reactions.cpp.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "fem/system.hpp"
#include "linalg/profile.hpp"
#include "model/face_symmetry.hpp"

namespace soft::fem {

void System::make_outputs() {
    const bool solid = input_.kinematics == model::Kinematics::solid;
    for (const auto& output : input_.outputs) {
        const auto require = [&output](bool possible) {
            if (!possible)
                throw Error(ExitCode::bad_input, "outputs." + output.name,
                            "this measure is available only in solid models", "use model: solid, half or quarter");
        };
        switch (output.measure) {
            case model::Measure::displacement: outputs_.emplace_back(make_linear(output, output.direction)); break;
            case model::Measure::radial:
                if (solid)
                    outputs_.emplace_back(make_shape(output));
                else
                    outputs_.emplace_back(make_linear(output, {0, 1, 0}));  // r is the second coordinate of a section
                break;
            case model::Measure::bend:
            case model::Measure::twist:
                require(input_.kinematics != model::Kinematics::axisymmetric);
                outputs_.emplace_back(make_rotation(output));
                break;
            case model::Measure::rotation:
            case model::Measure::curvature:
                require(solid);
                outputs_.emplace_back(make_shape(output));
                break;
            case model::Measure::force:
            case model::Measure::moment:
                if (input_.dynamics)
                    throw Error(ExitCode::bad_input, "outputs." + output.name,
                                "reactions are available only in static cases",
                                "remove dynamics, or use measure: displacement");
                outputs_.emplace_back(complete_reaction(output));
        }
    }
}

System::LinearOutput System::make_linear(const model::Output& output, const Vector3& direction) const {
    const auto mean = output.point_m ? point_displacement(input_, map_, output.name, *output.point_m, direction)
                                     : mean_displacement(input_, map_, output.face, direction);
    LinearOutput linear{assembled(mean), std::vector(input_.motions.size(), 0.0)};
    for (std::size_t i = 0; i < mean.dofs.size(); ++i)
        if (const int slot = motion_slot(mean.dofs[i]); slot >= 0)
            linear.by_motion[slot / 3] += mean.values[i] * *input_.motions[slot / 3].displacement_m[slot % 3];
    return linear;
}

Rotation System::make_rotation(const model::Output& output) {
    Rotation rotation{output.measure, output.direction, {}, {}, 0.0};
    const auto fill = [&](RotationFace& face, const std::string& name) {
        face.facets = face_cells(input_, map_, name, rank_, tables_);
        for (const auto& facet : face.facets) {
            const auto& reference = tables_[facet.reference];
            std::vector<double> X(reference.dofs()), weights(reference.nodes, 0.0);
            for (int i = 0; i < input_.mesh.dimension; ++i)
                for (int a = 0; a < reference.nodes; ++a)
                    X[i * reference.nodes + a] = input_.mesh.point(facet.nodes[a])[i];
            (void)fem::facet_area(reference, input_.kinematics, X, weights);
            face.weights.push_back(std::move(weights));
        }
    };
    fill(rotation.face, output.face);
    if (output.measure == model::Measure::bend) fill(rotation.reference, output.reference);
    return rotation;
}

/// The nodes and their unknowns on rank 0, which evaluates them alone; empty on other ranks.
SurfaceCell System::nodes_on_rank_0(std::span<const mesh::Index> nodes) const {
    SurfaceCell cell;
    if (rank_ != 0) return cell;
    cell.nodes.assign(nodes.begin(), nodes.end());
    map_.node_dofs(cell.nodes, cell.dofs);
    return cell;
}

System::ShapeOutput System::make_shape(const model::Output& output) {
    const auto symmetry = model::face_symmetry(input_.mesh, {input_.kinematics, input_.symmetry_planes}, output.face);
    const FaceWeights weights = face_weights(input_, output.face);
    ShapeOutput shape{{output.measure, output.direction, {}, {}}, nodes_on_rank_0(weights.nodes), {}};
    for (std::size_t mirrors = 0; mirrors < 8; ++mirrors) {
        Vector3 signs{1, 1, 1};
        bool wanted = true;
        for (std::size_t i = 0; i < 3; ++i)
            if ((mirrors >> i & 1U) != 0) {
                signs[i] = -1;
                wanted = wanted && symmetry.mirrored[i];
            }
        for (std::size_t a = 0; a < shape.at_nodes.nodes.size() && wanted; ++a) {
            const auto& X = input_.mesh.point(shape.at_nodes.nodes[a]);
            shape.images.push_back({a, signs});
            shape.shape.X.push_back({signs[0] * X[0], signs[1] * X[1], signs[2] * X[2]});
            shape.shape.weights.push_back(weights.weights_m2[a]);
        }
    }
    return shape;
}

double System::output(std::size_t index, Vec x, Vec gradient, LoadLevels* by_levels) {
    const linalg::ScopedTimer timed(linalg::Phase::measures);
    if (by_levels != nullptr) *by_levels = no_loads(input_);
    const std::span<double> by_motion =
        by_levels != nullptr ? std::span<double>(by_levels->motions) : std::span<double>();
    const OutputForm& form = outputs_.at(index);
    if (const auto* angle = std::get_if<Rotation>(&form)) return rotation(*angle, x, gradient, by_motion);
    if (const auto* of_face = std::get_if<ShapeOutput>(&form)) return shape(*of_face, x, gradient, by_motion);
    if (const auto* force = std::get_if<Reaction>(&form)) return reaction(*force, x, gradient, by_levels);
    const auto& linear = std::get<LinearOutput>(form);
    if (gradient != nullptr) linalg::copy(linear.weights, gradient);
    if (!by_motion.empty()) std::ranges::copy(linear.by_motion, by_motion.begin());
    double value = linalg::dot(linear.weights, x);
    for (std::size_t m = 0; m < levels_.motions.size(); ++m) value += levels_.motions[m] * linear.by_motion[m];
    return value;
}

double System::rotation(const Rotation& rotation, Vec x, Vec gradient, std::span<double> by_motion) {
    if (gradient != nullptr) SOFT_PETSC(VecZeroEntries(gradient));
    read_state(x);
    struct Share {
        const SurfaceCell* facet;
        std::array<std::vector<double>, 2> slopes;
    };
    std::vector<double> position, X;
    double angle = 0;
    for (const auto* face : {&rotation.face, &rotation.reference}) {
        if (face == &rotation.reference && rotation.measure != model::Measure::bend) continue;
        Phasor phasor{};
        std::vector<Share> shares;
        for (std::size_t f = 0; f < face->facets.size(); ++f) {
            const auto& facet = face->facets[f];
            gather_surface(facet, position);
            gather_undeformed(facet, X);
            Share& share = shares.emplace_back(Share{&facet, {}});
            add_phasor(rotation, input_.kinematics, tables_[facet.reference], position, X, face->weights[f], phasor,
                       share.slopes);
        }
        MPI_Allreduce(MPI_IN_PLACE, phasor.data(), 2, MPI_DOUBLE, MPI_SUM, comm_);
        const double sign = face == &rotation.reference ? -1.0 : 1.0;
        if (face == &rotation.reference)
            for (double& component : phasor) component = -component;  // from the inward normal of the reference face
        const PhasorAngle turned = angle_of(phasor);
        angle += sign * turned.angle;
        for (auto& share : shares) {
            for (std::size_t i = 0; i < share.slopes[0].size(); ++i)  // both signs of a reference face cancel
                share.slopes[0][i] = turned.slope[0] * share.slopes[0][i] + turned.slope[1] * share.slopes[1][i];
            add_slope(gradient, by_motion, share.facet->dofs, share.slopes[0]);
        }
    }
    finish_slope(gradient, by_motion);
    return std::remainder(angle - rotation.undeformed, 2.0 * std::numbers::pi);
}

double System::shape(const ShapeOutput& output, Vec x, Vec gradient, std::span<double> by_motion) {
    if (gradient != nullptr) SOFT_PETSC(VecZeroEntries(gradient));
    read_state(x);
    double value = 0;
    if (rank_ == 0) {
        const std::size_t n = output.at_nodes.nodes.size();
        std::vector<double> position, slope(3 * n, 0.0);
        gather_surface(output.at_nodes, position);
        std::vector<Vector3> points, by_points;
        for (const auto& image : output.images)
            points.push_back({image.signs[0] * position[image.node], image.signs[1] * position[n + image.node],
                              image.signs[2] * position[2 * n + image.node]});
        const bool wanted = gradient != nullptr || !by_motion.empty();
        value = value_of(output.shape, points, wanted ? &by_points : nullptr);
        for (std::size_t k = 0; k < by_points.size(); ++k)
            for (std::size_t i = 0; i < 3; ++i)
                slope[i * n + output.images[k].node] += output.images[k].signs[i] * by_points[k][i];
        add_slope(gradient, by_motion, output.at_nodes.dofs, slope);
    }
    finish_slope(gradient, by_motion);
    MPI_Bcast(&value, 1, MPI_DOUBLE, 0, comm_);
    return value;
}

}  // namespace soft::fem
