#pragma once
/// Another program as a function: arguments and text in, bytes out. No shell in between. Tested by core/program_test.
#include <span>
#include <string>
#include <string_view>

#include "core/files.hpp"

namespace soft::core {

struct ProgramCall {
    std::string name;                        ///< found along PATH
    std::span<const std::string> arguments;  ///< without the name
    std::string_view input;                  ///< its standard input
    int output = -1;                         ///< descriptor that takes its standard output; -1: dropped
    std::string purpose;                     ///< "draws the picture", for the message that it is not installed
    std::string remedy;                      ///< "install the package ..."
    /// Environment variables whose names begin so are not passed on.
    std::span<const std::string_view> dropped_variables = {};
};

struct ProgramEnd {
    bool well = false;      ///< it ended by itself with exit code 0
    std::string complaint;  ///< the first 4 KiB that it wrote to standard error
};

/// Waits for its end. Throws Error(cannot_create, `place`) where it is not installed or cannot be started,
/// Error(io_error) where the input cannot be handed over.
[[nodiscard]] ProgramEnd run_program(const ProgramCall& call, std::string_view place);

struct ProgramOutput {
    ProgramEnd end;
    Bytes bytes;  ///< all that it wrote to standard output
};

/// The same with its output in memory (`call.output` is not used). Programs may well end with exit code 0 after a write
/// that failed; into a pipe that is read to its end no write fails, whatever room disks have.
[[nodiscard]] ProgramOutput program_output(const ProgramCall& call, std::string_view place);

}  // namespace soft::core
