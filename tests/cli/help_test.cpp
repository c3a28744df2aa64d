#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "cli.hpp"
#include "process.hpp"

namespace {

using namespace soft;
using namespace soft::process;

std::set<std::string> matches(const std::string& text, const std::string& pattern) {
    const std::regex expression{pattern};
    std::set<std::string> found;
    for (std::sregex_iterator match{text.begin(), text.end(), expression}, end; match != end; ++match)
        found.insert((*match)[1].str());
    return found;
}

TEST(Help, ManPageAndCompletionHaveTheSameOptions) {
    Folder folder;
    const std::string help = run(folder, "mesh-gen --help").out;
    std::string man = run(folder, "mesh-gen --man").out;
    man = std::regex_replace(man, std::regex{"\\\\-"}, "-");
    const std::string completion = run(folder, "mesh-gen --completion bash").out;
    const auto in_help = matches(help, "\n  (?:-[a-z],)?(--[a-z]+)");
    EXPECT_GE(in_help.size(), 13u);
    EXPECT_EQ(matches(man, "\n\\\\fB(?:-[a-z], )?(--[a-z]+)"), in_help);
    const std::string words = *matches(completion, "then COMPREPLY=\\(\\$\\(compgen -W '([^']*)'").begin();
    EXPECT_EQ(matches(words, "(--[a-z]+)"), in_help);
    EXPECT_EQ(matches(run(folder, "mesh-gen --completion zsh").out, "\n  '[^\\[]*[)*](--[a-z]+)"), in_help);
    EXPECT_EQ(matches(run(folder, "mesh-gen --completion fish | sed 's/ -l / --/'").out, " (--[a-z]+)"), in_help);
}

TEST(Help, ShowsTwoExamplesAndTheExitCodesOfTheProgram) {
    Folder folder;
    const Outcome help = run(folder, "mesh-gen --help");
    EXPECT_EQ(help.code, 0);
    EXPECT_EQ(help.err, "");
    EXPECT_EQ(matches(help.out, "\n  (mesh-gen .*)\n").size(), 2u);
    const auto codes = [&](const std::string& text) { return matches(text, "\n  ([0-9]+) +[-a-zI]"); };
    EXPECT_EQ(codes(help.out), (std::set<std::string>{"0", "64", "65", "66", "70", "73", "74"}));
    EXPECT_EQ(codes(run(folder, "postprocess --help").out),
              (std::set<std::string>{"0", "1", "64", "65", "66", "70", "73", "74"}));
}

TEST(Help, ExamplesRun) {
    Folder folder;
    const Outcome outcome = run(folder, "mesh-gen --template tube | mesh-gen - --set geometry.cap=6mm -o tube.h5");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(fs::exists(folder / "tube.h5"));
}

TEST(Completion, CompletesOptionsFamiliesAndFiles) {
    Folder folder;
    folder.write("some-design.yaml", "");
    const auto complete = [&](const std::string& words, int at) {
        return run(folder, "source <(mesh-gen --completion bash); COMP_WORDS=(" + words +
                               "); COMP_CWORD=" + std::to_string(at) + "; _mesh_gen; echo \"${COMPREPLY[*]}\"")
            .out;
    };
    EXPECT_EQ(complete("mesh-gen --expl", 1), "--explain\n");
    EXPECT_EQ(complete("mesh-gen --template tu", 2), "tube\n");
    EXPECT_EQ(complete("mesh-gen some", 1), "some-design.yaml\n");
    if (run(folder, "type fish zsh").code != 0) GTEST_SKIP() << "fish or zsh is not installed";
    const auto fish = [&](const std::string& line) {
        return run(folder, "mesh-gen --completion fish > c.fish; fish -c 'source c.fish; complete -C \"" + line +
                               "\"' | cut -f 1")
            .out;
    };
    EXPECT_EQ(fish("mesh-gen --expl"), "--explain\n");
    EXPECT_EQ(fish("mesh-gen --template tu"), "tube\n");
    EXPECT_EQ(fish("mesh-gen some"), "some-design.yaml\n");
    // _arguments is defined inside the completion system of an interactive zsh; here it prints its arguments.
    const std::string zsh =
        run(folder, "mesh-gen --completion zsh > c.zsh; zsh -fc '_arguments() { print -l -- $@ }; . ./c.zsh'").out;
    EXPECT_TRUE(contains(zsh, "\n(-o --output)--output=[Write to FILE instead of stdout (-)]:FILE:_files\n"));
}

TEST(Version, IsTextOrJson) {
    Folder folder;
    const Outcome text = run(folder, "mesh-gen --version");
    EXPECT_EQ(text.out.find("mesh-gen " + std::string{cli::version()}), 0u);
    EXPECT_TRUE(contains(text.out, "\ngmsh 4."));
    const auto json = nlohmann::json::parse(run(folder, "mesh-gen --version --json").out);
    EXPECT_EQ(json.at("tool"), "mesh-gen");
    EXPECT_EQ(json.at("version"), cli::version());
    EXPECT_EQ(json.at("revision"), cli::revision());
    for (const char* library : {"gmsh", "CGAL", "HDF5"}) EXPECT_NE(json.at("libraries").at(library), "") << library;
}

}  // namespace
