#include "meshing/surface_file.hpp"

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>

#include "core/text.hpp"
#include "meshing/body_surface.hpp"
#include "surface/facet_map.hpp"

namespace soft::meshing {
namespace {

constexpr double mm = 1e3;

template <class T>
void append(core::Bytes& bytes, const T& value) {
    static_assert(std::endian::native == std::endian::little, "STL is little-endian");
    const auto* first = reinterpret_cast<const std::byte*>(&value);
    bytes.insert(bytes.end(), first, first + sizeof(T));
}

/// Binary STL: 80 bytes of title, the number of triangles, and for each triangle its normal, its corners and two unused bytes.
core::Bytes stl(const surface::Triangles& surface) {
    std::string title = "soft-actuator, mm";  // must not begin with "solid", as ASCII files do
    title.resize(80, ' ');
    core::Bytes bytes;
    bytes.reserve(84 + 50 * surface.triangles.size());
    for (const char c : title) append(bytes, c);
    append(bytes, static_cast<std::uint32_t>(surface.triangles.size()));
    for (const auto& t : surface.triangles) {
        for (const double component : triangle_geometry(surface.points, t).normal)
            append(bytes, static_cast<float>(component));
        for (const int corner : t)
            for (const double component : surface.points[static_cast<std::size_t>(corner)])
                append(bytes, static_cast<float>(mm * component));
        append(bytes, std::uint16_t{0});
    }
    return bytes;
}

core::Bytes obj(const surface::Triangles& surface) {
    std::string text = "# soft-actuator, mm\n";
    for (const mesh::Point& p : surface.points) {
        text += 'v';
        for (const double component : p) text.append(1, ' ').append(core::number_text(mm * component));
        text += '\n';
    }
    for (const auto& t : surface.triangles) {
        text += 'f';
        for (const int corner : t) text.append(1, ' ').append(std::to_string(corner + 1));
        text += '\n';
    }
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

}  // namespace

Error surface_format_error(const std::filesystem::path& path) {
    return Error(ExitCode::usage, path.string(), "surfaces are written as STL or OBJ",
                 "use a name that ends in .stl or .obj");
}

core::Bytes surface_file(const surface::Triangles& surface, const std::filesystem::path& path) {
    if (!is_surface_file(path)) throw surface_format_error(path);
    const std::string ending = path.extension().string();
    return ending[1] == 's' || ending[1] == 'S' ? stl(surface) : obj(surface);
}

}  // namespace soft::meshing
