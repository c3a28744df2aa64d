#include "model/location.hpp"

#include "core/text.hpp"

namespace soft::model {

std::string location_text(Kinematics kinematics, const mesh::Point& position_m) {
    const auto millimetres = [&](std::size_t d) { return core::rounded_text(position_m[d] * 1e3, 4) + " mm"; };
    const std::string x = "x = " + millimetres(0);
    if (kinematics == Kinematics::axisymmetric) return x + ", r = " + millimetres(1);
    const std::string xy = x + ", y = " + millimetres(1);
    return kinematics == Kinematics::plane_strain ? xy : xy + ", z = " + millimetres(2);
}

std::string contact_text(const Case& input, const FirstContact& contact) {
    const std::string what = contact.obstacle < 0
                                 ? "the actuator touches itself"
                                 : "the actuator touches the obstacle '" +
                                       input.obstacles[static_cast<std::size_t>(contact.obstacle)].name + "'";
    return what + " at " + location_text(input.kinematics, contact.location_m) + " of the undeformed part";
}

}  // namespace soft::model
