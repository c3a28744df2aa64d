#include "design/course_keys.hpp"

#include "core/text.hpp"
#include "design/words.hpp"

namespace soft::design {
namespace {

using model::Course;

constexpr int longest_table = 5000;
constexpr std::array course_words{Word<Course>{"ramp", Course::ramp}, Word<Course>{"step", Course::step},
                                  Word<Course>{"sine", Course::sine}, Word<Course>{"table", Course::table}};

std::string course_path(const std::string& load) { return load + ".course."; }

Key kind_key(const std::string& path) {
    return {
        .path = path + "kind",
        .kind = Kind::choice,
        .fallback = word_for(course_words, model::TimeCourse{}.kind),
        .meaning = "how the load goes with time: it grows evenly, is there at once, swings about 0, or follows a table",
        .choices = words_of(course_words)};
}

/// A key beside `kind`, and the kind that has it.
struct Detail {
    Course of;
    std::string_view name;
};
constexpr std::array details{Detail{Course::ramp, "rise"}, Detail{Course::sine, "frequency"},
                             Detail{Course::table, "times"}, Detail{Course::table, "shares"}};

Key detail_key(const std::string& path, std::string_view name) {
    Key key{.path = path + std::string{name}};
    if (name == "rise") {
        key.kind = Kind::time;
        key.fallback = "duration";
        key.meaning = "time in which a ramp grows to the full load, where it stays";
        key.min = 0;
        key.min_open = true;
        key.choices = {"duration"};
    } else if (name == "frequency") {
        key.kind = Kind::rate;
        key.meaning = "of a sine; its amplitude is the full load";
        key.min = 0;
        key.min_open = true;
    } else if (name == "times") {
        key.kind = Kind::time;
        key.meaning = "of a table, ascending; between them the load is linear, before and after them it stays";
        key.min = 0;
        key.most = longest_table;
    } else {
        key.kind = Kind::ratio;
        key.meaning = "of a table: the load at each time as a share of the full load";
        key.most = longest_table;
    }
    return key;
}

void check_table(const Values& values, const std::string& path, const model::TimeCourse& course) {
    if (course.shares.size() != course.times_s.size())
        throw values.refuse(
            path + "shares",
            std::to_string(course.shares.size()) + " shares for " + std::to_string(course.times_s.size()) + " times",
            "write as many shares as times");
    for (std::size_t i = 1; i < course.times_s.size(); ++i)
        if (!(course.times_s[i] > course.times_s[i - 1]))
            throw values.refuse(path + "times", "the times do not ascend",
                                "write each of them after the one before it");
}

}  // namespace

void add_course_keys(Schema& schema, const std::string& load, const Node& written, Examples& examples) {
    const std::string path = course_path(load);
    schema.keys.push_back(kind_key(path));
    const Node* course = find(written, "course");
    const Node* kind = course == nullptr ? nullptr : find(*course, "kind");
    const std::string word = kind == nullptr ? schema.keys.back().fallback : kind->text;
    const bool known = std::ranges::find(course_words, word, &Word<Course>::name) != course_words.end();
    for (const Detail& detail : details) {
        if (!known || detail.of == meant_by(course_words, word)) {
            schema.keys.push_back(detail_key(path, detail.name));
            continue;
        }
        const Member* stray = course == nullptr ? nullptr : find_member(*course, detail.name);
        if (stray != nullptr)
            refuse(stray->place, path + stray->key, "a course of kind " + word + " has none",
                   "kind: " + word_for(course_words, detail.of) + ", or leave it out");
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
            "of the tube between the source, whose pressure is that of the course, and the cavity: pressure drop per "
            "volume flow at ambient pressure; none: the course is the pressure in the cavity",
        .min = 0,
        .min_open = true,
        .choices = {"none"}};
}

model::TimeCourse course_of(const Values& values, const std::string& load) {
    model::TimeCourse course;
    const std::string path = course_path(load);
    if (!values.has(path + "kind")) return course;
    course.kind = meant_by(course_words, values.text(path + "kind"));
    switch (course.kind) {
        case Course::ramp: course.time_s = values.number(path + "rise"); break;  // "duration" is 0
        case Course::step: break;
        case Course::sine: course.frequency_Hz = values.number(path + "frequency"); break;
        case Course::table:
            course.times_s = values.numbers(path + "times");
            course.shares = values.numbers(path + "shares");
            check_table(values, path, course);
            break;
    }
    return course;
}

std::optional<model::SupplyLine> line_of(const Values& values, const std::string& load) {
    const std::string path = load + ".line.resistance";
    if (!values.has(path) || values.text(path) == "none") return std::nullopt;
    return model::SupplyLine{values.number(path)};
}

}  // namespace soft::design
