#pragma once
/// Symbolic factorisation L D L^T by CHOLMOD, of groups of unknowns. Internal to the module. Tested by linalg/multifrontal_test.
#include <cholmod.h>

#include <new>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "linalg/elimination_order.hpp"

namespace soft::linalg {

/// The structure of L by groups of unknowns: supernodes, that is columns with nearly the same rows, which CHOLMOD merges where that costs
/// few zeros.
class Supernodes {
public:
    Supernodes(const GroupGraph& graph, const std::vector<int>& last) {
        cholmod_start(&common_);
        common_.print = 0;
        common_.supernodal = CHOLMOD_SUPERNODAL;
        common_.nmethods = 1;
        common_.method[0].ordering = CHOLMOD_GIVEN;
        common_.postorder = 1;
        // Two supernodes are merged up to these columns: always, with up to 80 % zeros, and with up to 10 %. A third of CHOLMOD's defaults or less,
        // which are for single unknowns.
        common_.nrelax[0] = 1;
        common_.nrelax[1] = 2;
        common_.nrelax[2] = 5;
        constexpr int sorted = 1, packed = 1, lower = -1;
        const std::size_t count = graph.size(), entries = count + graph.couplings() / 2;
        lower_ = cholmod_allocate_sparse(count, count, entries, sorted, packed, lower, CHOLMOD_PATTERN, &common_);
        check();
        auto* start = static_cast<int*>(lower_->p);
        auto* index = static_cast<int*>(lower_->i);
        int next = 0;
        for (int group = 0; group < static_cast<int>(count); ++group) {
            start[group] = next;
            index[next++] = group;
            for (const int other : graph.neighbours(group))
                if (other > group) index[next++] = other;
        }
        start[count] = next;
        factor_ = cholmod_analyze_p(lower_, elimination_order(graph, last).data(), nullptr, 0, &common_);
        check();
    }
    ~Supernodes() {
        cholmod_free_factor(&factor_, &common_);
        cholmod_free_sparse(&lower_, &common_);
        cholmod_finish(&common_);
    }
    Supernodes(const Supernodes&) = delete;
    Supernodes& operator=(const Supernodes&) = delete;
    /// nullptr if the factor has more entries, by groups, than an int can count.
    [[nodiscard]] const cholmod_factor* factor() const { return factor_; }

private:
    void check() const {
        if (common_.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
        if (common_.status < CHOLMOD_OK && common_.status != CHOLMOD_TOO_LARGE)
            throw Error(ExitCode::internal, "CHOLMOD", "status " + std::to_string(common_.status));
    }

    cholmod_common common_{};
    cholmod_sparse* lower_ = nullptr;
    cholmod_factor* factor_ = nullptr;
};

}  // namespace soft::linalg
