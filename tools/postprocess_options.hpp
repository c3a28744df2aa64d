#pragma once
/// What the user asks of postprocess. Tested by tests/pipeline (postprocess_checks.sh, plots.sh, reports.sh).
#include <optional>
#include <string>
#include <vector>

#include "cli.hpp"
#include "postprocess_pictures.hpp"

namespace soft {

struct PlotOptions {
    std::string file;               ///< FILE.svg, .png, .pdf; empty: none
    std::string x, y;               ///< quantities; empty: what fits the case
    std::string colour;             ///< quantity; empty: none
    std::vector<std::string> with;  ///< FILE or FILE:LABEL of further results
    std::string band;               ///< table of scripts/uncertainty (CSV); empty: none
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
    std::string junit;              ///< verdict as XML
};

struct PostprocessOptions {
    cli::CommonOptions common;
    std::string input;
    std::vector<std::string> at;
    bool comments = false;
    bool lists_outputs = false;     ///< the columns of RESULT, or of any where none is named
    std::vector<std::string> also;  ///< columns on demand
    bool wants_table = true;        ///< false: another product was asked for, and no -o
    PlotOptions plot;
    CompareOptions compare;
    CheckOptions check;
    PictureOptions pictures;
    std::string report;  ///< FILE.html; empty: none
};

[[nodiscard]] const cli::About& postprocess_about();

/// nullopt: help, version or the like was printed. Throws Error(usage).
[[nodiscard]] std::optional<PostprocessOptions> parse_postprocess_options(int argc, char** argv);

}  // namespace soft
