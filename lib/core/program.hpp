#pragma once
/// Runs another program without a shell: arguments and text in, bytes out. Tested by core/program_test.
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/files.hpp"

namespace soft::core {

struct CloseFile {
    void operator()(std::FILE* stream) const noexcept { std::fclose(stream); }
};
using Stream = std::unique_ptr<std::FILE, CloseFile>;

/// An unnamed file that is deleted when closed. Throws Error(cannot_create, `location`).
[[nodiscard]] Stream temporary_file(std::string_view location);

struct ProgramCall {
    std::string name;                        ///< searched along PATH
    std::span<const std::string> arguments;  ///< without the name
    std::string_view input;                  ///< standard input
    int output = -1;                         ///< descriptor for the standard output; -1: discarded
    std::string purpose;                     ///< "draws the picture", for the message if the program is not installed
    std::string remedy;                      ///< "install the package ..."
    /// Environment variables whose names start with one of these prefixes are not passed on.
    std::span<const std::string_view> dropped_variables = {};
};

struct ProgramStatus {
    bool succeeded = false;    ///< it exited with code 0
    std::string error_output;  ///< the first 4 KiB of its standard error
};

/// Runs the program and waits until it exits. Throws Error(cannot_create, `location`) if it is not installed or cannot be started,
/// Error(io_error) if its input cannot be written.
[[nodiscard]] ProgramStatus run_program(const ProgramCall& call, std::string_view location);

struct ProgramOutput {
    ProgramStatus status;
    Bytes bytes;  ///< its standard output
};

/// Runs the program and returns its standard output in memory (`call.output` is ignored). Output through a pipe cannot fail for
/// lack of disk space, which some programs would not report by their exit code.
[[nodiscard]] ProgramOutput capture_program_output(const ProgramCall& call, std::string_view location);

}  // namespace soft::core
