#include "design/tree.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace {

using namespace soft::design;

std::string tree_refusal(const std::string& text) {
    try {
        static_cast<void>(parse_yaml(text, "f"));
    } catch (const soft::Error& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Tree, StoresLineAndColumnFromOne) {
    const Node root = parse_yaml("a: 1\nb:\n  c: [x, yy]\n", "f");
    EXPECT_EQ(find_path(root, "a")->location, "f:1:4");
    EXPECT_EQ(find_member(*find(root, "b"), "c")->location, "f:3:3");
    EXPECT_EQ(find_path(root, "b.c")->items.at(1).location, "f:3:10");
    EXPECT_EQ(find_path(root, "b.c.d"), nullptr);
    EXPECT_EQ(find_path(root, "b.x"), nullptr);
}

TEST(Tree, RejectsUnsupportedYamlAtItsLocation) {
    EXPECT_EQ(tree_refusal("a: 1\nb: 2\na: 3\n").find("f:3:1: key 'a' is written twice"), 0u);
    EXPECT_EQ(tree_refusal("a: &x 1\nb: *x\n").find("f:1:4: anchors and aliases"), 0u);
    EXPECT_EQ(tree_refusal("a: !thing 1\n").find("f:1:4: tags"), 0u);
    EXPECT_EQ(tree_refusal("a: 1\n---\nb: 1\n").find("f:2:1: a second document"), 0u);
    EXPECT_NE(tree_refusal("? [a, b]\n: 1\n").find("a group cannot be a key"), std::string::npos);
    EXPECT_NE(tree_refusal("a: [1, 2\nb: 3\n").find("not YAML"), std::string::npos);
    EXPECT_NE(tree_refusal("a:\n\t- b\n").find("not YAML"), std::string::npos);
    EXPECT_NE(tree_refusal("a: \"b\n").find("not YAML"), std::string::npos);  // a quote that is never closed
    EXPECT_NE(tree_refusal("a: 'b\nc: 1\n").find("not YAML"), std::string::npos);
    EXPECT_EQ(tree_refusal("a: 1\n...\n"), "accepted");
    EXPECT_EQ(tree_refusal("---\na: 1"), "accepted");
}

TEST(Tree, RejectsBytesThatAreNotText) {
    EXPECT_EQ(tree_refusal(std::string("a: 1\nb: \0x", 10)).find("f:2:4: a control character"), 0u);
    EXPECT_EQ(tree_refusal("a: \xff\n").find("f:1:4: not UTF-8"), 0u);
    EXPECT_EQ(tree_refusal("a: \"b\\nc\"\n").find("f:1:4: a control character in 'b?c'"), 0u);
    EXPECT_EQ(tree_refusal("\"b\\x1bc\": 1\n").find("f:1:1: a control character"), 0u);
    EXPECT_EQ(tree_refusal("a: 1\nb: |\n  b\n  c\n"), "accepted");  // keys reject several lines, the parser does not
    EXPECT_EQ(tree_refusal("a: |\n  b\nb: \"c\\nd\"\n").find("f:3:4: a control character"), 0u);
    EXPECT_EQ(tree_refusal("a: \"b\\u00e9 \\\"c\\\"\"\n"), "accepted");
    EXPECT_NE(tree_refusal("\x89HDF\r\n\x1a\n").find("not UTF-8"), std::string::npos);
}

TEST(Tree, BoundsSizeDepthAndCount) {
    EXPECT_NE(tree_refusal(std::string((1u << 20) + 1, ' ')).find("longer than 1 MiB"), std::string::npos);
    EXPECT_NE(tree_refusal("a: " + std::string(40, '[') + std::string(40, ']')).find("levels deep"), std::string::npos);
    EXPECT_NE(tree_refusal(std::string(100000, '[')), "accepted");
    EXPECT_NE(tree_refusal(std::string(100000, '{')), "accepted");
    std::string many = "a: [";
    for (int i = 0; i < 150000; ++i) many += "1,";
    EXPECT_NE(tree_refusal(many + "]").find("more than 100000 values"), std::string::npos);
    // Aliases in ten lines that would expand to 10^9 scalars.
    std::string bomb = "a: &a [x,x,x,x,x,x,x,x,x,x]\n";
    for (char c = 'b'; c < 'k'; ++c) bomb += std::string{c} + ": &" + c + " [*" + static_cast<char>(c - 1) + "]\n";
    EXPECT_NE(tree_refusal(bomb).find("anchors and aliases"), std::string::npos);
}

TEST(Tree, WrittenTextParsesToTheSameText) {
    for (const char* text : {"3 mm", "plain", "a: b",  "a #b", "- x", "",    " lead", "trail ", "\"quoted\"", "it's",
                             "{x}",  "[x]",   "*x",    "&x",   "!x",  "~",   "null",  "true",   "µ-rubber",   "x\\y",
                             "%x",   "@x",    "100 %", "?",    "-",   "---", "...",   "a\tb",   "0x10",       "1e5"}) {
        Node root;
        put(root, "k.v", scalar_node(text, ""));
        Node list;
        list.kind = Node::Kind::list;
        list.items = {scalar_node(text, ""), scalar_node("end", "")};
        put(root, "k.l", list);
        const Node back = parse_yaml(write_yaml(root), "f");
        ASSERT_NE(find_path(back, "k.v"), nullptr) << text;
        EXPECT_EQ(find_path(back, "k.v")->text, text);
        EXPECT_EQ(find_path(back, "k.l")->items.at(0).text, text);
        EXPECT_EQ(find_path(back, "k.l")->items.size(), 2u);
    }
}

TEST(Tree, NotesAreWrittenAsComments) {
    Node root;
    put(root, "a.b", scalar_node("1", ""));
    find_path(root, "a.b")->note = "what: it [is]";
    EXPECT_EQ(write_yaml(root, 10), "a:\n  b: 1    # what: it [is]\n");
}

TEST(Tree, PutCreatesMissingGroupsButDoesNotReplaceAValue) {
    Node root = parse_yaml("material: soft\n", "f");
    put(root, "loads.cavity.pressure", scalar_node("1 kPa", "--set loads.cavity.pressure"));
    EXPECT_EQ(find_path(root, "loads.cavity.pressure")->text, "1 kPa");
    EXPECT_THROW(put(root, "material.mu", scalar_node("1 kPa", "--set material.mu")), soft::Error);
}

TEST(Tree, PutReplacesOneValueOfAList) {
    Node root = parse_yaml("material: {mu: [1 kPa, 2 kPa], times: 3 s}\n", "f");
    put(root, "material.mu.2", scalar_node("5 kPa", "here"));
    EXPECT_EQ(find_path(root, "material.mu")->items.at(0).text, "1 kPa");
    EXPECT_EQ(find_path(root, "material.mu")->items.at(1).text, "5 kPa");
    for (const char* path : {"material.mu.0", "material.mu.3", "material.mu.x", "material.mu.1.x", "material.times.1"})
        EXPECT_THROW(put(root, path, scalar_node("1 kPa", "here")), soft::Error) << path;
}

}  // namespace
