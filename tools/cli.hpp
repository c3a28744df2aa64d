#pragma once
/// The frame every tool stands in: errors to exit codes, the common options, stdin and stdout, messages.
///
///   std::optional<SolveOptions> parse(int argc, char** argv) {
///       SolveOptions options;
///       CLI::App app;
///       cli::add_input(app, options.input, "CASE", "case written by mesh-gen");
///       app.add_option("--fields", ...);
///       cli::add_common_options(app, options.common, about);
///       return cli::parse(app, about, options.common, argc, argv) ? std::optional{options} : std::nullopt;
///   }
///   int main(int argc, char** argv) { return cli::run_guarded(argc, argv, parse, solve); }
///
/// stdout carries data only; messages go to stderr. Tested by tests/cli.
#include <cstdlib>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/files.hpp"

namespace CLI {
class App;
}

namespace soft::cli {

struct Library {
    std::string name, version;
};
struct Example {
    std::string_view command, meaning;
};

/// What a tool says of itself in --help, --version, --man.
struct About {
    std::string_view tool;                ///< "mesh-gen"
    std::string_view summary;             ///< one line
    std::vector<Example> examples;        ///< two
    std::vector<Library> (*libraries)();  ///< with the versions it runs with
};

enum class Verbosity { quiet, normal, verbose };

struct CommonOptions {
    std::string output = "-";  ///< file, or "-" for stdout
    std::string json;          ///< summary goes here; empty: nowhere; "-": stdout
    Verbosity verbosity = Verbosity::normal;
    std::string command_line;  ///< as typed, program by its bare name: for provenance
};

/// -o/--output, --quiet, --verbose, --json, --version, --completion, --man.
void add_common_options(CLI::App& app, CommonOptions& common, const About& about);
/// The positional input; left empty when it is not given.
void add_input(CLI::App& app, std::string& input, const std::string& name, const std::string& help);
void add_inputs(CLI::App& app, std::vector<std::string>& inputs, const std::string& name, const std::string& help);
/// --set key.path=value, repeatable.
void add_set_option(CLI::App& app, std::vector<std::string>& overrides);

/// Error(usage) if more than one of them was given; after parse().
void at_most_one_of(const CLI::App& app, std::span<const std::string> options);

/// A file of an option, for check_distinct.
struct NamedFile {
    std::string option, file;  ///< file: "" and "-" as in the options
};
/// Error(usage) where an output would overwrite an input or another output, and where two go to stdout. Before any work.
void check_distinct(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs);

/// True: the options are filled, go on. False: help, version, completion or man page was printed. Throws Error(usage)
/// with the nearest option for an unknown one.
[[nodiscard]] bool parse(CLI::App& app, const About& about, CommonOptions& common, int argc, char** argv);

/// What stands behind the first "--", taken off argc/argv: options for a library.
[[nodiscard]] std::vector<std::string> take_rest(int& argc, char** argv);

/// Own version and the git revision of the source ("-dirty" if changed, "unknown" outside a clone).
[[nodiscard]] std::string_view version() noexcept;
[[nodiscard]] std::string_view revision() noexcept;
/// "gmsh 4.8.4", one a library: for provenance.
[[nodiscard]] std::vector<std::string> library_lines(const About& about);

/// Calls `body`; SIGPIPE and SIGXFSZ are ignored and closed standard streams cannot be taken by files. An Error becomes one line
/// "tool: place: problem; remedy" and its exit code, std::bad_alloc is 74, anything else 70 with a request to report it.
[[nodiscard]] int guarded(int argc, char** argv, const std::function<ExitCode()>& body);

/// The part of it that tells errors; for one piece of work of several. `command_line` stands in requests to report.
[[nodiscard]] ExitCode report_errors(std::string_view tool, std::string_view command_line,
                                      const std::function<ExitCode()>& body);

/// "mesh-gen 'my tube.yaml' -o t.h5": quoted so that it can be pasted into a shell.
[[nodiscard]] std::string command_line_of(const std::vector<std::string>& words);

/// parse: (int, char**) -> std::optional<Options>, run: (const Options&) -> ExitCode.
template <class Parse, class Run>
[[nodiscard]] int run_guarded(int argc, char** argv, Parse parse_options, Run run) {
    const int code = guarded(argc, argv, [&] {
        const auto options = parse_options(argc, argv);
        return options ? run(*options) : ExitCode::ok;
    });
    // Libraries that ran out of memory half way crash in what they do at exit.
    if (code == static_cast<int>(ExitCode::io_error)) std::_Exit(code);
    return code;
}

struct Input {
    core::Bytes bytes;
    std::string source;  ///< "designs/tube.yaml" or "<stdin>", for errors
    [[nodiscard]] std::string_view text() const { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }
};

/// The file, or all of stdin for "-" and for nothing; Error(usage) for nothing when stdin is a terminal.
/// Limit and signature as in core::read_descriptor.
[[nodiscard]] Input read_input(const std::string& name, std::size_t limit = core::no_limit,
                               std::string_view signature = {});
/// A file of HDF5; what is none is cut short.
[[nodiscard]] inline Input read_hdf5_input(const std::string& name) {
    return read_input(name, core::no_limit, "\x89HDF\r\n\x1a\n");
}

/// Bytes: a table is text that somebody has looked at. The reader of designs takes one less and says so.
inline constexpr std::size_t longest_table = std::size_t{1} << 26, longest_design = (std::size_t{1} << 20) + 1;

enum class Content { text, binary };

/// Error(usage) if binary data would reach a terminal: call it before the work that makes the data.
void check_output(const std::string& name, Content content);

/// Whether stdout is a regular file: what is written to it at the end is lost when the process is ended before.
[[nodiscard]] bool stdout_is_file();

/// To the file, whole or not at all, or to stdout for "-". A reader that closed early is not an error.
void write_output(const std::string& name, std::span<const std::byte> bytes, Content content);
void write_output(const std::string& name, std::string_view text);
/// Also the folders it is in; nothing where it is there. Error(cannot_create) with the reason.
void make_folder(const std::string& name);
/// Indented JSON with a final newline.
void write_json(const std::string& name, const nlohmann::ordered_json& json);

/// While it lives, whatever a library prints to stdout (MUMPS does, from Fortran) goes to stderr: stdout carries data only.
class StdoutKeptForData {
public:
    StdoutKeptForData();
    ~StdoutKeptForData();
    StdoutKeptForData(const StdoutKeptForData&) = delete;
    StdoutKeptForData& operator=(const StdoutKeptForData&) = delete;

private:
    int saved_;
};

/// Messages and progress on stderr. Colour and the moving bar only on a terminal, and no colour under NO_COLOR.
class Console {
public:
    Console(std::string_view tool, Verbosity verbosity);
    ~Console();
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;

    void say(std::string_view line);     ///< unless --quiet
    void detail(std::string_view line);  ///< with --verbose
    void warn(std::string_view line);    ///< "tool: warning: line", unless --quiet
    void insist(std::string_view line);  ///< the same with --quiet too: the numbers may be wrong
    void error(std::string_view line);   ///< "tool: line", with --quiet too
    /// A bar that is redrawn on a terminal; elsewhere a plain line each tenth of the way. `share` from 0 to 1.
    void progress(double share, std::string_view text);

private:
    void put(std::string_view label, std::string_view line);
    void clear_bar();
    [[nodiscard]] std::string_view warning_label() const;

    std::string tool_;
    Verbosity verbosity_;
    bool terminal_;
    bool colour_;
    bool bar_shown_ = false;
    int tenths_ = -1;
};

}  // namespace soft::cli
