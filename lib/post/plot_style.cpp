#include "post/plot_style.hpp"

namespace soft::post {
namespace {

constexpr int panel_width = 800, panel_height = 560;  // of SVG and PNG

std::string size_text(int factor, int panels) {
    // Each of several panels is narrower than a single one.
    const int width = panels == 1 ? panel_width : panel_width * 3 / 4 * panels;
    return std::to_string(factor * width) + "," + std::to_string(factor * panel_height);
}

}  // namespace

std::string terminal(PictureFormat format, int panels) {
    switch (format) {
        case PictureFormat::svg:
            return "set terminal svg size " + size_text(1, panels) + " font 'Helvetica,15' background rgb 'white'\n";
        case PictureFormat::pdf: {
            const std::string size = panels == 1 ? "16cm,11.2cm" : std::to_string(panels * 12) + "cm,11.2cm";
            return "set terminal pdfcairo size " + size + " font 'Helvetica,11' linewidth 1.2\n";
        }
        case PictureFormat::png: break;
    }
    const std::string size = size_text(2, panels);
    return "if (strstrt(GPVAL_TERMINALS, 'pngcairo')) set terminal pngcairo size " + size +
           " font 'Sans,26' linewidth 2; else set terminal png size " + size + " font 'Sans,26' linewidth 2\n";
}

std::string axes_style() {
    return "set grid linecolor rgb '#b0b0b0' linewidth 0.5\nset border 3 linewidth 1\nset tics nomirror out\n";
}

}  // namespace soft::post
