#pragma once
/// Markdown tables of the reference pages. Private to the module. Tested by design/key_list_test.
#include <string>
#include <string_view>
#include <vector>

namespace soft::design {

/// "`text`"
[[nodiscard]] std::string code(std::string_view text);
/// "| a | b |" and a line break; bars within a cell are escaped.
[[nodiscard]] std::string table_row(const std::vector<std::string>& cells);
/// The row of column titles and the line below it.
[[nodiscard]] std::string table_head(const std::vector<std::string>& titles);

}  // namespace soft::design
