#pragma once
/// Escaping and encoding of untrusted text and bytes for an HTML page. Internal; tested by view/text_test.
#include <span>
#include <string>
#include <string_view>

namespace soft::view {

/// Escapes text for HTML content and quoted attributes: & < > " ' become references; characters that UTF-8 or HTML forbids (control
/// characters except tab and line feed, malformed bytes) become U+FFFD.
[[nodiscard]] std::string escaped(std::string_view text);

/// JSON for a <script type="application/json">: every < is escaped, so the JSON cannot close the element.
[[nodiscard]] std::string json_in_page(std::string json);

/// Concatenates the pieces.
[[nodiscard]] std::string joined(std::span<const std::string_view> pieces);

/// core/base64 of a text.
[[nodiscard]] std::string base64(std::string_view text);

/// "sha256-...": the hash by which a Content-Security-Policy allows a script.
[[nodiscard]] std::string policy_hash(std::string_view script);

}  // namespace soft::view
