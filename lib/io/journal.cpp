#include "io/journal.hpp"

#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>

#include "core/error.hpp"

namespace soft::io {
namespace {

template <class Given, class Wanted>
concept Is = std::same_as<std::remove_const_t<Given>, Wanted>;

/// The members of a struct in the order of the record. A struct that gets another member fails to compile here; a resumed path would
/// otherwise differ from an uninterrupted one.
auto members(Is<model::Step::Extremes> auto& extremes) {
    auto& [stretch_at, energy] = extremes;
    return std::tie(stretch_at, energy);
}
auto members(Is<model::Step::Energies> auto& energies) {
    auto& [stored, work, tangent, dissipated] = energies;
    return std::tie(stored, work, tangent, dissipated);
}
auto members(Is<model::Step::Motion> auto& motion) {
    auto& [time, kinetic, stored, work, damping] = motion;
    return std::tie(time, kinetic, stored, work, damping);
}
auto members(Is<model::Step> auto& step) {
    auto& [stage, load_factor, time, pressure, volume, pressures, volumes, outputs, d_load_factor, d_pressure, d_volume,
           d_pressures, d_volumes, d_outputs, iterations, factorizations, stable, controlled, p99, stretch, jacobian,
           extremes, energies, motion, friction, pressure_error, output_errors, frequencies, derivatives] = step;
    return std::tie(stage, load_factor, time, pressure, volume, pressures, volumes, outputs, d_load_factor, d_pressure,
                    d_volume, d_pressures, d_volumes, d_outputs, iterations, factorizations, stable, controlled, p99,
                    stretch, jacobian, extremes, energies, motion, friction, pressure_error, output_errors, frequencies,
                    derivatives);
}
auto members(Is<model::LimitPoint> auto& point) {
    auto& [step, pressure, volume, outputs] = point;
    return std::tie(step, pressure, volume, outputs);
}
auto members(Is<model::Bifurcation> auto& bifurcation) {
    auto& [at, modes, mode] = bifurcation;
    return std::tie(at, modes, mode);
}
auto members(Is<model::FirstContact> auto& contact) {
    auto& [at, obstacle, location] = contact;
    return std::tie(at, obstacle, location);
}
/// Without reason and detail, which an unfinished path does not have.
auto members(Is<model::PathEnd> auto& end) {
    [[maybe_unused]] auto& [reason, detail, limit_points, bifurcations, contacts, iterations, factorizations] = end;
    return std::tie(limit_points, bifurcations, contacts, iterations, factorizations);
}
auto members(Is<model::StatePoint> auto& point) {
    auto& [unknowns, tangent, pressures, d_pressures, load_factor, d_load_factor, power, outputs, q, work, modes] =
        point;
    return std::tie(unknowns, tangent, pressures, d_pressures, load_factor, d_load_factor, power, outputs, q, work,
                    modes);
}
auto members(Is<model::StageStart> auto& start) {
    auto& [pressures, volumes, masses, dead_loads, motions, time] = start;
    return std::tie(pressures, volumes, masses, dead_loads, motions, time);
}
auto members(Is<model::Checkpoint> auto& checkpoint) {
    auto& [ranks, rows, stage, stage_row, start, control, controlled, user_failed, on_branch, pending, pivots, before,
           last, step, first_step, size, dissipated, friction, internal, work, slope, visited, so_far] = checkpoint;
    return std::tie(ranks, rows, stage, stage_row, start, control, controlled, user_failed, on_branch, pending, pivots,
                    before, last, step, first_step, size, dissipated, friction, internal, work, slope, visited, so_far);
}
auto members(Is<JournalStep> auto& record) {
    auto& [step, displacement, pressure] = record;
    return std::tie(step, displacement, pressure);
}

template <class T>
concept Number = std::is_arithmetic_v<T>;
template <class T>
concept Struct = std::is_class_v<T>;

class Packer {
public:
    void put(Number auto value) { append(&value, sizeof value); }
    template <class T>
    void put(const std::optional<T>& value) {
        put(value.has_value());
        if (value) put(*value);
    }
    void put(const std::array<double, 3>& values) { append(values.data(), sizeof values); }
    void put(std::span<const double> values) {
        put(std::uint64_t{values.size()});
        append(values.data(), values.size_bytes());
    }
    void put(const std::vector<double>& values) { put(std::span{values}); }
    template <class T>
    void put(const std::vector<T>& values) {
        put(std::uint64_t{values.size()});
        for (const T& value : values) put(value);
    }
    void put(const Struct auto& value) {
        std::apply([&](const auto&... member) { (put(member), ...); }, members(value));
    }
    [[nodiscard]] std::vector<std::byte> take() { return std::move(bytes_); }

private:
    void append(const void* data, std::size_t size) {
        const auto* first = static_cast<const std::byte*>(data);
        bytes_.insert(bytes_.end(), first, first + size);
    }
    std::vector<std::byte> bytes_;
};

class Unpacker {
public:
    Unpacker(std::span<const std::byte> bytes, std::string_view source) : bytes_(bytes), source_(source) {}

