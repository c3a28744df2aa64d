#include "view/scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/hash.hpp"
#include "core/text.hpp"
#include "post/contact_pressure.hpp"
#include "post/quantity.hpp"
#include "post/region_points.hpp"
#include "post/step_fields.hpp"
#include "view/obstacle_lines.hpp"
#include "view/palette.hpp"
#include "view/skin.hpp"
#include "view/text.hpp"

namespace soft::view {
namespace {

constexpr double mm_per_m = 1e3;
constexpr double outliers = 0.01;      // fraction of the values at each end that is outside the colour range
constexpr double space_around = 0.08;  // the body, over its diagonal, in which obstacles are drawn
constexpr int sectors = 48;            // per full turn: chords deviate by 0.2 % of the radius from the circle

template <class T>
std::string packed(const std::vector<T>& values) {
    return core::base64(std::as_bytes(std::span(values)));  // little-endian, as all supported machines and WebGL
}

struct Range {
    double low = HUGE_VAL, high = -HUGE_VAL;
    void include(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    [[nodiscard]] std::uint16_t share(double value) const {
        const double t = high > low ? (value - low) / (high - low) : 0.5;
        return static_cast<std::uint16_t>(std::lround(65535 * std::clamp(t, 0.0, 1.0)));
    }
};

/// A field in all frames, in its unit.
struct Field {
    const post::QuantityInfo* info;
    std::vector<double> values;  ///< [frame][base]
};

/// Positions and fields of the bases in all frames.
struct Motion {
    std::vector<std::int64_t> steps;
    std::vector<view::Point> positions_m;  ///< [frame][base]
    std::vector<view::Point> undeformed_m;
    std::vector<Field> fields;
    std::vector<std::vector<Vector3>> shifts_m;  ///< [frame][obstacle]
};

std::vector<const post::QuantityInfo*> available(const io::Result& result) {
    const bool knows_stress = rubber_history(result).is_known();
    std::vector<const post::QuantityInfo*> list;
    for (const post::QuantityInfo& info : post::quantities())
        if (post::is_available(info.quantity, result.model) && (knows_stress || !post::needs_stress(info.quantity)))
            list.push_back(&info);
    return list;
}

/// Size of the arrays of one frame [bytes].
std::size_t frame_bytes(const view::Skin& skin, std::size_t fields) { return 2 * skin.base_count() * (3 + fields); }

view::Skin make_skin(const model::Case& model, const post::RegionPoints& region_points, std::size_t fields,
                     std::size_t frame_budget) {
    view::SkinOptions options;  // extent as modelled: cut open to show the inside; the viewer adds the mirror images
    options.sectors = sectors;
    for (options.segments = 4; options.segments > 1; options.segments /= 2) {
        view::Skin skin = view::make_skin(model, region_points, options);
        if (frame_bytes(skin, fields) <= frame_budget) return skin;
    }
    return view::make_skin(model, region_points, options);
}

/// Selects at most `max_steps` of the stored steps evenly, including the first and the last.
std::vector<std::int64_t> choose_steps(const std::vector<std::int64_t>& stored, std::size_t max_steps) {
    if (stored.size() <= max_steps) return stored;
    std::vector<std::int64_t> chosen;
    for (std::size_t i = 0; i < max_steps; ++i)
        chosen.push_back(stored[max_steps > 1 ? i * (stored.size() - 1) / (max_steps - 1) : stored.size() - 1]);
    return chosen;
}

Motion follow(const io::Result& result, const view::Skin& skin, const post::RegionPoints& region_points,
              std::size_t byte_budget) {
    Motion motion;
    post::RubberHistory history = rubber_history(result);
    for (const post::QuantityInfo* info : available(result)) motion.fields.push_back({info, {}});
    const std::size_t max_steps = std::max<std::size_t>(2, byte_budget / frame_bytes(skin, motion.fields.size()));
    motion.steps = choose_steps(result.fields.steps(), max_steps);
    motion.undeformed_m = view::base_positions(skin, result.model, region_points, {});
    for (const std::int64_t step : motion.steps) {
        const io::FieldReader::Values values = result.fields.read(step).value();
        const post::NodalState state{values.displacement_m, values.pressure_Pa,
                                     post::obstacle_shifts(result.model, result.steps, static_cast<std::size_t>(step)),
                                     history.at_if_known(step, values.displacement_m, history.time_of(step))};
        motion.shifts_m.push_back(state.shifts);
        const post::StepFields local = post::step_fields(result.model, region_points, state);
        const auto bases = view::base_positions(skin, result.model, region_points, values.displacement_m);
        motion.positions_m.insert(motion.positions_m.end(), bases.begin(), bases.end());
        for (Field& field : motion.fields) {
            const auto nodal = post::nodal_values(field.info->quantity, result.model, region_points, state, local);
            for (const double value : view::base_values(skin, nodal))
                field.values.push_back(value / field.info->SI_per_unit);
        }
    }
    std::erase_if(motion.fields, [](const Field& field) {  // nothing touches
        return field.info->quantity == post::Quantity::contact_pressure &&
               std::ranges::none_of(field.values, [](double value) { return value > 0; });
    });
    return motion;
}

nlohmann::ordered_json field_json(const Field& field) {
    std::vector<double> sorted = field.values;
    const auto quantile = [&](double share) {
        const auto at = sorted.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
        std::nth_element(sorted.begin(), at, sorted.end());
        return *at;
    };
    const Range colours{quantile(outliers), quantile(1 - outliers)};
    Range all;
    for (const double value : field.values) all.include(value);
    const std::string unit = field.info->unit.empty() ? std::string{} : std::string{" "}.append(field.info->unit);
    const double noticeable = 1e-3 * (colours.high - colours.low);
    const bool below = all.low<colours.low - noticeable, above = all.high> colours.high + noticeable;
    std::vector<std::uint16_t> shares;
    for (const double value : field.values) shares.push_back(colours.share(value));
    return {{"label", field.info->label},
            {"unit", field.info->unit},
            {"meaning", field.info->meaning},
            {"low_text", std::string{below ? "\u2264 " : ""} + core::rounded_text(colours.low, 4) + unit},
            {"high_text", std::string{above ? "\u2265 " : ""} + core::rounded_text(colours.high, 4) + unit +
                              (above ? std::string{" (largest "} + core::rounded_text(all.high, 4) + ")" : "")},
            {"values", packed(shares)}};
}

/// "step 3: pressure 3.2 kPa, elongation 40 mm".
std::string frame_label(const post::Curve& curve, std::size_t row) {
    std::vector<std::string> words;
    for (const post::Column& column : curve.columns)
        if (column.role == post::Role::coordinate)
            words.push_back(column.quantity + " " + post::value_text(column, column.values[row]));
    const post::Column* stable = curve.find("stable");
    const bool is_unstable = stable != nullptr && stable->values[row] == 0;
    return "step " + std::to_string(row) + ": " + core::join(words) + (is_unstable ? " (unstable)" : "");
}

std::vector<std::uint16_t> shares(const std::vector<view::Point>& points, const std::array<Range, 3>& ranges) {
    std::vector<std::uint16_t> out;
    out.reserve(3 * points.size());
    for (const view::Point& point : points)
        for (std::size_t i = 0; i < 3; ++i) out.push_back(ranges[i].share(point[i]));
    return out;
}

/// Signs of the coordinates in the modelled part and in its mirror images.
std::vector<std::array<double, 3>> mirrors(const model::Case& model) {
    std::vector<std::array<double, 3>> signs = {{1, 1, 1}};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (model.kinematics != model::Kinematics::solid || !model.symmetry_planes[axis]) continue;
        const std::size_t count = signs.size();
        for (std::size_t i = 0; i < count; ++i) {
            signs.push_back(signs[i]);
            signs.back()[axis] = -1;
        }
    }
    return signs;
}

void add_ranges(nlohmann::ordered_json& json, const char* low, const char* high, const std::array<Range, 3>& ranges) {
    for (const Range& range : ranges) {
        json[low].push_back(mm_per_m * range.low);
        json[high].push_back(mm_per_m * range.high);
    }
}

/// Adds the lines of each obstacle where it is in the undeformed state, and its displacements [frame].
void add_obstacles(nlohmann::ordered_json& json, const model::Case& model, const Motion& motion,
                   const std::array<Range, 3>& body) {
    Window window;
    double diagonal = 0;
    for (std::size_t i = 0; i < 3; ++i) diagonal = std::hypot(diagonal, body[i].high - body[i].low);
    for (std::size_t i = 0; i < 3; ++i) {
        window.low[i] = body[i].low - space_around * diagonal;
        window.high[i] = body[i].high + space_around * diagonal;
    }
    for (std::size_t k = 0; k < model.obstacles.size(); ++k) {
        std::vector<float> ends;
        nlohmann::ordered_json shifts;
        for (const auto& frame : motion.shifts_m)
            shifts.push_back({mm_per_m * frame[k][0], mm_per_m * frame[k][1], mm_per_m * frame[k][2]});
        for (const Line& line : obstacle_lines(model, model.obstacles[k], {}, window, Extent::modelled))
            for (const Point& end : line)
                for (const double x : end) ends.push_back(static_cast<float>(mm_per_m * x));
        json["obstacles"].push_back({{"lines", packed(ends)}, {"shifts", shifts}});
    }
}

/// Adds the positions and the window that contains the body with its mirror images in all frames. Returns the window.
std::array<Range, 3> add_positions(nlohmann::ordered_json& json, const view::Skin& skin, const Motion& motion,
                                   std::span<const std::array<double, 3>> mirrors) {
    std::array<Range, 3> bases, window;
    const auto include = [](std::array<Range, 3>& ranges, const view::Point& point) {
        for (std::size_t i = 0; i < 3; ++i) ranges[i].include(point[i]);
    };
    for (const auto* list : {&motion.undeformed_m, &motion.positions_m})
        for (std::size_t i = 0; i < list->size(); ++i) include(bases, (*list)[i]);
    const std::size_t count = skin.base_count();
    for (std::size_t frame = 0; frame < motion.steps.size(); ++frame)
        for (const view::Point& point :
             view::vertex_positions(skin, std::span(motion.positions_m).subspan(frame * count, count)))
            for (const auto& sign : mirrors)
                include(window, {sign[0] * point[0], sign[1] * point[1], sign[2] * point[2]});
    add_ranges(json, "low", "high", bases);
    add_ranges(json, "window_low", "window_high", window);
    json["positions"] = packed(shares(motion.positions_m, bases));
    json["undeformed"] = packed(shares(motion.undeformed_m, bases));
    return window;
}

void add_skin(nlohmann::ordered_json& json, const view::Skin& skin) {
    std::vector<std::uint32_t> base, triangles, creases;
    std::vector<std::uint8_t> placement;
    for (const view::Skin::Vertex& vertex : skin.vertices) {
        base.push_back(static_cast<std::uint32_t>(vertex.base));
        placement.push_back(static_cast<std::uint8_t>(vertex.placement));  // at most `sectors` + 1 placements
    }
    for (const auto& triangle : view::triangles(skin))
        for (const std::int32_t vertex : triangle) triangles.push_back(static_cast<std::uint32_t>(vertex));
    for (const auto& crease : skin.creases)
        for (const std::int32_t vertex : crease) creases.push_back(static_cast<std::uint32_t>(vertex));
    json["base"] = packed(base);
    json["placement"] = packed(placement);
    json["placements"] = skin.placements;
    json["triangles"] = packed(triangles);
    json["creases"] = packed(creases);
}

std::string palette_bytes() {
    std::vector<std::uint8_t> bytes;
    for (const view::Rgb& colour : view::viridis())
        for (const double part : {colour.red, colour.green, colour.blue})
            bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * part)));
    return packed(bytes);
}

}  // namespace

