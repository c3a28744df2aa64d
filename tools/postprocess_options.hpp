#pragma once
/// Command line of postprocess. Tested by tests/pipeline (postprocess_checks.sh, plots.sh, reports.sh).
#include <optional>
#include <string>
#include <vector>

#include "cli.hpp"
#include "postprocess_pictures.hpp"

namespace soft {

struct PlotOptions {
    std::string file;               ///< FILE.svg, .png, .pdf; empty: none
    std::string x, y;               ///< quantities; empty: chosen for the case
    std::string colour;             ///< quantity; empty: none
    std::vector<std::string> with;  ///< FILE or FILE:LABEL of other results
};

struct CompareOptions {
    std::string file;       ///< measured data (CSV); empty: none
    std::string columns;    ///< "pressure=2,elongation=1"
    std::string max_error;  ///< "5kPa"
};

struct CheckOptions {
    std::string file;               ///< golden table (CSV); empty: none
    std::string rtol = "1e-3";      ///< a ratio
    std::vector<std::string> atol;  ///< "pressure=5Pa"
    std::string junit;              ///< file for the outcome as JUnit XML
};

struct PostprocessOptions {
    cli::CommonOptions common;
    std::string input;
    std::vector<std::string> at;
    bool comments = false;
    bool lists_outputs = false;           ///< list the columns of RESULT, or all possible columns without RESULT
    std::vector<std::string> also;        ///< additional columns
    int cycle = 0;                        ///< only this cycle of a repeated programme; 0: all
    bool sensitivity = false;             ///< the table is that of the sensitivities
    std::vector<std::string> tolerances;  ///< KEY=VALUE
    std::string errors;                   ///< --json file of fit-material or optimize; empty: none
    bool wants_table = true;              ///< false: another output was requested, without -o
    PlotOptions plot;
    CompareOptions compare;
    CheckOptions check;
    PictureOptions pictures;
    std::string report;  ///< FILE.html; empty: none
};

[[nodiscard]] const cli::About& postprocess_about();

/// nullopt if help, version or the like was printed. Throws Error(usage).
[[nodiscard]] std::optional<PostprocessOptions> parse_postprocess_options(int argc, char** argv);

}  // namespace soft
