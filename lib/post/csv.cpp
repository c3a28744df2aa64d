#include "post/csv.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include "core/text.hpp"

namespace soft::post {
namespace {

std::string comment_lines(std::string_view comment) {
    std::string text;
    for (std::size_t begin = 0; begin <= comment.size();) {
        const std::size_t end = std::min(comment.find('\n', begin), comment.size());
        text += "# " + core::one_line(comment.substr(begin, end - begin), std::string_view::npos) + '\n';
        begin = end + 1;
    }
    return text;
}

}  // namespace

std::string csv_text(const Curve& curve, std::span<const std::string> comments) {
    std::string text, header;
    for (const std::string& comment : comments) text += comment_lines(comment);
    const std::vector<const Column*> shown = shown_columns(curve);
    for (const Column* column : shown) header.append(header.empty() ? "" : ",").append(column->name);
    text += header + '\n';
    for (std::size_t row = 0; row < curve.row_count(); ++row) {
        for (std::size_t i = 0; i < shown.size(); ++i)
            text.append(i == 0 ? "" : ",").append(core::number_text(shown[i]->values[row] + 0.0));  // -0 becomes 0
        text += '\n';
    }
    return text;
}

}  // namespace soft::post
