#pragma once
/// The outputs of a case (model::Measure): means of displacements, angles (fem/rotation.hpp) and shapes (fem/face_shape.hpp) of faces,
/// the reactions of constrained faces (fem/reaction.hpp), and measures of contact (fem/contact.hpp). Tested by fem/loads_test, fem/face_shape_test, fem/reaction_test.
#include <variant>
#include <vector>

#include "fem/face_shape.hpp"
#include "fem/reaction.hpp"
#include "fem/rotation.hpp"

namespace soft::fem {

class Outputs {
public:
    /// All four must outlive this object. Throws Error (bad_input, location outputs.<name>) for a measure that the case cannot have.
    Outputs(const Discretization& fe, const Loads& loads, Contact& contact, LocalState& state);

    /// Value (SI, model::unit_of) under the levels last prescribed; `gradient` by x and the derivatives by the levels are overwritten;
    /// nullptr if not needed. Angles lie in (-pi, pi]. Collective.
    double value(std::size_t index, Vec x, Vec gradient, LoadLevels* by_levels = nullptr);
    [[nodiscard]] std::size_t count() const noexcept { return forms_.size(); }

private:
    struct Mean {
        linalg::Vector weights;
        std::vector<double> by_motion;
    };
    /// The whole face, its mirror images included, as node and the sign of its components. On rank 0 only.
    struct WholeFace {
        FaceShape shape;
        SurfaceCell at_nodes;  // of the mesh
        struct Image {
            std::size_t node;
            Vector3 signs;
        };
        std::vector<Image> images;  // by FaceShape::X
    };
    /// Force on an obstacle (the derivative of the energy of contact by its displacement), contact area or largest contact pressure, which
    /// have no derivatives.
    struct ContactMeasure {
        model::Measure measure;
        std::size_t obstacle;  // the number of obstacles: the actuator itself
        Vector3 direction;     // its part that does not cancel by symmetry
    };
    using Form = std::variant<Mean, Rotation, WholeFace, Reaction, ContactMeasure>;

    [[nodiscard]] Form make(const model::Output& output) const;
    [[nodiscard]] Mean make_mean(const model::Output& output, const Vector3& direction) const;
    [[nodiscard]] Mean make_obstacle_motion(const model::Output& output) const;
    [[nodiscard]] WholeFace make_whole_face(const model::Output& output) const;
    double mean(const Mean& output, Vec x, Vec gradient, std::span<double> by_motion) const;
    double shape(const WholeFace& output, Slopes& slopes) const;
    [[nodiscard]] ContactMeasure make_contact(const model::Output& output) const;
    double contact(const ContactMeasure& output, Slopes& slopes) const;
    double reaction(const Reaction& output, Vec gradient, LoadLevels* by_levels) const;

    const Discretization& fe_;
    const Loads& loads_;
    Contact& contact_;
    LocalState& state_;
    std::vector<Form> forms_;  // by Case::outputs
};

}  // namespace soft::fem
