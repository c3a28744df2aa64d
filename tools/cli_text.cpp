#include "cli_text.hpp"

#include <CLI/CLI.hpp>

#include "core/text.hpp"
#include "revision.hpp"  // generated at every build

namespace soft::cli {
namespace {

std::vector<OwnExitCode> exit_codes(const About& about) {
    std::vector<OwnExitCode> codes = about.exit_codes;
    codes.insert(codes.begin(), {ExitCode::ok, "success"});
    codes.insert(codes.end(), {{ExitCode::usage, "usage error: unknown option or invalid combination"},
                               {ExitCode::bad_input, "invalid input; the message names its location"},
                               {ExitCode::cannot_open, "an input cannot be opened"},
                               {ExitCode::internal, "internal error (a bug)"},
                               {ExitCode::cannot_create, "an output cannot be created"},
                               {ExitCode::io_error, "I/O error (disk full, short read)"}});
    return codes;
}

/// Escapes text for roff: backslashes, hyphens (so that options can be copied) and leading dots and apostrophes (requests).
std::string roff(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '\\')
            escaped += "\\e";
        else if (c == '-')
            escaped += "\\-";
        else if ((c == '.' || c == '\'') && (escaped.empty() || escaped.back() == '\n'))
            escaped.append("\\&").append(1, c);
        else
            escaped += c;
    }
    return escaped;
}

/// "-o, --output"
std::string names_of(const CLI::Option& option) {
    std::string names;
    for (const std::string& name : option.get_snames()) names.append(names.empty() ? "-" : ", -").append(name);
    for (const std::string& name : option.get_lnames()) names.append(names.empty() ? "--" : ", --").append(name);
    return names;
}

/// The values that a CLI::IsMember check allows, from the type name, which ends in "{rod,plate}".
std::string words_of(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    const auto open = type.find('{'), close = type.rfind('}');
    if (open == std::string::npos || close == std::string::npos || close < open) return {};
    std::string words = type.substr(open + 1, close - open - 1);
    for (char& c : words)
        if (c == ',') c = ' ';
    return words;
}

bool takes_value(const CLI::Option& option) { return option.get_expected_max() > 0; }

std::string value_name(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    return type.substr(0, type.find(":{"));  // without the words of words_of
}

/// An option in the words of a completion script.
struct OptionText {
    std::vector<std::string> names;  ///< "-o", "--output"
    std::string help;
    std::string value;  ///< "FILE"; empty for a flag
    std::string words;  ///< allowed values, separated by spaces; empty: any value
    bool is_file, is_repeatable;
};

std::vector<OptionText> option_texts(const CLI::App& app) {
    std::vector<OptionText> texts;
    for (const CLI::Option* option : app.get_options()) {
        if (!option->nonpositional()) continue;
        const std::string value = takes_value(*option) ? value_name(*option) : "";
        const bool is_file =
            value.find("FILE") != std::string::npos || value.starts_with("FOLDER") || value.ends_with(".csv");
        const bool is_repeatable = option->get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
        OptionText& text = texts.emplace_back(
            OptionText{{}, option->get_description(), value, words_of(*option), is_file, is_repeatable});
        for (const std::string& name : option->get_snames()) text.names.push_back("-" + name);
        for (const std::string& name : option->get_lnames()) text.names.push_back("--" + name);
    }
    return texts;
}

/// A backslash before each of `special`.
std::string escaped(std::string_view text, std::string_view special) {
    std::string result;
    for (const char c : text) {
        if (special.find(c) != std::string_view::npos) result += '\\';
        result += c;
    }
    return result;
}

}  // namespace

std::string_view version() noexcept { return SOFT_VERSION; }
std::string_view revision() noexcept { return SOFT_REVISION; }

std::string help_footer(const About& about) {
    std::string text = "Examples:\n";
    for (const Example& example : about.examples)
        text.append("  ").append(example.command).append("\n      ").append(example.meaning).append("\n");
    text += "\nExit codes:\n";
    for (const auto& [code, meaning] : exit_codes(about)) {
        const std::string number = std::to_string(static_cast<int>(code));
        text.append("  ").append(number).append(4 - number.size(), ' ').append(meaning).append("\n");
    }
    text.pop_back();  // CLI11 adds the final newline
    return text;
}

