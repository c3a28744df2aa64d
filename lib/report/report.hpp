#pragma once
/// `postprocess --report`: everything about a result as one HTML page that needs nothing else. In it: the curve (SVG), the body
/// that the reader turns and moves through its steps (three.js), the table of results, the error of the mesh, the comparison
/// with measured data where there are any, the materials with their range, the design, provenance and licences.
/// No reader of the page fetches anything, and no text of the design can act in it: all of it is escaped, and the page's
/// Content-Security-Policy lets only the one script run whose SHA-256 it names and nothing be loaded but data within the page.
/// The same result gives the same bytes. Tested by report/report_test and tests/report/browser (headless Chromium).
#include <span>
#include <string>
#include <vector>

#include "io/result_file.hpp"
#include "post/compare.hpp"
#include "post/curve.hpp"
#include "post/plot.hpp"

namespace soft::report {

struct Content {
    const io::Result& result;
    const post::Curve& curve;
    std::span<const post::PlotSeries> series;  ///< of the plot; the first is that of `curve`
    const post::Measured* measured = nullptr;
    std::span<const post::ErrorSummary> errors = {};  ///< of `curve` against `measured`
    post::PlotRequest plot = {};
    std::string made_by = {};                      ///< program, version, command line
    std::vector<std::string> material_notes = {};  ///< what is known of the data behind the constants, a sentence each
};

/// Largest size of the moving body in the page [bytes], before base64 adds a third; see report/scene.hpp.
inline constexpr std::size_t usual_body_bytes = 24u << 20;

/// Throws Error(cannot_create, place `--report`) where the program was built without the viewer: call it before any work.
void require_viewer();

/// The page. Errors: as require_viewer, post::plot_script, post::gnuplot_output and io::FieldReader::read.
[[nodiscard]] std::string make_report(const Content& content, std::size_t body_bytes = usual_body_bytes);

}  // namespace soft::report
