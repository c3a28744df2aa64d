#include "cli.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <nlohmann/json.hpp>

#include "cli_text.hpp"
#include "core/memory.hpp"
#include "core/text.hpp"

namespace soft::cli {
namespace {

std::string bare_name(std::string_view program) {
    const auto slash = program.rfind('/');
    return std::string{slash == std::string_view::npos ? program : program.substr(slash + 1)};
}

std::string command_line_of(int argc, char** argv) {
    std::vector<std::string> words(argv, argv + argc);
    if (!words.empty()) words.front() = bare_name(words.front());
    return cli::command_line_of(words);
}

/// Opens /dev/null for each closed standard stream. Otherwise a file opened later would get that descriptor and receive messages or
/// data. The access mode is the opposite of the stream's use, so that using it still fails as on a closed stream.
void open_missing_streams() {
    for (int stream = 0; stream <= 2; ++stream)
        if (::fcntl(stream, F_GETFD) < 0) static_cast<void>(::open("/dev/null", stream == 0 ? O_WRONLY : O_RDONLY));
}

/// File names and keys in messages are untrusted: core::one_line removes control characters and line breaks.
void print_error(std::string_view line) {
    std::string text = core::one_line(line, std::string_view::npos);
    text += '\n';
    static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
    std::fflush(stderr);
}

ExitCode report_bug(std::string_view tool, std::string_view command_line, std::string_view what) {
    print_error(std::string{tool} + ": internal error: " + core::one_line(what, 500) +
                "; this is a bug, please report it with the input files of: " + core::one_line(command_line, 500));
    return ExitCode::internal;
}

std::vector<std::string> long_options(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

[[noreturn]] void refuse_usage(const CLI::App& app, const About& about, const CLI::ParseError& error) {
    const std::string help = "see `" + std::string{about.tool} + " --help`";
    const std::vector<std::string> rest = app.remaining();
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError) && !rest.empty()) {
        const std::string word = rest.front().substr(0, rest.front().find('='));
        if (!word.starts_with('-'))
            throw Error(ExitCode::usage, "", "one argument too many: " + core::quoted(rest.front()), help);
        const auto near = core::nearest(word, long_options(app));
        throw Error(ExitCode::usage, "", "unknown option " + core::quoted(word),
                    near ? "did you mean " + core::quoted(*near) + "?" : help);
    }
    throw Error(ExitCode::usage, "", core::one_line(error.what(), 300), help);
}

/// An empty value, for example from an unset shell variable, would otherwise disable the option without notice.
void refuse_empty_values(const CLI::App& app) {
    for (const CLI::Option* option : app.get_options())
        for (const std::string& value : option->results())
            if (value.empty())
                throw Error(ExitCode::usage,
                            option->get_lnames().empty() ? option->get_name() : "--" + option->get_lnames().front(),
                            "the value is empty", "give a value or omit the option");
}

bool has_option(int argc, char** argv, std::string_view name) {
    for (int i = 1; i < argc && std::string_view{argv[i]} != "--"; ++i) {
        const std::string_view word{argv[i]};
        if (word == name || word.starts_with(std::string{name} + "=")) return true;
    }
    return false;
}

/// "mesh-gen 0.1.0 (revision)"
std::string version_text(const About& about) {
    return std::string{about.tool}.append(" ").append(version()).append(" (").append(revision()).append(")");
}

void print_version(const About& about, bool as_json) {
    nlohmann::ordered_json json = summary_head(about.tool);
    std::string text = version_text(about) + "\n";
    for (const Library& library : about.libraries()) {
        json["libraries"][library.name] = library.version;
        text += library.name + " " + library.version + "\n";
    }
    if (as_json)
        write_json("-", json);
    else
        write_output("-", text);
}

}  // namespace

void add_common_options(CLI::App& app, CommonOptions& common, const About& about) {
    app.name(std::string{about.tool});
    app.description(std::string{about.tool} + " - " + std::string{about.summary});
    app.footer(help_footer(about));
    app.set_help_flag("-h,--help", "Print this help and exit");
    app.add_option("-o,--output", common.output, "Write to FILE instead of stdout (-)")->type_name("FILE");
    app.add_option("--json", common.json,
                   "Write a machine-readable summary to FILE; with --version: print the versions as JSON")
        ->type_name("FILE");
    app.add_flag_callback(
        "-q,--quiet", [&common] { common.verbosity = Verbosity::quiet; },
        "Print only errors, and warnings that results may be wrong");
    app.add_flag_callback(
        "-v,--verbose", [&common] { common.verbosity = Verbosity::verbose; }, "Print more messages");
    app.add_flag("--version")->description("Print version, git revision and versions of the libraries, and exit");
    app.add_option("--completion")
        ->description("Print a completion script for the shell, and exit")
        ->type_name("SHELL")
        ->check(CLI::IsMember({"bash", "zsh", "fish"}));
    app.add_flag("--man")->description("Print the man page (roff), and exit");
}

void add_input(CLI::App& app, std::string& input, const std::string& name, const std::string& help) {
    app.add_option(name, input, help + "; omitted or -: stdin")->type_name("FILE");
}

void add_inputs(CLI::App& app, std::vector<std::string>& inputs, const std::string& name, const std::string& help) {
    app.add_option(name, inputs, help + "; omitted or -: stdin")->type_name("FILE");
}

