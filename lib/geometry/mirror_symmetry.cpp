#include "geometry/mirror_symmetry.hpp"

#include <algorithm>

namespace soft::geometry {
namespace {

bool is_text(const design::Values& values, const std::string& path, std::initializer_list<const char*> words) {
    return values.has(path) && std::ranges::any_of(words, [&](const char* word) { return values.text(path) == word; });
}

class AsymmetrySearch {
public:
    AsymmetrySearch(const design::Values& values, std::span<const std::string> faces)
        : values_(values), faces_(faces) {}

    std::string find() {
        for (const std::string& obstacle : values_.names_below("obstacles")) note("obstacles." + obstacle);
        find_in_loads();
        for (const std::string& component : values_.names_below("supports")) find_in_face("supports." + component);
        for (const std::string& name : values_.names_below("outputs")) find_in_output("outputs." + name);
        find_in_fibers();
        if (is_text(values_, "path.branch", {"follow"})) note("path.branch");
        if (values_.has("path.frequencies") && values_.count("path.frequencies") > 0) note("path.frequencies");
        return found_;
    }

private:
    void note(const std::string& path) {
        if (found_.empty()) found_ = path;
    }

    [[nodiscard]] bool is_of_half(const std::string& face) const {
        return std::ranges::find(faces_, face) != faces_.end();
    }

    /// A key with the name of a face; a list of faces counts as asymmetric.
    void find_in_face(const std::string& path) {
        if (!is_of_half(values_.text(path))) note(path);
    }

    void find_in_loads() {
        const std::string cavities = "loads.cavities";
        for (const std::string& chamber : values_.names_below(cavities))
            if (!is_of_half(chamber)) note(cavities + "." + chamber);
        for (const std::string& name : values_.names_below("loads")) {
            const std::string path = "loads." + name;
            if (path == cavities) continue;
            if (name != "gravity" && !is_of_half(name)) note(path);
            if (is_text(values_, path + ".along", {"y", "-y"})) note(path + ".along");
        }
    }

    void find_in_output(const std::string& path) {
        if (!values_.has(path + ".face")) return note(path);  // a point, or contact
        find_in_face(path + ".face");
        if (values_.has(path + ".reference")) find_in_face(path + ".reference");
        if (is_text(values_, path + ".measure", {"force", "moment"})) note(path + ".measure");
    }

    /// One family of fibres winds in one sense.
    void find_in_fibers() {
        std::vector<std::string> groups{"material", "geometry.fibers", "geometry.jacket.fibers"};
        for (const std::string& name : values_.names_below("materials")) groups.push_back("materials." + name);
        for (const std::string& group : groups)
            if (const std::string path = group + ".families"; values_.has(path) && values_.count(path) == 1) note(path);
    }

    const design::Values& values_;
    std::span<const std::string> faces_;
    std::string found_;
};

}  // namespace

std::string find_asymmetry(const design::Values& values, std::span<const std::string> faces) {
    return AsymmetrySearch{values, faces}.find();
}

}  // namespace soft::geometry
