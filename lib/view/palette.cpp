#include "view/palette.hpp"

#include <algorithm>
#include <array>

namespace soft::view {

namespace {

constexpr std::array<Rgb, 33> table{{
    {0.2670, 0.0049, 0.3294}, {0.2770, 0.0502, 0.3755}, {0.2823, 0.0946, 0.4170}, {0.2829, 0.1354, 0.4530},
    {0.2789, 0.1749, 0.4830}, {0.2708, 0.2133, 0.5066}, {0.2593, 0.2507, 0.5244}, {0.2454, 0.2867, 0.5370},
    {0.2302, 0.3213, 0.5455}, {0.2148, 0.3545, 0.5510}, {0.2000, 0.3864, 0.5545}, {0.1861, 0.4173, 0.5567},
    {0.1733, 0.4474, 0.5579}, {0.1613, 0.4770, 0.5581}, {0.1497, 0.5064, 0.5573}, {0.1384, 0.5358, 0.5551},
    {0.1281, 0.5651, 0.5509}, {0.1209, 0.5945, 0.5442}, {0.1203, 0.6238, 0.5343}, {0.1310, 0.6529, 0.5208},
    {0.1554, 0.6815, 0.5032}, {0.1930, 0.7096, 0.4812}, {0.2415, 0.7366, 0.4545}, {0.2986, 0.7624, 0.4230},
    {0.3629, 0.7867, 0.3866}, {0.4330, 0.8091, 0.3453}, {0.5081, 0.8292, 0.2992}, {0.5873, 0.8470, 0.2489},
    {0.6694, 0.8622, 0.1954}, {0.7529, 0.8751, 0.1427}, {0.8359, 0.8861, 0.1025}, {0.9166, 0.8961, 0.1008},
    {0.9932, 0.9062, 0.1439},
}};

}  // namespace

std::span<const Rgb> viridis() { return table; }

Rgb viridis_at(double share) {
    constexpr double pieces = table.size() - 1;
    const double x = pieces * (share > 0.0 ? std::min(share, 1.0) : 0.0);
    const std::size_t i = std::min(static_cast<std::size_t>(x), table.size() - 2);
    const double t = x - static_cast<double>(i);
    const Rgb &a = table[i], &b = table[i + 1];
    return {a.red + t * (b.red - a.red), a.green + t * (b.green - a.green), a.blue + t * (b.blue - a.blue)};
}

}  // namespace soft::view
