#pragma once
/// `postprocess --report`: a result as one self-contained HTML page. It contains the curve (SVG), an interactive 3D view of the body in
/// all steps (three.js), the table of results, the discretization error, the comparison with measured data if there are any, the
/// materials with their range of validity, the design, provenance and licences.
/// The page fetches nothing, and no text of the design is executed: all text is escaped, and the Content-Security-Policy of the page
/// allows only the script with the given SHA-256 and only data within the page.
/// The same result gives the same bytes. Tested by view/report_test and tests/view/browser (headless Chromium).
#include <span>
#include <string>
#include <vector>

#include "io/result_file.hpp"
#include "post/compare.hpp"
#include "post/curve.hpp"
#include "post/plot.hpp"

namespace soft::view {

struct Content {
    const io::Result& result;
    const post::Curve& curve;
    std::span<const post::PlotSeries> series;  ///< series of the plot; the first is that of `curve`
    const post::Measured* measured = nullptr;
    std::span<const post::ErrorSummary> errors = {};  ///< of `curve` against `measured`
    post::PlotRequest plot = {};
    std::string made_by = {};                      ///< program, version, command line
    std::vector<std::string> material_notes = {};  ///< about the test data behind the constants, one sentence each
};

/// Default limit for the data of the 3D view [bytes], before base64 adds a third; see view/scene.hpp.
inline constexpr std::size_t default_body_bytes = 24u << 20;

/// Throws Error(cannot_create, location `--report`) if the program was built without the viewer; call it before any work.
void require_viewer();

/// Returns the page. Errors: as require_viewer, post::plot_script, post::gnuplot_output and io::FieldReader::read.
[[nodiscard]] std::string make_report(const Content& content, std::size_t body_bytes = default_body_bytes);

}  // namespace soft::view
