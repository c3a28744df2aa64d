#pragma once
/// The path at given values of a quantity: `postprocess --at elongation=40mm,80mm`. Tested by post/request_test.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "post/curve.hpp"

namespace soft::post {

/// One value of the option --at.
struct Request {
    std::string quantity;
    double value_SI = 0;
};

/// Parses "pressure=10kPa,20kPa" into one request per value. Throws Error(usage) for a text without '=', an unknown quantity, or a value
/// without a unit of the quantity's dimension.
[[nodiscard]] std::vector<Request> parse_requests(std::string_view text, const Curve& curve);

/// All columns at each crossing of the request, in path order; empty if the path does not reach the value (a value beyond the range by at
/// most a millionth of it counts as its end). Throws Error(usage) for an unknown quantity.
[[nodiscard]] std::vector<std::vector<double>> crossing_rows(const Curve& curve, const Request& request);

/// One row for each crossing of each request: requests in the given order, crossings in path order. Throws Error: usage for an unknown
/// quantity; bad_input, with the range of the path, for a value that the path does not reach (tolerance as in crossing_rows).
[[nodiscard]] Curve rows_at(const Curve& curve, std::span<const Request> requests);

}  // namespace soft::post
