#include "linalg/elimination_order.hpp"

#include <cholmod.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <string>
#include <unordered_map>
#include <utility>

#include "core/error.hpp"

namespace soft::linalg {

namespace {

static_assert(sizeof(PetscInt) == sizeof(int), "CHOLMOD's functions for int are used");

/// Groups of at most this many are not dissected further.
constexpr std::size_t smallest_part = 50;
/// A group that this many others dominate is left out of the dissection: those on the faces and inside of cells. Without edges, which the
/// two vertices at their ends dominate, the order of tetrahedra needs 10 to 20 % more flops.
constexpr int many_dominators = 3;

/// A group is dominated by a neighbour that couples with all of its other neighbours, and with more: eliminated just before that one, it
/// adds no couplings.
struct Dominated {
    std::vector<int> kept;                  ///< groups with few dominators
    std::vector<std::vector<int>> by_kept;  ///< [kept] the others that it dominates, those with few neighbours first

    /// Without the groups `last`.
    Dominated(const GroupGraph& graph, const std::vector<int>& last);
};

Dominated::Dominated(const GroupGraph& graph, const std::vector<int>& last) {
    const auto degree = [&](int group) { return graph.neighbours(group).size(); };
    const int count = static_cast<int>(graph.size());
    std::vector<int> dominators(graph.size(), 0), reached_by(graph.size(), -1);
    std::vector<std::vector<int>> dominated(graph.size());
    std::vector<bool> is_last(graph.size());
    for (const int group : last) is_last[static_cast<std::size_t>(group)] = true;
    for (int group = 0; group < count; ++group) {
        if (is_last[static_cast<std::size_t>(group)]) continue;
        const auto reaches = [&](int other) { return reached_by[static_cast<std::size_t>(other)] == group; };
        reached_by[static_cast<std::size_t>(group)] = group;
        for (const int other : graph.neighbours(group)) reached_by[static_cast<std::size_t>(other)] = group;
        for (const int other : graph.neighbours(group)) {
            if (degree(other) >= degree(group) || !std::ranges::all_of(graph.neighbours(other), reaches)) continue;
            ++dominators[static_cast<std::size_t>(other)];
            dominated[static_cast<std::size_t>(group)].push_back(other);
        }
    }
    const auto is_kept = [&](int group) { return dominators[static_cast<std::size_t>(group)] < many_dominators; };
    for (int group = 0; group < count; ++group) {
        if (!is_kept(group) || is_last[static_cast<std::size_t>(group)]) continue;
        kept.push_back(group);
        auto& others = by_kept.emplace_back(std::move(dominated[static_cast<std::size_t>(group)]));
        std::erase_if(others, [&](int other) { return is_kept(other) || is_last[static_cast<std::size_t>(other)]; });
        std::ranges::stable_sort(others, std::less(), degree);
    }
}

class Dissection {
public:
    Dissection() {
        cholmod_start(&common_);
        common_.print = 0;
        common_.method[common_.current].nd_compress = 0;  // GroupGraph is compressed already
        common_.method[common_.current].nd_small = smallest_part;
    }
    ~Dissection() {
        cholmod_free_sparse(&graph_, &common_);
        cholmod_finish(&common_);
    }
    Dissection(const Dissection&) = delete;
    Dissection& operator=(const Dissection&) = delete;

