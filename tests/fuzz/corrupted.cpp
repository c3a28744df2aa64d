/// Valid HDF5 files with corrupted content: the input bytes select changes to a good result (numbers, shapes, types, texts, links to
/// other objects, to themselves or out of the file, sizes without data), which is then sealed again.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "../io/example_case.hpp"
#include "geometry/build.hpp"
#include "io/hdf5_write.hpp"
#include "io/image.hpp"
#include "target.hpp"

namespace soft::fuzz {
namespace {

using io::DatasetHandle, io::GroupHandle, io::SpaceHandle, io::TypeHandle, io::PropertiesHandle;

/// Reads the input bytes in sequence; returns zeros after their end.
class Script {
public:
    explicit Script(std::span<const std::byte> bytes) : bytes_(bytes) {}
    [[nodiscard]] bool ends() const { return bytes_.empty(); }
    unsigned next() {
        if (bytes_.empty()) return 0;
        const unsigned value = std::to_integer<unsigned>(bytes_[0]);
        bytes_ = bytes_.subspan(1);
        return value;
    }
    std::uint64_t number() {
        std::uint64_t value = 0;
        for (int i = 0; i < 8; ++i) value = value << 8U | next();
        return value;
    }
    std::string text() {
        std::string text;
        for (unsigned left = next() % 40; left > 0; --left) text += static_cast<char>(next());
        return text;
    }

private:
    std::span<const std::byte> bytes_;
};

/// A design that fits the mesh of the example, so that its rows fit too.
constexpr const char* good_design = R"(family: imported
geometry:
  file: section.msh
  cavities: {main: main, annex: annex}
material: {law: neo-hookean, mu: 164.4 kPa, density: 1080 kg/m^3}
materials: {collar: {law: ogden, mu: [100 kPa, 2 kPa], alpha: [1.3, 5], density: 1200 kg/m^3}}
model: axisymmetric
supports: {fixed: end_disc}
loads:
  cavities: {main: {pressure: 30 kPa, gas: {dead_volume: 5 mL}}, annex: {shares: main}}
  inlet: {pressure: 1 kPa}
  end_disc: {traction: 2 kPa, along: axis}
path:
  frequencies: 2
  until: {elongation: 3 mm}
  stages:
    inflate: {loads: {cavities: {main: {pressure: 30 kPa}}, inlet: {pressure: 1 kPa}, end_disc: {traction: 1 kPa}}}
    hold: {loads: {cavities: {main: {valve: closed}}}}
    vent: {loads: {cavities: {main: {mass: 1 mg}}}}
outputs:
  elongation: {face: inlet, along: axis}
  tip: {point: [100 mm, 350 mm], along: r}
)";

std::vector<std::byte> good_result() {
    using namespace io::test;
    model::Case section = section_case();
    section.mesh.facet_sets["main"] = {{0, 0}};  // a design calls a cavity like its wall
    section.mesh.facet_sets["annex"] = {{1, 0}};
    model::Shape shape = shape_of(section);
    for (model::Cavity& cavity : shape.cavities) cavity.wall = cavity.name;
    shape.region_materials = {{"collar", "collar"}};
    shape.region_fibers.clear();
    const auto given = io::write_case(section.mesh, shape, {good_design, {}}, example_provenance("mesh-gen"));
    const model::Case solved = geometry::rebuild_case(section.mesh, shape, good_design, "good.yaml");
    io::ResultWriter writer{{given, "case.h5", solved}, example_provenance("solve"), {}};
    for (int i = 0; i < 3; ++i) writer.append(example_step(i), example_displacement(i), example_pressure(i));
    return writer.finish(example_end());
}

struct Objects {
    std::vector<std::string> datasets, groups;
};

Objects objects_of(hid_t file) {
    Objects objects;
    const auto take = [](hid_t, const char* name, const H5O_info_t* info, void* to) -> herr_t {
        auto& found = *static_cast<Objects*>(to);
        (info->type == H5O_TYPE_DATASET ? found.datasets : found.groups).emplace_back(name);
        return 0;
    };
    H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, take, &objects, H5O_INFO_BASIC);
    return objects;
}

const std::string& one_of(const std::vector<std::string>& names, Script& script) {
    const unsigned high = script.next();
    return names[(high << 8U | script.next()) % names.size()];
}

