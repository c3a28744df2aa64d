#include "design/time_function_keys.hpp"

#include <algorithm>
#include <functional>

#include "design/setting.hpp"

namespace soft::design {
namespace {

using model::TimeFunction, model::TimeFunctionKind;

Setting<TimeFunction> table_column(Setting<TimeFunction> setting) {
    constexpr int max_table_rows = 5000;
    setting.key.max_count = max_table_rows;
    return setting;
}

const Settings<TimeFunction>& time_function_settings() {
    static const Settings<TimeFunction> settings{
        choice("kind", &TimeFunction::kind,
               {{"ramp", TimeFunctionKind::ramp},
                {"step", TimeFunctionKind::step},
                {"sine", TimeFunctionKind::sine},
                {"table", TimeFunctionKind::table}},
               "load over time: linear ramp, step, sine about 0, or table"),
        or_word("duration", quantity("rise", &TimeFunction::time_s, Kind::time, above(0),
                                     "duration of the ramp to the full load, which is then held")),
        without_default(quantity("frequency", &TimeFunction::frequency_Hz, Kind::rate, above(0),
                                 "frequency of a sine; its amplitude is the full load")),
        table_column(quantity("times", &TimeFunction::times_s, Kind::time, at_least(0),
                              "times of a table, ascending; the load is linear between them and constant before the "
                              "first and after the last")),
        table_column(number("shares", &TimeFunction::shares, {},
                            "shares of a table: the load at each time as a share of the full load"))};
    return settings;
}

/// The kind of time function that has a key.
std::string_view kind_with(std::string_view name) {
    return name == "rise" ? "ramp" : name == "frequency" ? "sine" : "table";
}

void check_table(const Values& values, const std::string& path, const TimeFunction& table) {
    if (table.shares.size() != table.times_s.size())
        throw values.refuse(
            path + ".shares",
            std::to_string(table.shares.size()) + " shares for " + std::to_string(table.times_s.size()) + " times",
            "write as many shares as times");
    if (!std::ranges::is_sorted(table.times_s, std::less_equal{}))
        throw values.refuse(path + ".times", "the times are not ascending", "write each time after the one before it");
}

}  // namespace

void add_time_function_keys(Schema& schema, const std::string& load, const Node& written, Examples& examples) {
    const std::string path = load + ".time_function";
    std::vector<Key> keys = keys_of(time_function_settings(), path);
    const Node* time_function = find(written, "time_function");
    const Node* kind = time_function == nullptr ? nullptr : find(*time_function, "kind");
    const std::string word = kind == nullptr ? keys.front().fallback : kind->text;
    const bool known = std::ranges::find(keys.front().choices, word) != keys.front().choices.end();
    for (Key& key : keys) {
        const std::string name = key.path.substr(path.size() + 1);
        if (!known || name == "kind" || kind_with(name) == word) {
            schema.keys.push_back(std::move(key));
            continue;
        }
        const Member* stray = time_function == nullptr ? nullptr : find_member(*time_function, name);
        if (stray != nullptr)
            refuse(stray->location, key.path, "a time function of kind " + word + " has no such key",
                   "kind: " + std::string{kind_with(name)} + ", or leave it out");
    }
    examples[path + ".frequency"] = "5 Hz";
    examples[path + ".times"] = "[0 s, 50 ms]";
    examples[path + ".shares"] = "[0, 1]";
}

TimeFunction time_function_of(const Values& values, const std::string& load) {
    const std::string path = load + ".time_function";
    TimeFunction time_function = read_settings(time_function_settings(), values, path);
    if (time_function.kind == TimeFunctionKind::table) check_table(values, path, time_function);
    return time_function;
}

}  // namespace soft::design
