// The bellows under vacuum: the state of first self-contact for several meshes. There is no formula; path_test compares the contact with
// the deformed walls and the meshes with each other.
#include "core/text.hpp"
#include "problem.hpp"
#include "table.hpp"

namespace soft::verification {

std::vector<Problem> closing_wall_problems() {
    return {
        {"Actuators", "bellows under vacuum until walls touch", [] {
             Table table{"bellows under vacuum: mesh study",
                         "The last state before two parts of the wall touch.",
                         {"cells", "pressure [kPa]", "elongation [mm]", "stop reason"},
                         {}};
             for (const char* size : {"2 mm", "1.5 mm", "1 mm"}) {
                 const auto run = run_design("vacuum.yaml", {"path.contact=stop", std::string("mesh.size=") + size});
                 table.lines.push_back({size, printed_number(run.pressure_kPa()), printed_number(run.output_mm()),
                                        std::string(model::name(run.end.reason))});
             }
             return Outcome{{}, {table}};
         }}};
}

}  // namespace soft::verification