void add_set_option(CLI::App& app, std::vector<std::string>& overrides) {
    // One value per option: otherwise CLI11 would take the positional input as a further value.
    app.add_option("--set", overrides, "Override a value of the design, e.g. --set geometry.wall=2.5mm (repeatable)")
        ->type_name("KEY.PATH=VALUE")
        ->allow_extra_args(false)
        ->take_all();
}

void require_at_most_one(const CLI::App& app, std::span<const std::string> options) {
    const auto given =
        std::count_if(options.begin(), options.end(), [&](const std::string& name) { return app.count(name) > 0; });
    if (given > 1)
        throw Error(ExitCode::usage, "", core::join(options, " and ") + " exclude each other", "use one of them");
}

void check_distinct(const std::vector<NamedFile>& inputs, const CommonOptions& common, std::vector<NamedFile> outputs) {
    namespace fs = std::filesystem;
    outputs.insert(outputs.begin(), {{"--output", common.output}, {"--json", common.json}});
    const auto is_same = [](const std::string& a, const std::string& b) {
        std::error_code failed;  // set if a file does not exist yet; then the names are compared
        if (fs::exists(a, failed) && !fs::is_regular_file(a, failed))
            return false;  // devices such as /dev/null can be shared
        if (fs::equivalent(a, b, failed) && !failed) return true;
        const auto whole = [](const std::string& name) {  // empty if the working folder was removed
            std::error_code gone;
            const fs::path absolute = fs::absolute(name, gone);
            return gone ? fs::path{} : fs::weakly_canonical(absolute, gone);
        };
        return whole(a) == whole(b) && !whole(a).empty();
    };
    const auto is_file = [](const NamedFile& named) { return !named.file.empty() && named.file != "-"; };
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const NamedFile& out = outputs[i];
        if (out.file.empty()) continue;
        for (const NamedFile& before : std::span(outputs).first(i)) {
            if (out.file == "-" && before.file == "-")
                throw Error(ExitCode::usage, "", before.option + " and " + out.option + " cannot both go to stdout",
                            "write one of them to a file");
            if (is_file(out) && is_file(before) && is_same(out.file, before.file))
                throw Error(ExitCode::usage, out.option + " " + out.file, "is also the file of " + before.option,
                            "use different files");
        }
        for (const NamedFile& in : inputs)
            if (is_file(out) && is_file(in) && is_same(out.file, in.file))
                throw Error(ExitCode::usage, out.option + " " + out.file, "would overwrite the input",
                            "write to another file");
    }
}

bool parse(CLI::App& app, const About& about, CommonOptions& common, int argc, char** argv) {
    common.command_line = command_line_of(argc, argv);
    if (has_option(argc, argv, "--version")) {  // before CLI11, because here --json takes no file
        print_version(about, has_option(argc, argv, "--json"));
        return false;
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        write_output("-", app.help());
        return false;
    } catch (const CLI::ParseError& error) {
        refuse_usage(app, about, error);
    }
    refuse_empty_values(app);
    require_at_most_one(app, std::vector<std::string>{"--quiet", "--verbose"});
    if (app.count("--completion") > 0)
        write_output("-", completion(app, about, app.get_option("--completion")->as<std::string>()));
    else if (app.count("--man") > 0)
        write_output("-", man_page(app, about));
    else {
        if (common.json == "-" && common.output == "-")
            throw Error(ExitCode::usage, "", "data and --json cannot both go to stdout", "use -o FILE or --json FILE");
        return true;
    }
    return false;
}

std::vector<std::string> take_library_options(int& argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        if (std::string_view{argv[i]} != "--") continue;
        std::vector<std::string> rest(argv + i + 1, argv + argc);
        argc = i;
        return rest;
    }
    return {};
}

std::string stamp(const About& about, const CommonOptions& common) {
    return version_text(about) + ": " + common.command_line;
}

nlohmann::ordered_json summary_head(std::string_view tool) {
    return {{"tool", tool}, {"version", version()}, {"revision", revision()}};
}

std::vector<std::string> library_lines(const About& about) {
    std::vector<std::string> lines;
    for (const Library& library : about.libraries()) lines.push_back(library.name + " " + library.version);
    return lines;
}

std::string command_line_of(const std::vector<std::string>& words) {
    std::vector<std::string> quoted;
    for (const std::string& word : words) quoted.push_back(core::shell_quoted(word));
    return core::join(quoted, " ");
}

ExitCode report_errors(std::string_view tool, std::string_view command_line, const std::function<ExitCode()>& body) {
    try {
        return body();
    } catch (const Error& error) {
        if (error.code() == ExitCode::internal) return report_bug(tool, command_line, error.what());
        print_error(std::string{tool} + ": " + error.what());
        return error.code();
    } catch (const std::bad_alloc&) {
        print_error(std::string{tool} + ": " + core::out_of_memory().what());
        return ExitCode::io_error;
    } catch (const std::exception& error) {
        return report_bug(tool, command_line, error.what());
    } catch (...) {
        return report_bug(tool, command_line, "an exception of unknown type");
    }
}

int guarded(int argc, char** argv, const std::function<ExitCode()>& body) {
    open_missing_streams();
    std::signal(SIGPIPE, SIG_IGN);  // core::write_all handles EPIPE instead
    std::signal(SIGXFSZ, SIG_IGN);  // a file size limit (ulimit -f) is reported as EFBIG instead
    const std::string tool = argc > 0 ? bare_name(argv[0]) : std::string{"soft"};
    return static_cast<int>(report_errors(tool, command_line_of(argc, argv), body));
}

}  // namespace soft::cli
