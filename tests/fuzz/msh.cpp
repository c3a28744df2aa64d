/// Fuzz target: Gmsh meshes.
#include "meshing/import.hpp"
#include "target.hpp"

void soft::fuzz::read(std::span<const std::byte> bytes) {
    const meshing::MshFile file = meshing::read_msh(text_of(bytes), "fuzz.msh");
    static_cast<void>(meshing::import_mesh(file, "fuzz.msh", 1e-3));
}
