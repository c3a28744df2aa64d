#pragma once
/// Where the time of a run goes, by PETSc's own log: its events, and ours beside them. Nothing is kept unless start_profile()
/// was called; a Timed then costs two readings of the clock.
/// Tested by linalg/profile_test.
#include <string>
#include <vector>

namespace soft::linalg {

/// What PETSc does not time by itself.
enum class Phase { residual, tangent, measures, contact, writing, ordering, factorization, factor_solve };

/// From construction to destruction the time counts for the phase; phases do not nest.
class Timed {
public:
    explicit Timed(Phase phase);
    ~Timed();
    Timed(const Timed&) = delete;
    Timed& operator=(const Timed&) = delete;

private:
    int event_;
};

/// To be called once, after Session has begun.
void start_profile();

struct ProfileRow {
    std::string what;
    long calls = 0;
    double seconds = 0;  ///< of this rank
};

/// In the order of a run; no two rows share time. Rows without calls are left out.
[[nodiscard]] std::vector<ProfileRow> profile_rows();

}  // namespace soft::linalg