    /// Returns the indices of `kept` in elimination order.
    [[nodiscard]] std::vector<int> order(const GroupGraph& graph, const std::vector<int>& kept);

private:
    void check() const {
        if (common_.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
        if (common_.status < CHOLMOD_OK)
            throw Error(ExitCode::internal, "CHOLMOD",
                        "nested dissection failed with status " + std::to_string(common_.status));
    }

    cholmod_common common_{};
    cholmod_sparse* graph_ = nullptr;
};

std::vector<int> Dissection::order(const GroupGraph& graph, const std::vector<int>& kept) {
    const std::size_t count = kept.size();
    if (count == 0) return {};
    std::vector<int> index(graph.size(), -1);
    for (std::size_t k = 0; k < count; ++k) index[static_cast<std::size_t>(kept[k])] = static_cast<int>(k);
    // Neighbours with a higher index, ascending as `kept` is: the lower triangle by columns.
    std::vector<int> begin{0}, above;
    for (std::size_t k = 0; k < count; ++k) {
        for (const int other : graph.neighbours(kept[k]))
            if (const int at = index[static_cast<std::size_t>(other)]; at > static_cast<int>(k)) above.push_back(at);
        begin.push_back(static_cast<int>(above.size()));
    }
    constexpr int sorted = 1, packed = 1, lower = -1;
    graph_ = cholmod_allocate_sparse(count, count, above.size(), sorted, packed, lower, CHOLMOD_PATTERN, &common_);
    check();
    std::ranges::copy(begin, static_cast<int*>(graph_->p));
    std::ranges::copy(above, static_cast<int*>(graph_->i));
    std::vector<int> order(count), parent(count), member(count);
    cholmod_nested_dissection(graph_, nullptr, 0, order.data(), parent.data(), member.data(), &common_);
    check();
    return order;
}

}  // namespace

GroupGraph::GroupGraph(const MatrixRows& rows, PetscInt interior) : group_of_(static_cast<std::size_t>(interior)) {
    std::unordered_multimap<std::uint64_t, int> by_hash;
    for (PetscInt row = 0; row < interior; ++row) {
        const auto columns = columns_of(rows, row);
        std::uint64_t hash = 0;
        for (const PetscInt column : columns)
            hash = (hash ^ static_cast<std::uint64_t>(column)) * std::uint64_t{0x9E3779B97F4A7C15};
        const auto [begin, end] = by_hash.equal_range(hash);
        const auto same = std::find_if(begin, end, [&](const auto& entry) {
            return std::ranges::equal(columns, columns_of(rows, unknowns(entry.second).front()));
        });
        const int group = same != end ? same->second : static_cast<int>(size());
        if (same == end) {
            by_hash.emplace(hash, group);
            unknowns_.emplace_back();
        }
        unknowns_[static_cast<std::size_t>(group)].push_back(row);
        group_of_[static_cast<std::size_t>(row)] = group;
    }
    std::vector<int> seen_by(size(), -1);
    for (int group = 0; group < static_cast<int>(size()); ++group) {
        seen_by[static_cast<std::size_t>(group)] = group;
        for (const PetscInt column : columns_of(rows, unknowns(group).front())) {
            if (column >= interior) continue;
            const int other = group_of(column);
            if (std::exchange(seen_by[static_cast<std::size_t>(other)], group) != group) others_.push_back(other);
        }
        std::sort(others_.begin() + static_cast<std::ptrdiff_t>(begin_.back()), others_.end());
        begin_.push_back(others_.size());
    }
}

std::vector<int> elimination_order(const GroupGraph& graph, const std::vector<int>& last) {
    const Dominated dominated(graph, last);
    std::vector<bool> done(graph.size());
    std::vector<int> order;
    const auto eliminate = [&](int group) {
        if (!done[static_cast<std::size_t>(group)]) order.push_back(group);
        done[static_cast<std::size_t>(group)] = true;
    };
    for (const int k : Dissection{}.order(graph, dominated.kept)) {
        for (const int group : dominated.by_kept[static_cast<std::size_t>(k)]) eliminate(group);
        eliminate(dominated.kept[static_cast<std::size_t>(k)]);
    }
    for (const int group : last) eliminate(group);
    return order;
}

std::vector<PetscInt> elimination_order(const MatrixRows& rows, PetscInt interior) {
    const GroupGraph graph(rows, interior);
    std::vector<PetscInt> positions(static_cast<std::size_t>(rows.count));
    PetscInt next = 0;
    for (const int group : elimination_order(graph))
        for (const PetscInt unknown : graph.unknowns(group)) positions[static_cast<std::size_t>(unknown)] = next++;
    for (; next < rows.count; ++next) positions[static_cast<std::size_t>(next)] = next;
    return positions;
}

}  // namespace soft::linalg
