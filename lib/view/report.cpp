#include "view/report.hpp"

#include "core/error.hpp"
#include "view/page.hpp"
#include "view/scene.hpp"
#include "view/sections.hpp"
#include "view/text.hpp"
#include "view/viewer_bundle.hpp"

namespace soft::view {
namespace {

constexpr std::string_view style = R"(
:root { color-scheme: light; }
body { font: 16px/1.45 system-ui, sans-serif; color: #1a1a1a; background: #fff; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.7rem; } h2 { font-size: 1.25rem; margin-top: 2.2rem; border-bottom: 1px solid #ccc; }
img { max-width: 100%; } canvas { width: 100%; height: 32rem; border: 1px solid #ccc; display: block; touch-action: none; }
table { border-collapse: collapse; } th, td { padding: .2rem .7rem .2rem 0; text-align: left; vertical-align: top; font-variant-numeric: tabular-nums; }
thead th { border-bottom: 1px solid #999; } tbody tr { border-bottom: 1px solid #eee; } tr.shown { background: #e6f0fa; }
.scroll { overflow-x: auto; } pre { background: #f6f6f6; padding: .8rem; overflow-x: auto; white-space: pre-wrap; }
.controls { display: flex; flex-wrap: wrap; gap: .8rem; align-items: center; margin: .6rem 0; }
.controls .wide { flex: 1 1 20rem; display: flex; gap: .6rem; } .controls .wide input { flex: 1; }
.colourbar { display: flex; gap: .6rem; align-items: center; } #colours { flex: 1; height: 1.1rem; border: 1px solid #999; }
#viewer-error { color: #a00000; } [hidden] { display: none !important; }
)";

}  // namespace

void require_viewer() {
    const ViewerBundle bundle = viewer_bundle();
    if (!bundle.missing.empty())
        throw Error(ExitCode::cannot_create, "--report",
                    "this program was built without the viewer of the actuator: " + std::string{bundle.missing},
                    "install Node.js with npm, then configure and build in a new build directory");
}

std::string make_report(const Content& content, std::size_t body_bytes) {
    require_viewer();
    const Scene scene = make_scene(content.result, content.curve, body_bytes);
    const std::string script = scene.json.empty() ? "" : joined(viewer_bundle().script);
    const std::string body = summary_section(content) + curve_section(content) + body_section(scene) +
                             comparison_section(content) + mesh_section(content) + material_section(content) +
                             table_section(content) + design_section(content) + provenance_section(content) +
                             licence_section();
    return html_page(content.result.model.name, style, body, script);
}

}  // namespace soft::view
