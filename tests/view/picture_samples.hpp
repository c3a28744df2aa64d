#pragma once
/// A unit cube in tension, seen from the front.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "../core/path_variable.hpp"
#include "../fem/block_mesh.hpp"
#include "view/picture.hpp"

namespace soft::view::test {

struct Cube {
    model::Case model =
        block_case(mesh::CellType::hex8, model::Kinematics::solid, model::Formulation::displacement, {.n = 1});
    post::RegionPoints region_points = post::make_region_points(model.mesh);
    Skin skin = make_skin(model, region_points, {});
    Body body{skin, base_positions(skin, model, region_points, {})};
    PictureStyle look{
        .quantity = post::Quantity::stretch, .camera = {}, .range = Range{1.0, 2.0}, .width_px = 400, .height_px = 300};

    /// Stretched to twice its length in x, with a uniform field value.
    [[nodiscard]] Shot pulled(double value, const std::string& title = "cube") const {
        std::vector<double> u;
        for (const Point& X : model.mesh.points) u.insert(u.end(), {X[0], 0, 0});
        return {base_positions(skin, model, region_points, u), std::vector<double>(skin.base_count(), value), title};
    }
};

inline std::filesystem::path fresh_folder(const char* name) {
    const auto folder = std::filesystem::path(::testing::TempDir()) / name;
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return folder;
}

/// The path of a program, or an empty path.
inline std::filesystem::path program(const std::string& name) {
    const std::string path = std::getenv("PATH") ? std::getenv("PATH") : "";
    for (std::size_t start = 0; start <= path.size();) {
        const std::size_t end = std::min(path.find(':', start), path.size());
        const auto file = std::filesystem::path(path.substr(start, end - start)) / name;
        if (std::filesystem::exists(file)) return file;
        start = end + 1;
    }
    return {};
}

/// Writes an executable shell script.
inline void write_program(const std::filesystem::path& file, const std::string& lines) {
    std::ofstream(file) << "#!/bin/sh\n" << lines << "\n";
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
}

using soft::test::PathVariable;

}  // namespace soft::view::test
