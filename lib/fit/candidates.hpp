#pragma once
/// The laws that can be fitted. The stress of each is linear in its first constants and depends on at most one shape
/// constant a term: P = sum_j c_j P_j(l; shape_j). What is linear is solved exactly; only the shapes are searched
/// (variable projection: Golub and Pereyra, SIAM J. Numer. Anal. 10 (1973) 413). Tested by fit/fit_test.
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "material/catalogue.hpp"
#include "material/homogeneous.hpp"

namespace soft::fit {

struct Candidate {
    std::string_view name;  ///< "mooney-rivlin-5": what --law takes
    std::string_view law;   ///< what a design names: "mooney-rivlin"
    int linear = 1;         ///< constants the stress is linear in
    int shapes = 0;  ///< constants alpha (ogden), jm, locking_stretch, b (yeoh-5): one for each of the last parts

    /// The part P_j that shape k belongs to.
    [[nodiscard]] std::size_t part_of_shape(std::size_t k) const {
        return k + static_cast<std::size_t>(linear - shapes);
    }
};

[[nodiscard]] std::span<const Candidate> candidates();

/// nullptr for an unknown name. "mooney-rivlin" is the one of two constants, "ogden" that of three terms.
[[nodiscard]] const Candidate* find_candidate(std::string_view name);

/// `linear` [Pa]: mu (of ogden: mu_i alpha_i, twice the shear modulus of the term, whose sign decides on stability),
/// c10 ..., c1 .... As a design states them.
[[nodiscard]] material::Constants constants_of(const Candidate& candidate, std::span<const double> linear,
                                               std::span<const double> shapes);

/// Nominal stresses [Pa] of constants that need not make a law a design accepts (a negative modulus): the parts P_j, and
/// curves to compare. `stress_Pa` has the length of the others.
struct CurvePoints {
    std::span<const material::Mode> mode;
    std::span<const double> stretch;
};
void add_stresses(const Candidate& candidate, const material::Constants& constants, const CurvePoints& points,
                  std::span<double> stress_Pa);

/// The law as solve would run it, incompressible; nullopt for constants it refuses (a shear modulus that is not positive).
[[nodiscard]] std::optional<material::AnyRubber> rubber_of(const Candidate& candidate,
                                                           const material::Constants& constants);

}  // namespace soft::fit