std::string man_page(const CLI::App& app, const About& about) {
    std::string title{about.tool};
    for (char& c : title)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    std::string page = ".TH " + roff(title) + " 1 \"\" \"soft\\-actuator " + roff(version()) + "\" \"User Commands\"\n";
    page += ".SH NAME\n" + roff(about.tool) + " \\- " + roff(about.summary) + "\n";
    page += ".SH SYNOPSIS\n.B " + roff(about.tool) + "\n[OPTIONS]";
    for (const CLI::Option* option : app.get_options())
        if (!option->nonpositional()) page += " [" + roff(option->get_name()) + "]";
    page += "\n.SH OPTIONS\n";
    for (const CLI::Option* option : app.get_options()) {
        const std::string names = option->nonpositional() ? names_of(*option) : option->get_name();
        page += ".TP\n\\fB" + roff(names) + "\\fR";
        if (option->nonpositional() && takes_value(*option)) page += " \\fI" + roff(value_name(*option)) + "\\fR";
        page += "\n" + roff(option->get_description()) + "\n";
        if (const std::string words = words_of(*option); !words.empty()) page += ".br\nOne of: " + roff(words) + ".\n";
        if (const std::string value = option->get_default_str(); !value.empty())
            page += ".br\nDefault: " + roff(value) + ".\n";
    }
    page += ".SH EXIT STATUS\n";
    for (const auto& [code, meaning] : exit_codes(about))
        page += ".TP\n\\fB" + std::to_string(static_cast<int>(code)) + "\\fR\n" + roff(meaning) + "\n";
    page += ".SH EXAMPLES\n";
    for (const Example& example : about.examples)
        page += ".TP\n\\fB" + roff(example.command) + "\\fR\n" + roff(example.meaning) + "\n";
    page += ".SH ENVIRONMENT\n.TP\n\\fBNO_COLOR\\fR\nNo colour in messages.\n";
    return page;
}

std::string bash_completion(const CLI::App& app, const About& about) {
    std::string function = "_" + std::string{about.tool};
    for (char& c : function)
        if (c == '-') c = '_';
    std::string all, cases;
    const auto reply = [](const std::string& compgen) {
        return "COMPREPLY=(" + (compgen.empty() ? "" : "$(compgen " + compgen + " -- \"$word\")") + ")";
    };
    for (const OptionText& option : option_texts(app)) {
        for (const std::string& name : option.names)
            if (name.starts_with("--")) all.append(all.empty() ? "" : " ").append(name);
        if (option.value.empty()) continue;
        cases += "        " + core::join(option.names, "|") + ") " +
                 reply(option.is_file         ? "-f"
                       : option.words.empty() ? ""
                                              : "-W '" + option.words + "'") +
                 "; return;;\n";
    }
    std::string script = "# bash completion of " + std::string{about.tool} +
                         ": source this file, or install it in /etc/bash_completion.d\n";
    script += function +
              "() {\n    local word=\"${COMP_WORDS[COMP_CWORD]}\"\n    case \"${COMP_WORDS[COMP_CWORD-1]}\" in\n" +
              cases + "    esac\n";
    script += "    if [[ $word == -* ]]; then " + reply("-W '" + all + "'") + "; else " + reply("-f") + "; fi\n}\n";
    return script + "complete -o filenames -F " + function + " " + std::string{about.tool} + "\n";
}

std::string zsh_completion(const CLI::App& app, const About& about) {
    std::string script = "#compdef " + std::string{about.tool} + "\n_arguments -s";
    for (const OptionText& option : option_texts(app)) {
        std::string rest = "[" + escaped(option.help, "[]:\\") + "]";
        if (!option.value.empty())
            rest += ":" + escaped(option.value, ":\\") + ":" +
                    (option.is_file         ? "_files"
                     : option.words.empty() ? " "
                                            : "(" + option.words + ")");
        // '(-o --output)' excludes the option once it is given; = allows --output=FILE and --output FILE.
        const std::string given = option.is_repeatable ? "*" : "(" + core::join(option.names, " ") + ")";
        for (const std::string& name : option.names)
            script += " \\\n  " +
                      core::single_quoted(
                          given + name + (!option.value.empty() && name.starts_with("--") ? "=" : "") + rest, "'\\''");
    }
    return script + " \\\n  '*:file:_files'\n";
}

std::string fish_completion(const CLI::App& app, const About& about) {
    std::string script;
    for (const OptionText& option : option_texts(app)) {
        script += "complete -c " + std::string{about.tool};
        for (const std::string& name : option.names)
            script += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
        if (option.is_file)
            script += " -r -F";
        else if (!option.value.empty())
            script += " -x -a " + core::single_quoted(option.words, "\\'");
        script += " -d " + core::single_quoted(escaped(option.help, "\\"), "\\'") + "\n";
    }
    return script;
}

std::string completion(const CLI::App& app, const About& about, const std::string& shell) {
    return (shell == "bash" ? bash_completion : shell == "zsh" ? zsh_completion : fish_completion)(app, about);
}

}  // namespace soft::cli
