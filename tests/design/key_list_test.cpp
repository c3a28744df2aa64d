// The list of all keys for the reference page.
#include "design/key_list.hpp"

#include <algorithm>

#include "design/markdown.hpp"
#include "design/tree.hpp"
#include "sample.hpp"

namespace {

using namespace soft::design;

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

/// Paths of all keys below a node; names that the user chooses are replaced by the words of the list.
void add_paths(const Node& node, const std::string& path, std::vector<std::string>& paths) {
    if (node.kind != Node::Kind::map) paths.push_back(path);
    for (const Member& member : node.members) {
        const std::string name = path == "outputs" ? "OUTPUT" : path == "loads" ? "CAVITY" : member.key;
        add_paths(member.value, path.empty() ? name : path + "." + name, paths);
    }
}

TEST(KeyList, ContainsEveryKeyOfATemplate) {
    const std::vector<FamilyKeys> families{sample::pipe()};
    const std::string list = key_list(families);
    std::vector<std::string> paths;
    add_paths(parse_yaml(template_yaml(families.front()), "template"), "", paths);
    std::erase_if(paths, [](const std::string& path) {
        return path == "material.mu" ||         // a parameter of a law, see law_list
               path == "loads.CAVITY.acts_on";  // listed once, for all pressures
    });
    EXPECT_GT(paths.size(), 60u);
    for (const std::string& path : paths) EXPECT_GT(count(list, "\n| `" + path + "` |"), 0u) << path;
    EXPECT_EQ(count(list, "\n| `loads.LOAD.acts_on` |"), 1u);
}

TEST(KeyList, ListsAKeyThatMostFamiliesShareOnceAndItsVariantsWithTheFamily) {
    std::vector<FamilyKeys> families(4, sample::pipe());
    families[1].name = "duct", families[2].name = "hose", families[3].name = "line";
    families[3].mesh.front().fallback = "7 mm";
    const std::string list = key_list(families);
    EXPECT_EQ(count(list, "| 1.5 mm |"), 1u);
    EXPECT_LT(list.find("| 1.5 mm |"), list.find("## Families"));
    EXPECT_EQ(count(list, "| 7 mm |"), 1u);
    EXPECT_GT(list.find("| 7 mm |"), list.find("### line"));
}

TEST(KeyList, NamesTheLawsOfAKeyThatFewLawsHave) {
    const std::string list = key_list(std::vector<FamilyKeys>{sample::pipe()});
    EXPECT_EQ(count(list, "| `material.frame` |"), 1u);
    EXPECT_EQ(count(list, "or x and y (cartesian) (holzapfel-gasser-ogden)"), 1u);
    EXPECT_EQ(count(list, "| bulk modulus |"), 1u);
}

TEST(Markdown, EscapesBarsWithinATableCell) {
    EXPECT_EQ(table_head({"a", "b"}) + table_row({"draft | fine", code("x")}),
              "| a | b |\n|---|---|\n| draft \\| fine | `x` |\n");
}

}  // namespace
