#include "design/setting.hpp"

#include "core/text.hpp"
#include "core/units.hpp"
#include "design/checks.hpp"

namespace soft::design {

Key value_key(std::string path, Kind kind, Range range, std::string meaning) {
    return {.path = std::move(path),
            .kind = kind,
            .meaning = std::move(meaning),
            .min = range.min,
            .max = range.max,
            .min_open = range.min_open};
}

Key choice_key(std::string path, std::string fallback, std::vector<std::string> choices, std::string meaning) {
    Key key = with_default(std::move(fallback), value_key(std::move(path), Kind::choice, {}, std::move(meaning)));
    key.choices = std::move(choices);
    return key;
}

Key with_default(std::string fallback, Key key) {
    key.fallback = std::move(fallback);
    return key;
}

Key or_word(std::string word, Key key) {
    key.choices = {word};
    return with_default(std::move(word), std::move(key));
}

std::string default_text(double value, Kind kind) {
    const auto dimension = dimension_of(kind);
    if (!dimension || *dimension == core::Dimension::ratio) return core::number_text(value);
    return core::quantity_text(value, *dimension);
}

std::string text_in_unit(const Key& key, const std::string& unit) {
    const auto value_of = [&](const std::string& text) {
        return core::quantity_or_throw(text, dimension_of(key.kind).value(), ExitCode::internal, key.path);
    };
    constexpr int digits = 9;  // without the rounding error of the quotient
    return core::rounded_text(value_of(key.fallback) / value_of("1 " + unit), digits) + " " + unit;
}

}  // namespace soft::design
