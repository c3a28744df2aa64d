#include "view/colour_bar.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/text.hpp"
#include "post/gnuplot.hpp"

namespace soft::view {

namespace {

// Fractions of the picture width: the bar, its numbers from `numbers` to at most `numbers_end`, the label.
constexpr double bar_left = 0.825, bar_width = 0.022, numbers = 0.87, numbers_end = 0.957, max_label_middle = 0.98;
constexpr double bar_low = 0.2, bar_height = 0.6, label_height = 0.92;
/// Average width of a letter of Sans over the font size in points, and of a digit (pixels at 96 per inch).
constexpr double letter = 0.78, digit = 0.86;

std::string number(double value) { return core::rounded_text(value, 8); }

std::string with_decimals(double value, int decimals, std::chars_format format) {
    std::array<char, 400> buffer{};  // the longest double has 309 digits before the point
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, decimals).ptr;
    return {buffer.data(), end};
}

}  // namespace

double round_step(double max_step) {
    const double decade = std::pow(10.0, std::floor(std::log10(max_step)));
    for (const double step : {5.0, 2.0})
        if (step * decade <= max_step) return step * decade;
    return decade;
}

std::vector<Tick> bar_ticks(double low, double high) {
    const double step = round_step((high - low) / 4 * (1 + 1e-9));  // 1e-9: (0.4 - 0) / 4 must give 0.1
    const double first = std::ceil(low / step - 1e-6), last = std::floor(high / step + 1e-6);
    const int step_decade = static_cast<int>(std::floor(std::log10(step) + 1e-9));
    const double largest = std::max(std::abs(first), std::abs(last)) * step;
    const int decade = static_cast<int>(std::floor(std::log10(largest) + 1e-9));
    // Fixed notation up to 123456 and down to 0.0001; beyond that the exponent is shorter.
    const bool plain = decade <= 5 && step_decade >= -4;
    std::vector<Tick> ticks;
    for (double i = 0; i <= last - first; i += 1) {  // far from zero first + 1 may equal first
        const double k = first + i, value = k * step;
        const std::string text = plain ? with_decimals(value, std::max(0, -step_decade), std::chars_format::fixed)
                                       : with_decimals(value, decade - step_decade, std::chars_format::scientific);
        ticks.push_back({value, k == 0 ? "0" : text});
    }
    return ticks;
}

std::string colour_bar_script(const ColourBar& bar) {
    std::string ticks;
    std::size_t longest = 1;
    for (const Tick& tick : bar_ticks(bar.low, bar.high)) {
        ticks += (ticks.empty() ? "" : ", ") + post::gnuplot_text(tick.text) + " " + core::number_text(tick.value);
        longest = std::max(longest, tick.text.size());
    }
    const double available_px = (numbers_end - numbers) * bar.width_px;
    const double number_font = std::min(bar.font, available_px / (digit * static_cast<double>(longest)));
    const double numbers_px = digit * number_font * static_cast<double>(longest);
    const double label_middle = std::min(max_label_middle, numbers + (numbers_px + bar.font) / bar.width_px);
    const double letters = static_cast<double>(std::max<std::size_t>(bar.label.size(), 1));
    const double label_font = std::min(bar.font, label_height * bar.height_px / (letter * letters));
    std::string script = "set cbrange [" + core::number_text(bar.low) + ":" + core::number_text(bar.high) + "]\n";
    script += "set colorbox user origin screen " + number(bar_left) + ", screen " + number(bar_low) + " size screen " +
              number(bar_width) + ", screen " + number(bar_height) + "\n";
    script += "set cbtics (" + ticks + ") scale 0.5 font 'Sans," + number(number_font) + "'\n";
    script += "set label 3 " + post::gnuplot_text(bar.label) + " noenhanced at screen " + number(label_middle) +
              ", screen 0.5 center rotate by 90 font 'Sans," + number(label_font) + "' front\n";
    return script;
}

}  // namespace soft::view