/// Bit patterns of special numbers.
std::uint64_t strange_number(Script& script) {
    using Limits = std::numeric_limits<double>;
    switch (script.next() % 10) {
        case 0: return std::bit_cast<std::uint64_t>(Limits::quiet_NaN());
        case 1: return std::bit_cast<std::uint64_t>(Limits::infinity());
        case 2: return std::bit_cast<std::uint64_t>(Limits::denorm_min());
        case 3: return std::bit_cast<std::uint64_t>(Limits::max());
        case 4: return std::bit_cast<std::uint64_t>(-0.0);
        case 5: return ~std::uint64_t{0};
        case 6: return std::uint64_t{1} << 63U;
        case 7: return (std::uint64_t{1} << 63U) - 1;
        case 8: return script.next();
        default: return script.number();
    }
}

void change_number(hid_t file, const std::string& name, Script& script) {
    const DatasetHandle dataset{H5Dopen2(file, name.c_str(), H5P_DEFAULT)};
    const TypeHandle type{H5Dget_type(dataset.get())};
    const SpaceHandle space{H5Dget_space(dataset.get())};
    const std::size_t width = H5Tget_size(type.get());
    const auto count = static_cast<std::size_t>(std::max<hssize_t>(H5Sget_simple_extent_npoints(space.get()), 0));
    if (count == 0 || count > 100000 || H5Tis_variable_str(type.get()) > 0) return;
    std::vector<char> values(count * width);
    if (H5Dread(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) return;
    const std::size_t at = script.next() % count;
    const auto bits = std::bit_cast<std::array<char, 8>>(strange_number(script));
    std::copy_n(bits.begin(), std::min<std::size_t>(width, 8),
                values.begin() + static_cast<std::ptrdiff_t>(at * width));
    H5Dwrite(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
}

hid_t other_type(Script& script, hid_t own) {
    switch (script.next() % 8) {
        case 0: return H5Tcopy(H5T_STD_I32LE);
        case 1: return H5Tcopy(H5T_IEEE_F32LE);
        case 2: return H5Tcopy(H5T_IEEE_F64BE);
        case 3: {
            const hid_t text = H5Tcopy(H5T_C_S1);
            H5Tset_size(text, H5T_VARIABLE);
            return text;
        }
        case 4: return H5Tcopy(H5T_STD_REF_OBJ);
        case 5: {
            const hid_t text = H5Tcopy(H5T_C_S1);
            H5Tset_size(text, 1 + script.next());
            return text;
        }
        default: return H5Tcopy(own);
    }
}

/// Replaces the dataset by one of any type, shape and size without stored data.
void replace(hid_t file, const std::string& name, Script& script) {
    TypeHandle type;
    {
        const DatasetHandle old{H5Dopen2(file, name.c_str(), H5P_DEFAULT)};
        const TypeHandle own{H5Dget_type(old.get())};
        type = TypeHandle{other_type(script, own.get())};
    }
    if (!type || H5Ldelete(file, name.c_str(), H5P_DEFAULT) < 0) return;
    std::vector<hsize_t> shape(script.next() % 4), chunk;
    for (hsize_t& extent : shape) {
        const unsigned power = script.next() % 44;
        extent = power < 4 ? script.next() % 40 : hsize_t{1} << power;
        chunk.push_back(std::clamp<hsize_t>(extent, 1, 64));
    }
    const SpaceHandle space{shape.empty() ? H5Screate(script.next() % 2 == 0 ? H5S_SCALAR : H5S_NULL)
                                          : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr)};
    const PropertiesHandle properties{H5Pcreate(H5P_DATASET_CREATE)};
    const unsigned layout = script.next();
    if (!shape.empty() && layout % 4 != 0) H5Pset_chunk(properties.get(), static_cast<int>(shape.size()), chunk.data());
    if (!shape.empty() && layout % 4 == 1) H5Pset_deflate(properties.get(), 6);
    if (layout % 4 == 0 && layout % 3 == 0) H5Pset_external(properties.get(), "/dev/zero", 0, H5F_UNLIMITED);
    // Never allocate at creation: then the stored data would match the declared size.
    if (layout % 4 != 0) H5Pset_alloc_time(properties.get(), H5D_ALLOC_TIME_INCR);
    if (layout % 4 == 0) H5Pset_alloc_time(properties.get(), H5D_ALLOC_TIME_LATE);
    const DatasetHandle made{
        H5Dcreate2(file, name.c_str(), type.get(), space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT)};
}

void replace_text(hid_t file, const std::string& name, Script& script) {
    const auto slash = name.rfind('/');
    const GroupHandle parent{
        H5Gopen2(file, slash == std::string::npos ? "/" : name.substr(0, slash).c_str(), H5P_DEFAULT)};
    const std::string last = slash == std::string::npos ? name : name.substr(slash + 1);
    if (!parent || H5Ldelete(parent.get(), last.c_str(), H5P_DEFAULT) < 0) return;
    if (script.next() % 2 == 0) return io::write_text(parent.get(), {last, "1", "corrupted"}, script.text());
    std::vector<std::string> texts(script.next() % 5);
    for (std::string& text : texts) text = script.text();
    io::write_texts(parent.get(), {last, "1", "corrupted"}, texts);
}

/// Replaces some characters of the design.
void edit_design(hid_t file, Script& script) {
    std::string text = good_design;
    const unsigned high = script.next();
    const std::size_t at = (high << 8U | script.next()) % text.size();
    text.replace(at, script.next() % 20, script.text());
    const GroupHandle parent{H5Gopen2(file, "/design", H5P_DEFAULT)};
    if (!parent || H5Ldelete(parent.get(), "effective_yaml", H5P_DEFAULT) < 0) return;
    io::write_text(parent.get(), {"effective_yaml", "1", "corrupted"}, text);
}

void relink(hid_t file, const std::string& name, const std::string& target, Script& script) {
    if (H5Ldelete(file, name.c_str(), H5P_DEFAULT) < 0) return;
    switch (script.next() % 5) {
        case 0: H5Lcreate_soft(("/" + target).c_str(), file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT); break;
        case 1: H5Lcreate_external("/dev/zero", "/x", file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT); break;
        case 2: H5Lcreate_hard(file, target.c_str(), file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT); break;
        case 3: H5Lcreate_hard(file, "/", file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT); break;
        default: break;
    }
}

void change_attribute(hid_t file, const std::string& name, Script& script) {
    const GroupHandle group{H5Gopen2(file, name.c_str(), H5P_DEFAULT)};
    if (!group || H5Aget_num_attrs(group.get()) < 1) return;
    const auto at = static_cast<hsize_t>(script.next() % static_cast<unsigned>(H5Aget_num_attrs(group.get())));
    char attribute[64] = {};
    H5Aget_name_by_idx(group.get(), ".", H5_INDEX_NAME, H5_ITER_INC, at, attribute, sizeof attribute, H5P_DEFAULT);
    H5Adelete(group.get(), attribute);
    if (script.next() % 2 == 0) return io::write_attribute(group.get(), attribute, script.text());
    std::vector<std::int64_t> values(script.next() % 4 + 1);
    for (std::int64_t& value : values) value = static_cast<std::int64_t>(strange_number(script));
    io::write_attribute(group.get(), attribute, std::span<const std::int64_t>{values});
}

void corrupt(hid_t file, const Objects& objects, Script& script) {
    const unsigned kind = script.next();
    const std::string& dataset = one_of(objects.datasets, script);
    const std::string& group = one_of(objects.groups, script);
    switch (kind % 8) {
        case 0:
        case 1:
        case 2: return change_number(file, dataset, script);
        case 3: return replace(file, dataset, script);
        case 4: return kind % 16 < 8 ? replace_text(file, dataset, script) : edit_design(file, script);
        case 5: return relink(file, kind % 16 < 8 ? dataset : group, kind % 3 == 0 ? dataset : group, script);
        case 6: return change_attribute(file, group, script);
        default: {
            const std::string name = group + "/" + script.text();
            H5Lcreate_hard(file, dataset.c_str(), file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
        }
    }
}

std::vector<std::byte> corrupted_image(Script script) {
    static const std::vector<std::byte> good = [] {
        try {
            std::vector<std::byte> image = good_result();
            static_cast<void>(io::read_result(image, "good.h5", geometry::rebuild_case));
            return image;
        } catch (const Error& error) {  // not a refusal of the input
            throw std::logic_error(error.what());
        }
    }();
    const io::FileHandle file = io::open_memory_copy(io::split_image(good, "good").hdf5);
    static const Objects objects = objects_of(file.get());
    constexpr int max_changes = 8;
    for (int i = 0; i < max_changes && !script.ends(); ++i) try {
            corrupt(file.get(), objects, script);
        } catch (const Error&) {  // HDF5 rejects this change
        }
    std::vector<std::byte> image = io::memory_image(file.get());
    io::seal(image);
    return image;
}

}  // namespace

void read(std::span<const std::byte> bytes) {
    std::vector<std::byte> image;
    {
        const io::QuietErrors quiet;
        image = corrupted_image(Script{bytes});
    }
    even_so([&] {
        const io::Result result = io::read_result(image, "fuzz.h5", geometry::rebuild_case);
        for (const std::int64_t step : result.fields.steps()) static_cast<void>(result.fields.read(step));
    });
    static_cast<void>(io::read_case_file(image, "fuzz.h5", geometry::rebuild_case));
}

}  // namespace soft::fuzz
