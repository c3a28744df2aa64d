#pragma once
/// Command-line code shared by all tools: error handling and exit codes, common options, stdin and stdout, messages.
///
///   std::optional<SolveOptions> parse(int argc, char** argv) {
///       SolveOptions options;
///       CLI::App app;
///       cli::add_input(app, options.input, "CASE", "Case written by mesh-gen");
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
/// Meaning of an exit code that only some programs return.
struct OwnExitCode {
    ExitCode code;
    std::string_view meaning;
};

/// Description of a tool for --help, --version and --man.
struct About {
    std::string_view tool;                     ///< "mesh-gen"
    std::string_view summary;                  ///< one line
    std::vector<Example> examples;             ///< two
    std::vector<Library> (*libraries)();       ///< names and versions in use at run time
    std::vector<OwnExitCode> exit_codes = {};  ///< in addition to those of all programs
};

enum class Verbosity { quiet, normal, verbose };

struct CommonOptions {
    std::string output = "-";  ///< file, or "-" for stdout
    std::string json;          ///< file for the summary; empty: none; "-": stdout
    Verbosity verbosity = Verbosity::normal;
    std::string command_line;  ///< as typed, without the folder of the program; for the provenance
};

/// -o/--output, --quiet, --verbose, --json, --version, --completion, --man.
void add_common_options(CLI::App& app, CommonOptions& common, const About& about);
/// Adds the positional input; `input` stays empty when it is not given.
void add_input(CLI::App& app, std::string& input, const std::string& name, const std::string& help);
void add_inputs(CLI::App& app, std::vector<std::string>& inputs, const std::string& name, const std::string& help);
/// --set key.path=value, repeatable.
void add_set_option(CLI::App& app, std::vector<std::string>& overrides);

/// Throws Error(usage) if more than one of `options` was given. Call after parse().
void require_at_most_one(const CLI::App& app, std::span<const std::string> options);

/// A file and the option that names it, for check_distinct.
struct NamedFile {
    std::string option, file;  ///< file: "" means none, "-" means stdin or stdout
};
/// Throws Error(usage) if an output (--output, --json or one of `outputs`) would overwrite an input or another output, or if two outputs
/// go to stdout. Call before any work.
void check_distinct(const std::vector<NamedFile>& inputs, const CommonOptions& common,
                    std::vector<NamedFile> outputs = {});

/// True: the options are set. False: help, version, completion or man page was printed and the tool ends. Throws Error(usage);
/// for an unknown option the error suggests the most similar one.
[[nodiscard]] bool parse(CLI::App& app, const About& about, CommonOptions& common, int argc, char** argv);

/// Removes the arguments after the first "--" from argc/argv and returns them; they are options of a library (PETSc).
[[nodiscard]] std::vector<std::string> take_library_options(int& argc, char** argv);

/// Version of this software and git revision of its source ("-dirty" if modified, "unknown" outside a clone).
[[nodiscard]] std::string_view version() noexcept;
[[nodiscard]] std::string_view revision() noexcept;
/// "mesh-gen 0.1.0 (revision): command line", for comments and reports.
[[nodiscard]] std::string stamp(const About& about, const CommonOptions& common);
/// Tool, version and revision, with which every --json summary begins.
[[nodiscard]] nlohmann::ordered_json summary_head(std::string_view tool);
/// "gmsh 4.8.4", one entry per library, for the provenance.
[[nodiscard]] std::vector<std::string> library_lines(const About& about);

/// Calls `body` with SIGPIPE and SIGXFSZ ignored and closed standard streams replaced by /dev/null. An Error prints one line
/// "tool: location: problem; remedy" and returns its exit code; std::bad_alloc returns 74; any other exception returns 70 and asks
/// the user to report it.
[[nodiscard]] int guarded(int argc, char** argv, const std::function<ExitCode()>& body);

/// The error handling of guarded(), for a tool that runs several jobs. `command_line` appears in the request to report a bug.
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
    // After running out of memory some libraries crash in their exit handlers.
    if (code == static_cast<int>(ExitCode::io_error)) std::_Exit(code);
    return code;
}

struct Input {
    core::Bytes bytes;
    std::string source;  ///< "designs/tube.yaml" or "<stdin>", for errors
    [[nodiscard]] std::string_view text() const { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }
};

/// Reads the file `name`, or all of stdin if `name` is "-" or empty. Throws Error(usage) if `name` is empty and stdin is a terminal.
/// `limit` and `signature` are those of core::read_descriptor.
[[nodiscard]] Input read_input(const std::string& name, std::size_t limit = core::no_limit,
                               std::string_view signature = {});
/// Reads an HDF5 file; reading stops early if the signature does not match.
[[nodiscard]] inline Input read_hdf5_input(const std::string& name) {
    return read_input(name, core::no_limit, "\x89HDF\r\n\x1a\n");
}

/// Input limits in bytes. The design reader accepts one byte less and reports the excess itself.
inline constexpr std::size_t max_table_bytes = std::size_t{1} << 26, max_design_bytes = (std::size_t{1} << 20) + 1;

/// Reads a design or a sweep. A relative name that does not exist, such as designs/bellows.yaml, is also looked up in
/// ../share/soft-actuator of the program's folder, where the installation keeps the examples; `source` is then that path.
[[nodiscard]] Input read_design(const std::string& name);

enum class Content { text, binary };

/// Throws Error(usage) if binary data would be written to a terminal, Error(cannot_create) if a file cannot be created. Call before
/// computing the data.
void check_output(const std::string& name, Content content);

/// Whether stdout is a regular file. Data written to it only at the end are lost if the process is interrupted.
[[nodiscard]] bool stdout_is_file();

/// Writes the file atomically, or to stdout for "-". A reader that closes the pipe early is not an error.
void write_output(const std::string& name, std::span<const std::byte> bytes, Content content);
void write_output(const std::string& name, std::string_view text);
/// Creates the folder and its parents if they do not exist. Throws Error(cannot_create) with the reason.
void make_folder(const std::string& name);
/// Writes indented JSON with a final newline.
void write_json(const std::string& name, const nlohmann::ordered_json& json);

/// Redirects stdout to stderr during its lifetime, for libraries that print to stdout (MUMPS, from Fortran): stdout carries data only.
class StdoutRedirection {
public:
    StdoutRedirection();
    ~StdoutRedirection();
    StdoutRedirection(const StdoutRedirection&) = delete;
    StdoutRedirection& operator=(const StdoutRedirection&) = delete;

private:
    int saved_;
};

/// Prints messages and progress to stderr. Colour and the progress bar only on a terminal; no colour if NO_COLOR is set.
class Console {
public:
    Console(std::string_view tool, Verbosity verbosity);
    Console(const About& about, const CommonOptions& common) : Console(about.tool, common.verbosity) {}
    ~Console();
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;

    void say(std::string_view line);          ///< unless --quiet
    void detail(std::string_view line);       ///< with --verbose
    void warn(std::string_view line);         ///< "tool: warning: line", unless --quiet
    void warn_always(std::string_view line);  ///< like warn, also with --quiet: for results that may be wrong
    void error(std::string_view line);        ///< "tool: line", also with --quiet
    /// Redraws a progress bar on a terminal; otherwise prints one line per 10 %. `share` is from 0 to 1.
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
