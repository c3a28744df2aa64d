#pragma once
/// The laws that can be fitted. The stress of each is linear in its first constants and depends on at most one shape constant per
/// term: P = sum_j c_j P_j(l; shape_j). The linear constants are solved exactly; only the shapes are searched (variable projection:
/// Golub and Pereyra, SIAM J. Numer. Anal. 10 (1973) 413). Tested by fit/fit_test.
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "material/catalogue.hpp"
#include "material/homogeneous.hpp"

namespace soft::fit {

/// What shows that a fitted law is stable: linear constants that are not negative, or only a scan of the stretches.
enum class StableBy { signs, scan };

struct Candidate {
    std::string_view name;  ///< argument of --law: "mooney-rivlin-5"
    std::string_view law;   ///< name of the law in a design: "mooney-rivlin"
    int linear = 1;         ///< number of constants in which the stress is linear
    int shapes =
        0;  ///< number of shape constants alpha (ogden), jm, locking_stretch, b (yeoh-5); each belongs to one of the last parts
    StableBy stable_by = StableBy::scan;

    /// The part P_j that shape k belongs to.
    [[nodiscard]] std::size_t part_of_shape(std::size_t k) const {
        return k + static_cast<std::size_t>(linear - shapes);
    }
};

[[nodiscard]] std::span<const Candidate> candidates();

/// nullptr for an unknown name. "mooney-rivlin" means mooney-rivlin-2, "ogden" means ogden-3.
[[nodiscard]] const Candidate* find_candidate(std::string_view name);

/// Constants as in a design. `linear` [Pa]: mu, c10 ..., c1 ...; for ogden mu_i alpha_i, twice the shear modulus of the term, whose
/// sign determines stability.
[[nodiscard]] material::Constants constants_of(const Candidate& candidate, std::span<const double> linear,
                                               std::span<const double> shapes);

/// Adds nominal stresses [Pa] to `stress_Pa`, which has one entry per point. The constants need not form a law that a design accepts
/// (for example a negative modulus). Used for the parts P_j and for curves to compare.
struct CurvePoints {
    std::span<const material::Mode> mode;
    std::span<const double> stretch;
};
void add_stresses(const Candidate& candidate, const material::Constants& constants, const CurvePoints& points,
                  std::span<double> stress_Pa);

/// The incompressible law as used by solve; nullopt for invalid constants (a shear modulus that is not positive).
[[nodiscard]] std::optional<material::AnyRubber> rubber_of(const Candidate& candidate,
                                                           const material::Constants& constants);

}  // namespace soft::fit
