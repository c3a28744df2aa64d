#include "linalg/elimination_order.hpp"

#include <cholmod.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <string>
#include <unordered_map>

#include "core/error.hpp"

namespace soft::linalg {

namespace {

static_assert(sizeof(PetscInt) == sizeof(int), "CHOLMOD's functions for int are used");

std::span<const PetscInt> columns_of(const MatrixRows& rows, PetscInt row) {
    return {rows.columns + rows.begin[row], rows.columns + rows.begin[row + 1]};
}

/// Groups of unknowns whose rows have the same columns, including their own: each couples with all others of its group.
struct Groups {
    std::vector<int> of;                          // [unknown]
    std::vector<std::vector<PetscInt>> unknowns;  // [group]

    Groups(const MatrixRows& rows, PetscInt interior);
};

Groups::Groups(const MatrixRows& rows, PetscInt interior) : of(static_cast<std::size_t>(interior)) {
    std::unordered_multimap<std::uint64_t, int> by_hash;
    for (PetscInt row = 0; row < interior; ++row) {
        const auto columns = columns_of(rows, row);
        std::uint64_t hash = 0;
        for (const PetscInt column : columns)
            hash = (hash ^ static_cast<std::uint64_t>(column)) * std::uint64_t{0x9E3779B97F4A7C15};
        const auto [begin, end] = by_hash.equal_range(hash);
        const auto same = std::find_if(begin, end, [&](const auto& entry) {
            return std::ranges::equal(columns,
                                      columns_of(rows, unknowns[static_cast<std::size_t>(entry.second)].front()));
        });
        const int group = same != end ? same->second : static_cast<int>(unknowns.size());
        if (same == end) {
            by_hash.emplace(hash, group);
            unknowns.emplace_back();
        }
        unknowns[static_cast<std::size_t>(group)].push_back(row);
        of[static_cast<std::size_t>(row)] = group;
    }
}

class Dissection {
public:
    Dissection() {
        cholmod_start(&common_);
        common_.print = 0;
        common_.method[common_.current].nd_compress = 0;  // Groups compresses the graph already
    }
    ~Dissection() {
        cholmod_free_sparse(&graph_, &common_);
        cholmod_finish(&common_);
    }
    Dissection(const Dissection&) = delete;
    Dissection& operator=(const Dissection&) = delete;

    /// Returns the groups in elimination order.
    [[nodiscard]] std::vector<int> order(const MatrixRows& rows, const Groups& groups);

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

std::vector<int> Dissection::order(const MatrixRows& rows, const Groups& groups) {
    const std::size_t count = groups.unknowns.size();
    std::vector<int> begin{0}, above;  // neighbours with a higher index: the lower triangle by columns
    for (std::size_t g = 0; g < count; ++g) {
        for (const PetscInt column : columns_of(rows, groups.unknowns[g].front())) {
            if (static_cast<std::size_t>(column) >= groups.of.size()) continue;
            if (const int other = groups.of[static_cast<std::size_t>(column)]; other > static_cast<int>(g))
                above.push_back(other);
        }
        const auto own = above.begin() + begin.back();
        std::sort(own, above.end());
        above.erase(std::unique(own, above.end()), above.end());
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

std::vector<PetscInt> elimination_order(const MatrixRows& rows, PetscInt interior) {
    const Groups groups(rows, interior);
    std::vector<PetscInt> positions(static_cast<std::size_t>(rows.count));
    PetscInt next = 0;
    for (const int group : Dissection{}.order(rows, groups))
        for (const PetscInt unknown : groups.unknowns[static_cast<std::size_t>(group)])
            positions[static_cast<std::size_t>(unknown)] = next++;
    for (; next < rows.count; ++next) positions[static_cast<std::size_t>(next)] = next;
    return positions;
}

}  // namespace soft::linalg
