/// Fuzz target: surfaces in STL and OBJ format, and their repair.
#include "meshing/body_surface.hpp"

#include <cmath>

#include "target.hpp"

void soft::fuzz::read(std::span<const std::byte> bytes) {
    for (const char* name : {"fuzz.stl", "fuzz.obj"})
        even_so([&] {
            const auto soup = meshing::read_soup(std::string{text_of(bytes)}, name);
            const meshing::BodySurface body = meshing::body_surface(soup, {.name = name});
            require(std::isfinite(body.volume_m3()) && std::isfinite(body.area_m2()), "volume and area are finite");
        });
}
