#pragma once
/// Time spent in the phases of a run, from PETSc's log: PETSc's events and those of this program. Nothing is recorded before
/// start_profile(); afterwards a ScopedTimer costs two clock readings.
/// Tested by linalg/profile_test.
#include <string>
#include <vector>

namespace soft::linalg {

/// Phases that PETSc does not time itself.
enum class Phase { residual, tangent, measures, contact, writing, ordering, factorization, factor_solve };

/// Adds the time from construction to destruction to a phase. Phases must not nest.
class ScopedTimer {
public:
    explicit ScopedTimer(Phase phase);
    ~ScopedTimer();
    ScopedTimer(const ScopedTimer&) = delete;
    ScopedTimer& operator=(const ScopedTimer&) = delete;

private:
    int event_;
};

/// Call once, after a Session has been created.
void start_profile();

struct ProfileRow {
    std::string what;
    long calls = 0;
    double seconds = 0;  ///< on this rank
};

/// Rows in the order of a run. No time is counted in two rows. Rows without calls are omitted.
[[nodiscard]] std::vector<ProfileRow> profile_rows();

}  // namespace soft::linalg
