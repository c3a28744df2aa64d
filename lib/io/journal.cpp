#include "io/journal.hpp"

#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>

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
        const auto* first = static_cast<const std::byte*>(data);
        bytes_.insert(bytes_.end(), first, first + size);
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
        throw Error(ExitCode::bad_input, source_, "a record after the HDF5 data does not make sense",
                    "run solve again");
    }
    void take(void* to, std::size_t size) {
        if (size > bytes_.size()) refuse();
        std::memcpy(to, bytes_.data(), size);
        bytes_ = bytes_.subspan(size);
    }
    std::span<const std::byte> bytes_;
    std::string_view source_;
};

}  // namespace

std::vector<std::byte> encode_step(const solution::Step& step, std::span<const double> displacement,
                                   std::span<const double> pressure) {
    Packer packer;
    packer.put(step.load_factor);
    packer.put(step.pressure_Pa);
    packer.put_optional(step.volume_m3);
    packer.put_list(step.outputs_m);
    packer.put(step.tangent_load_factor);
    packer.put(step.tangent_pressure);
    packer.put(step.tangent_volume);
    packer.put_list(step.tangent_outputs);
    packer.put(std::int64_t{step.newton_iterations});
    packer.put(std::int64_t{step.factorizations});
    packer.put(std::uint64_t{step.stable});
    packer.put(step.stretch_p99);
    packer.put(step.max_stretch);
    packer.put(step.min_jacobian);
    packer.put_list(displacement);
    packer.put_list(pressure);
    return packer.take();
}

JournalStep decode_step(std::span<const std::byte> payload, std::string_view source) {
    Unpacker unpacker{payload, source};
    JournalStep record;
    solution::Step& step = record.step;
    step.load_factor = unpacker.get<double>();
    step.pressure_Pa = unpacker.get<double>();
    step.volume_m3 = unpacker.get_optional();
    step.outputs_m = unpacker.get_list();
    step.tangent_load_factor = unpacker.get<double>();
    step.tangent_pressure = unpacker.get<double>();
    step.tangent_volume = unpacker.get<double>();
    step.tangent_outputs = unpacker.get_list();
    step.newton_iterations = unpacker.get_count();
    step.factorizations = unpacker.get_count();
    step.stable = unpacker.get_flag();
    step.stretch_p99 = unpacker.get<double>();
    step.max_stretch = unpacker.get<double>();
    step.min_jacobian = unpacker.get<double>();
    record.displacement_m = unpacker.get_list();
    record.pressure_Pa = unpacker.get_list();
    unpacker.require_end();
    return record;
}

namespace {

void put_point(Packer& packer, const solution::StatePoint& point) {
    packer.put_list(point.unknowns);
    packer.put_list(point.tangent_unknowns);
    for (const double value : {point.load_factor, point.tangent_load_factor, point.q}) packer.put(value);
    packer.put_optional(point.excess_pivots ? std::optional<double>(*point.excess_pivots) : std::nullopt);
}

solution::StatePoint get_point(Unpacker& unpacker) {
    solution::StatePoint point;
    point.unknowns = unpacker.get_list();
    point.tangent_unknowns = unpacker.get_list();
    for (double* value : {&point.load_factor, &point.tangent_load_factor, &point.q}) *value = unpacker.get<double>();
    if (const auto pivots = unpacker.get_optional()) point.excess_pivots = static_cast<int>(*pivots);
    return point;
}

}  // namespace

std::vector<std::byte> encode_checkpoint(const solution::Checkpoint& checkpoint) {
    Packer packer;
    packer.put(std::int64_t{checkpoint.ranks});
    packer.put(std::int64_t{checkpoint.rows});
    packer.put(std::int64_t{checkpoint.control});
    packer.put(checkpoint.control_output);
    packer.put(std::uint64_t{checkpoint.before.has_value()});
    if (checkpoint.before) put_point(packer, *checkpoint.before);
    put_point(packer, checkpoint.last);
    packer.put(checkpoint.step);
    packer.put(checkpoint.first_step);
    packer.put(std::int64_t{checkpoint.so_far.newton_iterations});
    packer.put(std::int64_t{checkpoint.so_far.factorizations});
    packer.put(static_cast<std::uint64_t>(checkpoint.so_far.limit_points.size()));
    for (const auto& limit : checkpoint.so_far.limit_points) {
        packer.put(std::int64_t{limit.step});
        packer.put(limit.pressure_Pa);
        packer.put_optional(limit.volume_m3);
        packer.put_list(limit.outputs_m);
    }
    return packer.take();
}

solution::Checkpoint decode_checkpoint(std::span<const std::byte> payload, std::string_view source) {
    Unpacker unpacker{payload, source};
    solution::Checkpoint checkpoint;
    checkpoint.ranks = unpacker.get_count();
    checkpoint.rows = unpacker.get_count();
    checkpoint.control = unpacker.get_count();
    checkpoint.control_output = unpacker.get_count();
    if (unpacker.get_flag()) checkpoint.before = get_point(unpacker);
    checkpoint.last = get_point(unpacker);
    checkpoint.step = unpacker.get<double>();
    checkpoint.first_step = unpacker.get<double>();
    checkpoint.so_far.newton_iterations = unpacker.get_count();
    checkpoint.so_far.factorizations = unpacker.get_count();
    for (auto left = unpacker.get<std::uint64_t>(); left > 0; --left) {
        auto& limit = checkpoint.so_far.limit_points.emplace_back();
        limit.step = unpacker.get_count();
        limit.pressure_Pa = unpacker.get<double>();
        limit.volume_m3 = unpacker.get_optional();
        limit.outputs_m = unpacker.get_list();
    }
    unpacker.require_end();
    return checkpoint;
}

}  // namespace soft::io
