#pragma once
/// An HTML page that contains everything it needs. Internal; tested by view/report_test and view/sweep_report_test.
#include <string>
#include <string_view>

namespace soft::view {

/// `title` is text; `body` is HTML after the heading, made from escaped text. The policy of the page allows only this script, by its hash,
/// and data within the page; without a script it allows none.
[[nodiscard]] std::string html_page(std::string_view title, std::string_view style, std::string_view body,
                                    std::string_view script);

}  // namespace soft::view
