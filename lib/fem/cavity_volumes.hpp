#pragma once
/// Enclosed volumes [m^3] of the WHOLE actuator: wall and inner faces of a cavity, openings closed by flat plugs (in solids a cone to
/// the centre of the rim; in a section nothing is added, because a flat plug contributes nothing to the integral of r^2 dx). The symmetry
/// planes pass through the origin, so they add nothing to 1/3 int x.n da. The volumes include the motions prescribed last.
/// Tested by fem/system_test.
#include <span>
#include <vector>

#include "fem/local_state.hpp"
#include "model/cavity_surface.hpp"

namespace soft::fem {

class CavityVolumes {
public:
    /// Both must outlive this object.
    CavityVolumes(const Discretization& fe, LocalState& state);

    /// Volume of one of model::measured_cavities; `gradient` by x and `by_motion` by the level of each motion are overwritten; nullptr
    /// and empty if not needed. Collective.
    double of_cavity(std::size_t cavity, Vec x, Vec gradient, std::span<double> by_motion = {});
    [[nodiscard]] std::size_t count() const noexcept { return cavities_.size(); }

    /// The same of all cavities of a pressure load together; 0 for a load on a face.
    double of_load(std::size_t load, Vec x, Vec gradient, std::span<double> by_motion = {});
    [[nodiscard]] bool has_volume(std::size_t load) const { return !by_load_.at(load).empty(); }

private:
    struct Rim {
        std::vector<SurfaceCell> edges;  ///< oriented with the normal out of the cavity
        std::size_t nodes = 0;           ///< their mean is the apex
        std::array<bool, 3> on_plane{};  ///< the rim is cut by the symmetry plane x, y, z = 0, so its apex lies on it
    };
    struct Cavity {
        std::vector<SurfaceCell> facets;  ///< this rank's
        std::vector<Rim> rims;            ///< evaluated by rank 0 only: rims are short
    };

    [[nodiscard]] Rim make_rim(const std::vector<model::RimEdge>& edges) const;
    double sum(std::span<const std::size_t> cavities, Vec x, Vec gradient, std::span<double> by_motion);
    void add_wall(const Cavity& cavity, double& volume, Slopes& slopes) const;
    void add_caps(const Rim& rim, double& volume, Slopes& slopes) const;

    const Discretization& fe_;
    LocalState& state_;
    std::vector<Cavity> cavities_;                   // by model::measured_cavities
    std::vector<std::vector<std::size_t>> by_load_;  // into cavities_
};

}  // namespace soft::fem
