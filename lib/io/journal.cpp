#include "io/journal.hpp"

#include <cstdint>
#include <cstring>
#include <limits>

#include "core/error.hpp"

namespace soft::io {
namespace {

class Packer {
public:
    template <class T>
    void put(T value) {
        append(&value, sizeof value);
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
    void require_end() const {
        if (!bytes_.empty()) refuse();
    }

private:
    [[noreturn]] void refuse() const {
        throw Error(ExitCode::bad_input, source_, "a step record after the HDF5 data does not make sense",
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
    packer.put(std::uint64_t{step.volume_m3.has_value()});
    packer.put(step.volume_m3.value_or(0));
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
    const bool has_volume = unpacker.get_flag();
    const auto volume = unpacker.get<double>();
    if (has_volume) step.volume_m3 = volume;
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

}  // namespace soft::io
