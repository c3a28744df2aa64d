// Cook's membrane and a compressed block in plane strain: bending and confined compression on coarse and fine meshes.
#include <optional>

#include "core/text.hpp"
#include "problem.hpp"
#include "table.hpp"

namespace soft::verification {
namespace {

constexpr const char* group = "Plane strain: bending and confinement";

struct Element {
    const char* name;
    std::vector<std::string> sets;
};

std::vector<std::string> with(std::vector<std::string> sets, const std::vector<std::string>& more) {
    sets.insert(sets.end(), more.begin(), more.end());
    return sets;
}

/// Vertical displacement [mm] of the node at a position.
double rise_mm(const Run& run, double x_m, double y_m) {
    return 1e3 * run.displacement_m[3 * nearest_node(run, {x_m, y_m, 0}) + 1];
}

std::vector<std::string> cook_mesh(int cells) {
    return {"mesh.size=" + core::number_text(48.0 / cells) + " mm", "mesh.through_wall=" + std::to_string(cells)};
}

/// A value on which several public codes agree.
struct Published {
    double rise_mm;
    const char* source;
};

/// Table of the displacement of the middle of the loaded face by mesh and element. If there is a published value, the first two elements
/// on the finest mesh give rows.
Problem cook_study(const std::string& name, const std::string& text, const std::vector<std::string>& material,
                   const std::vector<Element>& elements, std::optional<Published> published) {
    return {group, name, [=] {
                constexpr int finest = 32;
                Outcome outcome;
                Table table{name + ": mesh study", text, {"cells a side"}, {}};
                for (const auto& element : elements) table.header.push_back(std::string(element.name) + " [mm]");
                for (const int cells : {4, 8, 16, finest}) {
                    table.lines.push_back({std::to_string(cells)});
                    for (const auto& element : elements) {
                        const auto run =
                            run_design("verification/cook.yaml", with(with(cook_mesh(cells), material), element.sets));
                        table.lines.back().push_back(run.end.reason == model::StopReason::done
                                                         ? printed_number(rise_mm(run, 48e-3, 52e-3))
                                                         : "fails");
                        if (!published || cells != finest || outcome.rows.size() == 2) continue;
                        outcome.rows.push_back({.quantity = "rise of the middle of the loaded face, " +
                                                            std::string(element.name) + " [mm]",
                                                .reference = published->rise_mm,
                                                .source = published->source,
                                                .ours = rise_mm(run, 48e-3, 52e-3),
                                                .mesh = run.mesh,
                                                .seconds = run.seconds});
                    }
                }
                outcome.tables.push_back(table);
                return outcome;
            }};
}

const std::vector<Element>& elements() {
    static const std::vector<Element> all{
        {"quad9 mixed", {"mesh.formulation=mixed"}},
        {"quad9 displacement", {"mesh.formulation=displacement"}},
        {"quad4 f-bar", {"mesh.formulation=f-bar", "mesh.order=1"}},
        {"quad4 displacement", {"mesh.formulation=displacement", "mesh.order=1"}},
        {"triangle6 mixed", {"mesh.formulation=mixed", "mesh.cells=simplices"}},
        {"triangle6 displacement", {"mesh.formulation=displacement", "mesh.cells=simplices"}},
        {"triangle3 displacement", {"mesh.formulation=displacement", "mesh.order=1", "mesh.cells=simplices"}}};
    return all;
}

Problem block() {
    return {
        group, "compressed block, incompressible", [] {
            constexpr const char* title = "compressed block, incompressible: mesh study";
            Table table{
                title,
                "Mean depression [mm] of the loaded strip at 300 kPa (dead), own mesh study; the ends of the strip are\n"
                "singular. Triangles and quadrilaterals approach one value from both meshes without locking.",
                {"cells a side", "quad9 mixed [mm]", "triangle6 mixed [mm]"},
                {}};
            for (const int cells : {4, 8, 16, 32}) {
                table.lines.push_back({std::to_string(cells)});
                for (const char* shape : {"auto", "simplices"}) {
                    const auto run =
                        run_design("verification/block.yaml",
                                   {"mesh.size=" + core::number_text(10.0 / cells) + " mm",
                                    "mesh.through_wall=" + std::to_string(cells), std::string("mesh.cells=") + shape});
                    table.lines.back().push_back(
                        run.end.reason == model::StopReason::done ? printed_number(-run.output_mm()) : "fails");
                }
            }
            return Outcome{{}, {table}};
        }};
}

}  // namespace

std::vector<Problem> panel_problems() {
    return {
        cook_study("Cook's membrane, compressible", "Rise of the middle of the loaded face, nu = 0.3.", {}, elements(),
                   Published{14.735, "public results: deal.II Q2 14.74, Abaqus 14.727"}),
        cook_study(
            "Cook's membrane, nearly incompressible",
            "Rise of the middle of the loaded face at kappa/mu = 5000 (nu = 0.4999): locking elements stay too low until the mesh is fine.",
            {"material.kappa=2112.5 MPa"}, elements(), std::nullopt),
        cook_study("Cook's membrane, incompressible",
                   "Rise of the middle of the loaded face at full incompressibility.",
                   {"material.kappa=incompressible"}, {elements()[0], elements()[4]}, std::nullopt),
        block()};
}

}  // namespace soft::verification