    void get(Number auto& value) { take(&value, sizeof value); }
    void get(double& value) {
        take(&value, sizeof value);
        require(std::isfinite(value));
    }
    void get(bool& flag) {
        std::uint8_t value = 0;
        get(value);
        require(value <= 1);
        flag = value == 1;
    }
    template <class T>
    void get(std::optional<T>& value) {
        bool present = false;
        get(present);
        if (present) get(value.emplace(T{}));  // clang 16 does not emplace aggregates
    }
    void get(std::array<double, 3>& values) {
        for (double& value : values) get(value);
    }
    void get(std::vector<double>& values) {
        std::uint64_t size = 0;
        get(size);
        require(size <= bytes_.size() / sizeof(double));
        values.resize(static_cast<std::size_t>(size));
        for (double& value : values) get(value);
    }
    template <class T>
    void get(std::vector<T>& values) {
        std::uint64_t size = 0;
        for (get(size); size > 0; --size) get(values.emplace_back());
    }
    void get(Struct auto& value) {
        std::apply([&](auto&... member) { (get(member), ...); }, members(value));
    }
    void require(bool valid) const {
        if (!valid)
            throw Error(ExitCode::bad_input, source_, "a record after the HDF5 data is corrupted", "run solve again");
    }
    void require_end() const { require(bytes_.empty()); }

private:
    void take(void* to, std::size_t size) {
        require(size <= bytes_.size());
        std::memcpy(to, bytes_.data(), size);
        bytes_ = bytes_.subspan(size);
    }
    std::span<const std::byte> bytes_;
    std::string_view source_;
};

}  // namespace

std::vector<std::byte> encode_step(const model::Step& step, std::span<const double> displacement,
                                   std::span<const double> pressure) {
    Packer packer;
    packer.put(step);
    packer.put(displacement);
    packer.put(pressure);
    return packer.take();
}

JournalStep decode_step(std::span<const std::byte> payload, std::string_view source) {
    Unpacker unpacker{payload, source};
    JournalStep record;
    unpacker.get(record);
    unpacker.require_end();
    return record;
}

std::vector<std::byte> encode_checkpoint(const model::Checkpoint& checkpoint) {
    Packer packer;
    packer.put(checkpoint);
    return packer.take();
}

model::Checkpoint decode_checkpoint(std::span<const std::byte> payload, std::string_view source) {
    Unpacker unpacker{payload, source};
    model::Checkpoint read;
    unpacker.get(read);
    unpacker.require_end();
    for (const int count : {read.ranks, read.rows, read.stage, read.stage_first_row, read.control,
                            read.pending_factorizations, read.so_far.newton_iterations, read.so_far.factorizations})
        unpacker.require(count >= 0);
    return read;
}

}  // namespace soft::io