post::RubberHistory rubber_history(const io::Result& result) {
    std::vector<int> inside_steps;
    if (result.end)
        for (const model::LimitPoint& point : result.end->limit_points) inside_steps.push_back(point.step);
    return {result.model, result.steps, std::move(inside_steps),
            [&result](std::int64_t row) -> std::optional<std::vector<double>> {
                auto values = result.fields.read(row);
                return values ? std::optional(std::move(values->displacement_m)) : std::nullopt;
            },
            result.fields.steps().size() == result.steps.size()};
}

Scene make_scene(const io::Result& result, const post::Curve& curve, std::size_t byte_budget) {
    const std::vector<std::int64_t>& stored = result.fields.steps();
    if (stored.empty()) return {};
    const post::RegionPoints region_points = post::make_region_points(result.model.mesh);
    const view::Skin skin =
        make_skin(result.model, region_points, available(result).size(), byte_budget / stored.size());
    const Motion motion = follow(result, skin, region_points, byte_budget);

    nlohmann::ordered_json json = {{"bases", skin.base_count()}, {"palette", palette_bytes()}};
    for (const std::int64_t step : motion.steps)
        json["frames"].push_back({{"step", step}, {"label", frame_label(curve, static_cast<std::size_t>(step))}});
    add_skin(json, skin);
    json["mirrors"] = mirrors(result.model);
    add_obstacles(json, result.model, motion, add_positions(json, skin, motion, mirrors(result.model)));
    for (const Field& field : motion.fields) json["fields"].push_back(field_json(field));
    return {json_in_page(json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)), motion.steps.size(),
            stored.size()};
}

}  // namespace soft::view
