#include "view/vtu.hpp"

#include <bit>
#include <cstdint>
#include <pugixml.hpp>
#include <sstream>

#include "core/hash.hpp"
#include "core/text.hpp"

namespace soft::view {

namespace {

static_assert(std::endian::native == std::endian::little, "the files are declared little endian");

/// VTK's inline binary format: the number of bytes followed by the bytes, encoded together in base64.
template <class T>
void add_array(pugi::xml_node parent, const char* type, const std::string& name, int components,
               const std::vector<T>& values) {
    pugi::xml_node node = parent.append_child("DataArray");
    node.append_attribute("type") = type;
    node.append_attribute("Name") = name.c_str();
    if (components > 1) node.append_attribute("NumberOfComponents") = components;
    node.append_attribute("format") = "binary";
    const std::uint64_t bytes = values.size() * sizeof(T);
    const auto head = std::as_bytes(std::span{&bytes, 1});
    const auto body = std::as_bytes(std::span{values});
    std::vector<std::byte> whole(head.begin(), head.end());
    whole.insert(whole.end(), body.begin(), body.end());
    node.text().set(core::base64(whole).c_str());
}

void add_arrays(pugi::xml_node parent, std::span<const model::NamedArray> arrays) {
    for (const model::NamedArray& array : arrays)
        add_array(parent, "Float64", array.name, array.components, array.values);
}

void add_cells(pugi::xml_node parent, const mesh::Mesh& mesh, const post::RegionPoints& region_points) {
    std::vector<std::int64_t> connectivity(region_points.connectivity.begin(), region_points.connectivity.end());
    std::vector<std::int64_t> offsets(mesh.offsets.begin() + 1, mesh.offsets.end());
    std::vector<std::uint8_t> types;
    for (const mesh::CellType type : mesh.cell_types) types.push_back(static_cast<std::uint8_t>(type));
    add_array(parent, "Int64", "connectivity", 1, connectivity);
    add_array(parent, "Int64", "offsets", 1, offsets);
    add_array(parent, "UInt8", "types", 1, types);
}

pugi::xml_node begin(pugi::xml_document& document, const char* type) {
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    pugi::xml_node file = document.append_child("VTKFile");
    file.append_attribute("type") = type;
    file.append_attribute("version") = "1.0";
    file.append_attribute("byte_order") = "LittleEndian";
    file.append_attribute("header_type") = "UInt64";
    return file;
}

std::string text_of(const pugi::xml_document& document) {
    std::ostringstream out;
    document.save(out, " ");
    return std::move(out).str();
}

}  // namespace

std::string vtu_text(const mesh::Mesh& mesh, const post::RegionPoints& region_points,
                     std::span<const model::NamedArray> at_points, std::span<const model::NamedArray> at_cells) {
    std::vector<double> positions;
    for (const mesh::Index node : region_points.node) {
        const mesh::Point& x = mesh.point(node);
        positions.insert(positions.end(), x.begin(), x.end());
    }
    pugi::xml_document document;
    pugi::xml_node piece = begin(document, "UnstructuredGrid").append_child("UnstructuredGrid").append_child("Piece");
    piece.append_attribute("NumberOfPoints") = static_cast<unsigned long long>(region_points.size());
    piece.append_attribute("NumberOfCells") = static_cast<unsigned long long>(mesh.cell_types.size());
    pugi::xml_node points = piece.append_child("PointData");
    points.append_attribute("Vectors") = "displacement_m";
    add_arrays(points, at_points);
    pugi::xml_node cells = piece.append_child("CellData");
    add_arrays(cells, at_cells);
    add_array(cells, "Int32", "region", 1, mesh.cell_regions);
    add_array(piece.append_child("Points"), "Float64", "Points", 3, positions);
    add_cells(piece.append_child("Cells"), mesh, region_points);
    return text_of(document);
}

std::string pvd_text(std::span<const SeriesEntry> entries) {
    pugi::xml_document document;
    pugi::xml_node collection = begin(document, "Collection").append_child("Collection");
    for (const SeriesEntry& entry : entries) {
        pugi::xml_node set = collection.append_child("DataSet");
        set.append_attribute("timestep") = core::number_text(entry.time).c_str();
        set.append_attribute("part") = "0";
        set.append_attribute("file") = entry.file.c_str();
    }
    return text_of(document);
}

}  // namespace soft::view
