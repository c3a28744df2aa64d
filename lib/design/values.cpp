#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "core/text.hpp"
#include "design/design.hpp"

namespace soft::design {
namespace {

const Values::Entry& entry_at(const std::map<std::string, Values::Entry, std::less<>>& entries, std::string_view path) {
    const auto entry = entries.find(path);
    if (entry == entries.end()) throw std::logic_error("no key '" + std::string{path} + "' in the schema");
    return entry->second;
}

}  // namespace

double Values::number(std::string_view path) const { return entry_at(entries_, path).number; }

const std::vector<double>& Values::numbers(std::string_view path) const { return entry_at(entries_, path).numbers; }

int Values::count(std::string_view path) const {
    return static_cast<int>(std::lround(entry_at(entries_, path).number));
}

const std::string& Values::text(std::string_view path) const { return entry_at(entries_, path).text; }

const std::string& Values::location(std::string_view path) const { return entry_at(entries_, path).location; }

bool Values::given(std::string_view path) const {
    const auto entry = entries_.find(path);
    return entry != entries_.end() && entry->second.given;
}

bool Values::has(std::string_view path) const { return entries_.contains(path); }

std::vector<std::string> Values::names_below(std::string_view group) const {
    const std::string prefix = std::string{group} + ".";
    std::vector<std::string> names;
    for (auto entry = entries_.lower_bound(prefix); entry != entries_.end() && entry->first.starts_with(prefix);
         ++entry) {
        std::string name = entry->first.substr(prefix.size(), entry->first.find('.', prefix.size()) - prefix.size());
        if (names.empty() || names.back() != name) names.push_back(std::move(name));
    }
    return names;
}

std::vector<std::string> Values::file_keys() const {
    std::vector<std::string> keys;
    for (const auto& [path, entry] : entries_) {
        const bool names_file = path == "geometry.file" || path.ends_with(".profile") || path.ends_with(".surface");
        if (names_file && entry.given && entry.text.find('\n') == std::string::npos) keys.push_back(path);
    }
    return keys;
}

Error Values::refuse(std::string_view path, std::string_view problem, std::string_view remedy) const {
    const auto entry = entries_.find(path);
    std::string location = entry == entries_.end() ? std::string{} : entry->second.location;
    if (location != "--set " + std::string{path}) location.append(location.empty() ? "" : ": ").append(path);
    return Error(ExitCode::bad_input, location, problem, remedy);
}

std::string file_from(std::string_view location, const std::string& file) {
    if (location.starts_with("--set") || location.starts_with('<')) return file;
    for (int part = 0; part < 2; ++part) location = location.substr(0, location.rfind(':'));  // "designs/part.yaml:3:9"
    return (std::filesystem::path{location}.parent_path() / file).string();
}

void Values::set(std::string path, Entry entry) { entries_.insert_or_assign(std::move(path), std::move(entry)); }

}  // namespace soft::design
