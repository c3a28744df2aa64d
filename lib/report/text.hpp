#pragma once
/// Foreign text and bytes made fit for a page. Internal; held by report/text_test.
#include <span>
#include <string>
#include <string_view>

namespace soft::report {

/// For the text and the quoted attributes of HTML: & < > " ' are written as references; what UTF-8 or HTML forbids (control
/// characters but tab and line feed, malformed bytes) becomes U+FFFD.
[[nodiscard]] std::string escaped(std::string_view text);

/// JSON for a <script type="application/json">: no < is left in it, so it cannot end its element.
[[nodiscard]] std::string json_in_page(std::string json);

/// One after the other.
[[nodiscard]] std::string joined(std::span<const std::string_view> pieces);

/// core/base64 of a text.
[[nodiscard]] std::string base64(std::string_view text);

/// "sha256-...": how a Content-Security-Policy names a script that may run.
[[nodiscard]] std::string policy_hash(std::string_view script);

}  // namespace soft::report
