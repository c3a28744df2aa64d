#include "io/journal.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <type_traits>

#include "core/error.hpp"

namespace soft::io {
namespace {

class Packer {
public:
    template <class T>
    void put(T value) {
        append(&value, sizeof value);
    }
    void put_optional(const std::optional<double>& value) {
        put(std::uint64_t{value.has_value()});
        put(value.value_or(0.0));
    }
    void put_list(std::span<const double> values) {
        put(static_cast<std::uint64_t>(values.size()));
        append(values.data(), values.size_bytes());
    }
    [[nodiscard]] std::vector<std::byte> take() { return std::move(bytes_); }

private:
    void append(const void* data, std::size_t size) {
        const std::size_t end = bytes_.size();
        bytes_.resize(end + size);
        if (size > 0) std::memcpy(bytes_.data() + end, data, size);
    }
    std::vector<std::byte> bytes_;
};

class Unpacker {
public:
    Unpacker(std::span<const std::byte> bytes, std::string_view source) : bytes_(bytes), source_(source) {}

    template <class T>
    T get() {
        T value;
        take(&value, sizeof value);
        if constexpr (std::is_floating_point_v<T>)
            if (!std::isfinite(value)) refuse();
        return value;
    }
    int get_count() {
        const auto value = get<std::int64_t>();
        if (value < 0 || value > std::numeric_limits<int>::max()) refuse();
        return static_cast<int>(value);
    }
    bool get_flag() {
        const auto value = get<std::uint64_t>();
        if (value > 1) refuse();
        return value == 1;
    }
    std::vector<double> get_list() {
        const auto size = get<std::uint64_t>();
        if (size > bytes_.size() / sizeof(double)) refuse();
        std::vector<double> values(static_cast<std::size_t>(size));
        if (!values.empty()) take(values.data(), values.size() * sizeof(double));
        for (const double value : values)
            if (!std::isfinite(value)) refuse();
        return values;
    }
    std::optional<double> get_optional() {
        const bool present = get_flag();
        const auto value = get<double>();
        return present ? std::optional(value) : std::nullopt;
    }
    void require_end() const {
        if (!bytes_.empty()) refuse();
    }

private:
    [[noreturn]] void refuse() const {
        throw Error(ExitCode::bad_input, source_, "a record after the HDF5 data is corrupted", "run solve again");
    }
    void take(void* to, std::size_t size) {
        if (size > bytes_.size()) refuse();
        std::memcpy(to, bytes_.data(), size);
        bytes_ = bytes_.subspan(size);
    }
    std::span<const std::byte> bytes_;
    std::string_view source_;
};

/// Members of a step, in the order of the record.
constexpr std::array numbers{&model::Step::load_factor,         &model::Step::pressure_Pa,
                             &model::Step::tangent_load_factor, &model::Step::tangent_pressure,
                             &model::Step::tangent_volume,      &model::Step::stretch_p99,
                             &model::Step::max_stretch,         &model::Step::min_jacobian};
constexpr std::array lists{&model::Step::pressures_Pa,    &model::Step::volumes_m3,
                           &model::Step::outputs,         &model::Step::tangent_pressures,
                           &model::Step::tangent_volumes, &model::Step::tangent_outputs,
                           &model::Step::output_errors,   &model::Step::frequencies_Hz};
constexpr std::array counts{&model::Step::stage, &model::Step::newton_iterations, &model::Step::factorizations};

using Motion = model::Step::Motion;
constexpr std::array motion_numbers{&Motion::time_s, &Motion::kinetic_energy_J, &Motion::stored_energy_J,
                                    &Motion::load_work_J, &Motion::damping_work_J};

/// Members of a solver state and of the loads at the start of a stage.
constexpr std::array state_lists{&model::StatePoint::unknowns, &model::StatePoint::tangent_unknowns,
                                 &model::StatePoint::pressures_Pa, &model::StatePoint::tangent_pressures,
                                 &model::StatePoint::outputs};
constexpr std::array state_numbers{&model::StatePoint::load_factor, &model::StatePoint::tangent_load_factor,
                                   &model::StatePoint::power, &model::StatePoint::q, &model::StatePoint::load_work_J};
constexpr std::array start_lists{&model::StageStart::pressures_Pa, &model::StageStart::volumes_m3,
                                 &model::StageStart::masses_kg,    &model::StageStart::tractions,
                                 &model::StageStart::body_forces,  &model::StageStart::motions};
constexpr std::array checkpoint_numbers{&model::Checkpoint::step, &model::Checkpoint::first_step,
                                        &model::Checkpoint::work_before_stage_J, &model::Checkpoint::first_slope};
constexpr std::array checkpoint_counts{&model::Checkpoint::ranks,
                                       &model::Checkpoint::rows,
                                       &model::Checkpoint::stage,
                                       &model::Checkpoint::stage_first_row,
                                       &model::Checkpoint::control,
                                       &model::Checkpoint::confirmed_pivots,
                                       &model::Checkpoint::pending_factorizations};
constexpr std::array checkpoint_flags{&model::Checkpoint::user_control_failed, &model::Checkpoint::on_branch};

/// Fails to compile if a struct gets a member that is not stored here. A resumed path would otherwise differ.
[[maybe_unused]] void every_member_is_kept(const model::Step& step, const model::Checkpoint& checkpoint) {
    [[maybe_unused]] const auto& [s1, s2, s3, s4, s5, s6, s7, s8, s9, s10, s11, s12, s13, s14, s15, s16, s17, s18, s19,
                                  s20, extremes, energies, motion, s21, s22, s23] = step;
    [[maybe_unused]] const auto& [x1, x2] = *extremes;
    [[maybe_unused]] const auto& [n1, n2, n3] = *energies;
    [[maybe_unused]] const auto& [m1, m2, m3, m4, m5] = *motion;
    [[maybe_unused]] const auto& [c1, c2, c3, c4, start, c5, c6, c7, c8, c9, c10, c11, last, c12, c13, c14, c15, c16,
                                  end] = checkpoint;
    [[maybe_unused]] const auto& [l1, l2, l3, l4, l5, l6] = start;
    [[maybe_unused]] const auto& [p1, p2, p3, p4, p5, p6, p7, p8, p9, p10, p11] = last;
    [[maybe_unused]] const auto& [reason, detail, e1, bifurcations, e2, e3] = end;
    [[maybe_unused]] const auto& [at, b1, b2] = bifurcations.front();
    [[maybe_unused]] const auto& [a1, a2, a3, a4] = at;
}

}  // namespace

std::vector<std::byte> encode_step(const model::Step& step, std::span<const double> displacement,
                                   std::span<const double> pressure) {
    Packer packer;
    for (const auto member : counts) packer.put(std::int64_t{step.*member});
    for (const auto member : numbers) packer.put(step.*member);
    for (const auto member : lists) packer.put_list(step.*member);
    packer.put_optional(step.volume_m3);
    packer.put_optional(step.pressure_error_Pa);
    packer.put(std::uint64_t{step.stable});
    packer.put(std::uint64_t{step.stable_under_control.has_value()});
    packer.put(std::uint64_t{step.stable_under_control.value_or(false)});
    packer.put(std::uint64_t{step.motion.has_value()});
    if (step.motion)
        for (const auto member : motion_numbers) packer.put((*step.motion).*member);
    packer.put(std::uint64_t{step.extremes.has_value()});
    if (step.extremes) {
        for (const double component : step.extremes->stretch_at_m) packer.put(component);
        packer.put(step.extremes->energy_J_m3);
    }
    packer.put(std::uint64_t{step.energies.has_value()});
    if (step.energies) {
        packer.put(step.energies->stored_J);
        packer.put(step.energies->load_work_J);
        packer.put_optional(step.energies->tangent_J);
    }
    packer.put_list(displacement);
    packer.put_list(pressure);
    return packer.take();
}

JournalStep decode_step(std::span<const std::byte> payload, std::string_view source) {
    Unpacker unpacker{payload, source};
    JournalStep record;
    model::Step& step = record.step;
    for (const auto member : counts) step.*member = unpacker.get_count();
    for (const auto member : numbers) step.*member = unpacker.get<double>();
    for (const auto member : lists) step.*member = unpacker.get_list();
    step.volume_m3 = unpacker.get_optional();
    step.pressure_error_Pa = unpacker.get_optional();
    step.stable = unpacker.get_flag();
    const bool has_control = unpacker.get_flag(), stable_under_control = unpacker.get_flag();
    if (has_control) step.stable_under_control = stable_under_control;
    if (unpacker.get_flag()) {
        step.motion = model::Step::Motion{};
        for (const auto member : motion_numbers) (*step.motion).*member = unpacker.get<double>();
    }
    if (unpacker.get_flag()) {
        step.extremes = model::Step::Extremes{};
        for (double& component : step.extremes->stretch_at_m) component = unpacker.get<double>();
        step.extremes->energy_J_m3 = unpacker.get<double>();
    }
    if (unpacker.get_flag()) {
        model::Step::Energies energies;
        energies.stored_J = unpacker.get<double>();
        energies.load_work_J = unpacker.get<double>();
        energies.tangent_J = unpacker.get_optional();
        step.energies = energies;
    }
    record.displacement_m = unpacker.get_list();
    record.pressure_Pa = unpacker.get_list();
    unpacker.require_end();
    return record;
}

namespace {

void put_state(Packer& packer, const model::StatePoint& point) {
    for (const auto member : state_lists) packer.put_list(point.*member);
    for (const auto member : state_numbers) packer.put(point.*member);
    packer.put_optional(point.unstable_modes ? std::optional<double>(*point.unstable_modes) : std::nullopt);
}

model::StatePoint get_state(Unpacker& unpacker) {
    model::StatePoint point;
    for (const auto member : state_lists) point.*member = unpacker.get_list();
    for (const auto member : state_numbers) point.*member = unpacker.get<double>();
    if (const auto modes = unpacker.get_optional()) point.unstable_modes = static_cast<int>(*modes);
    return point;
}

void put_point(Packer& packer, const model::LimitPoint& point) {
    packer.put(std::int64_t{point.step});
    packer.put(point.pressure_Pa);
    packer.put_optional(point.volume_m3);
    packer.put_list(point.outputs);
}

model::LimitPoint get_point(Unpacker& unpacker) {
    model::LimitPoint point;
    point.step = unpacker.get_count();
    point.pressure_Pa = unpacker.get<double>();
    point.volume_m3 = unpacker.get_optional();
    point.outputs = unpacker.get_list();
    return point;
}

/// Without the stop reason, which an unfinished path does not have.
void put_end(Packer& packer, const model::PathEnd& end) {
    packer.put(std::int64_t{end.newton_iterations});
    packer.put(std::int64_t{end.factorizations});
    packer.put(static_cast<std::uint64_t>(end.limit_points.size()));
    for (const auto& limit : end.limit_points) put_point(packer, limit);
    packer.put(static_cast<std::uint64_t>(end.bifurcations.size()));
    for (const auto& bifurcation : end.bifurcations) {
        put_point(packer, bifurcation.at);
        packer.put(std::int64_t{bifurcation.modes});
        packer.put_list(bifurcation.mode);
    }
}

model::PathEnd get_end(Unpacker& unpacker) {
    model::PathEnd end;
    end.newton_iterations = unpacker.get_count();
    end.factorizations = unpacker.get_count();
    for (auto left = unpacker.get<std::uint64_t>(); left > 0; --left) end.limit_points.push_back(get_point(unpacker));
    for (auto left = unpacker.get<std::uint64_t>(); left > 0; --left) {
        auto& bifurcation = end.bifurcations.emplace_back();
        bifurcation.at = get_point(unpacker);
        bifurcation.modes = unpacker.get_count();
        bifurcation.mode = unpacker.get_list();
    }
    return end;
}

}  // namespace

std::vector<std::byte> encode_checkpoint(const model::Checkpoint& checkpoint) {
    Packer packer;
    for (const auto member : checkpoint_counts) packer.put(std::int64_t{checkpoint.*member});
    packer.put(checkpoint.controlled);
    for (const auto member : checkpoint_flags) packer.put(std::uint64_t{checkpoint.*member});
    for (const auto member : start_lists) packer.put_list(checkpoint.start.*member);
    packer.put(std::uint64_t{checkpoint.before.has_value()});
    if (checkpoint.before) put_state(packer, *checkpoint.before);
    put_state(packer, checkpoint.last);
    for (const auto member : checkpoint_numbers) packer.put(checkpoint.*member);
    packer.put_list(checkpoint.visited);
    put_end(packer, checkpoint.so_far);
    return packer.take();
}

model::Checkpoint decode_checkpoint(std::span<const std::byte> payload, std::string_view source) {
    Unpacker unpacker{payload, source};
    model::Checkpoint checkpoint;
    for (const auto member : checkpoint_counts) checkpoint.*member = unpacker.get_count();
    checkpoint.controlled = unpacker.get_count();
    for (const auto member : checkpoint_flags) checkpoint.*member = unpacker.get_flag();
    for (const auto member : start_lists) checkpoint.start.*member = unpacker.get_list();
    if (unpacker.get_flag()) checkpoint.before = get_state(unpacker);
    checkpoint.last = get_state(unpacker);
    for (const auto member : checkpoint_numbers) checkpoint.*member = unpacker.get<double>();
    checkpoint.visited = unpacker.get_list();
    checkpoint.so_far = get_end(unpacker);
    unpacker.require_end();
    return checkpoint;
}

}  // namespace soft::io
