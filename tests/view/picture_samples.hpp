#pragma once
/// A unit cube that is pulled, seen from the front.
#include <filesystem>

#include "../assembly/block_mesh.hpp"
#include "view/picture.hpp"

namespace soft::view::test {

struct Cube {
    model::Case model =
        block_case(mesh::CellType::hex8, model::Kinematics::solid, model::Formulation::displacement, {.n = 1});
    fields::RegionPoints places = fields::region_points(model.mesh);
    Skin skin = make_skin(model, places, {});
    Body body{skin, base_positions(skin, model, places, {})};
    Look look{.quantity = fields::Quantity::stretch,
              .camera = {},
              .range = Range{1.0, 2.0},
              .width_px = 400,
              .height_px = 300};

    /// Twice as long in x, with one value all over.
    [[nodiscard]] Shot pulled(double value, const std::string& title = "cube") const {
        std::vector<double> u;
        for (const Point& X : model.mesh.points) u.insert(u.end(), {X[0], 0, 0});
        return {base_positions(skin, model, places, u), std::vector<double>(skin.base_count(), value), title};
    }
};

inline std::filesystem::path fresh_folder(const char* name) {
    const auto folder = std::filesystem::path(::testing::TempDir()) / name;
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return folder;
}

}  // namespace soft::view::test
