#pragma once
/// The sections of the page, each a complete HTML fragment. Internal; tested by view/report_test.
#include <span>
#include <string>

#include "view/report.hpp"
#include "view/scene.hpp"

namespace soft::view {

[[nodiscard]] std::string summary_section(const Content& content);
[[nodiscard]] std::string curve_section(const Content& content);
[[nodiscard]] std::string body_section(const Scene& scene);
[[nodiscard]] std::string comparison_section(const Content& content);  ///< empty without measured data
[[nodiscard]] std::string mesh_section(const Content& content);
[[nodiscard]] std::string material_section(const Content& content);
[[nodiscard]] std::string table_section(const Content& content);
[[nodiscard]] std::string design_section(const Content& content);
[[nodiscard]] std::string provenance_section(const Content& content);
[[nodiscard]] std::string licence_section();

/// A <table> with escaped cells. Rows may have attributes: "data-step='3'".
struct Row {
    std::vector<std::string> cells;
    std::string attributes = {};
};
[[nodiscard]] std::string html_table(std::span<const std::string> head, std::span<const Row> rows,
                                     std::string_view id = {});

}  // namespace soft::view
