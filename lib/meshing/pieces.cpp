#include "meshing/pieces.hpp"

#include <algorithm>
#include <map>

#include "mesh/disjoint_sets.hpp"

namespace soft::meshing {
namespace {

using mesh::Index;

/// Groups the facets by connected piece.
std::vector<std::vector<mesh::Facet>> pieces_of(const mesh::Mesh& mesh, const std::vector<mesh::Facet>& facets) {
    mesh::DisjointSets groups(facets.size());
    std::map<Index, std::size_t> first_at;  // node -> a facet there
    for (std::size_t f = 0; f < facets.size(); ++f)
        for (const Index node : facet_nodes(mesh, facets[f]))
            groups.unite(first_at.try_emplace(node, f).first->second, f);
    std::map<std::size_t, std::vector<mesh::Facet>> pieces;
    for (std::size_t f = 0; f < facets.size(); ++f) pieces[groups.first(f)].push_back(facets[f]);
    std::vector<std::vector<mesh::Facet>> result;
    for (auto& [first, piece] : pieces) result.push_back(std::move(piece));
    return result;
}

mesh::Point lowest(const mesh::Mesh& mesh, const std::vector<mesh::Facet>& piece) {
    mesh::Point low = mesh.point(facet_nodes(mesh, piece.front()).front());
    for (const mesh::Facet& facet : piece)
        for (const Index node : facet_nodes(mesh, facet))
            for (std::size_t d = 0; d < 3; ++d) low[d] = std::min(low[d], mesh.point(node)[d]);
    return low;
}

}  // namespace

void name_pieces(mesh::Mesh& mesh) {
    const auto sets = mesh.facet_sets;
    for (const auto& [name, facets] : sets) {
        auto pieces = pieces_of(mesh, facets);
        if (pieces.size() < 2) continue;
        std::stable_sort(pieces.begin(), pieces.end(),
                         [&](const auto& a, const auto& b) { return lowest(mesh, a) < lowest(mesh, b); });
        for (std::size_t p = 0; p < pieces.size(); ++p)
            mesh.facet_sets.try_emplace(name + "_" + std::to_string(p + 1), std::move(pieces[p]));
    }
}

}  // namespace soft::meshing
