/// Gmsh meshes.
#include "geometry/import.hpp"
#include "target.hpp"

void soft::fuzz::read(std::span<const std::byte> bytes) {
    const geometry::MshFile file = geometry::read_msh(text_of(bytes), "fuzz.msh");
    static_cast<void>(geometry::import_mesh(file, "fuzz.msh", 1e-3));
}
