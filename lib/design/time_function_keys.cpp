#include "design/time_function_keys.hpp"

#include "core/text.hpp"
#include "design/words.hpp"

namespace soft::design {
namespace {

using model::TimeFunctionKind;

constexpr int max_table_rows = 5000;
constexpr std::array time_function_words{
    Word<TimeFunctionKind>{"ramp", TimeFunctionKind::ramp}, Word<TimeFunctionKind>{"step", TimeFunctionKind::step},
    Word<TimeFunctionKind>{"sine", TimeFunctionKind::sine}, Word<TimeFunctionKind>{"table", TimeFunctionKind::table}};

std::string time_function_path(const std::string& load) { return load + ".time_function."; }

Key kind_key(const std::string& path) {
    return {.path = path + "kind",
            .kind = Kind::choice,
            .fallback = word_for(time_function_words, model::TimeFunction{}.kind),
            .meaning = "load over time: linear ramp, step, sine about 0, or table",
            .choices = words_of(time_function_words)};
}

/// A key other than `kind`, and the kind of time function that uses it.
struct Detail {
    TimeFunctionKind of;
    std::string_view name;
};
constexpr std::array details{Detail{TimeFunctionKind::ramp, "rise"}, Detail{TimeFunctionKind::sine, "frequency"},
                             Detail{TimeFunctionKind::table, "times"}, Detail{TimeFunctionKind::table, "shares"}};

Key detail_key(const std::string& path, std::string_view name) {
    Key key{.path = path + std::string{name}};
    if (name == "rise") {
        key.kind = Kind::time;
        key.fallback = "duration";
        key.meaning = "duration of the ramp to the full load, which is then held";
        key.min = 0;
        key.min_open = true;
        key.choices = {"duration"};
    } else if (name == "frequency") {
        key.kind = Kind::rate;
        key.meaning = "frequency of a sine; its amplitude is the full load";
        key.min = 0;
        key.min_open = true;
    } else if (name == "times") {
        key.kind = Kind::time;
        key.meaning =
            "times of a table, ascending; the load is linear between them and constant before the first and after the last";
        key.min = 0;
        key.max_count = max_table_rows;
    } else {
        key.kind = Kind::ratio;
        key.meaning = "shares of a table: the load at each time as a share of the full load";
        key.max_count = max_table_rows;
    }
    return key;
}

void check_table(const Values& values, const std::string& path, const model::TimeFunction& time_function) {
    if (time_function.shares.size() != time_function.times_s.size())
        throw values.refuse(path + "shares",
                            std::to_string(time_function.shares.size()) + " shares for " +
                                std::to_string(time_function.times_s.size()) + " times",
                            "write as many shares as times");
    for (std::size_t i = 1; i < time_function.times_s.size(); ++i)
        if (!(time_function.times_s[i] > time_function.times_s[i - 1]))
            throw values.refuse(path + "times", "the times are not ascending",
                                "write each time after the one before it");
}

}  // namespace

void add_time_function_keys(Schema& schema, const std::string& load, const Node& written, Examples& examples) {
    const std::string path = time_function_path(load);
    schema.keys.push_back(kind_key(path));
    const Node* time_function = find(written, "time_function");
    const Node* kind = time_function == nullptr ? nullptr : find(*time_function, "kind");
    const std::string word = kind == nullptr ? schema.keys.back().fallback : kind->text;
    const bool known =
        std::ranges::find(time_function_words, word, &Word<TimeFunctionKind>::name) != time_function_words.end();
    for (const Detail& detail : details) {
        if (!known || detail.of == value_of_word(time_function_words, word)) {
            schema.keys.push_back(detail_key(path, detail.name));
            continue;
        }
        const Member* stray = time_function == nullptr ? nullptr : find_member(*time_function, detail.name);
        if (stray != nullptr)
            refuse(stray->location, path + stray->key, "a time function of kind " + word + " has no such key",
                   "kind: " + word_for(time_function_words, detail.of) + ", or leave it out");
    }
    examples[path + "frequency"] = "5 Hz";
    examples[path + "times"] = "[0 s, 50 ms]";
    examples[path + "shares"] = "[0, 1]";
}

Key line_key(const std::string& load) {
    return {
        .path = load + ".line.resistance",
        .kind = Kind::flow_resistance,
        .fallback = "none",
        .meaning =
            "flow resistance of the tube between the source, whose pressure is the time function, and the cavity: pressure drop per "
            "volume flow at ambient pressure; none: the time function is the pressure in the cavity",
        .min = 0,
        .min_open = true,
        .choices = {"none"}};
}

model::TimeFunction time_function_of(const Values& values, const std::string& load) {
    model::TimeFunction time_function;
    const std::string path = time_function_path(load);
    if (!values.has(path + "kind")) return time_function;
    time_function.kind = value_of_word(time_function_words, values.text(path + "kind"));
    switch (time_function.kind) {
        case TimeFunctionKind::ramp: time_function.time_s = values.number(path + "rise"); break;  // "duration" is 0
        case TimeFunctionKind::step: break;
        case TimeFunctionKind::sine: time_function.frequency_Hz = values.number(path + "frequency"); break;
        case TimeFunctionKind::table:
            time_function.times_s = values.numbers(path + "times");
            time_function.shares = values.numbers(path + "shares");
            check_table(values, path, time_function);
            break;
    }
    return time_function;
}

std::optional<model::SupplyLine> line_of(const Values& values, const std::string& load) {
    const std::string path = load + ".line.resistance";
    if (!values.has(path) || values.text(path) == "none") return std::nullopt;
    return model::SupplyLine{values.number(path)};
}

}  // namespace soft::design
