#pragma once
/// The path where it has given values: `postprocess --at elongation=40mm,80mm`. Tested by post/request_test.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "post/curve.hpp"

namespace soft::post {

/// What --at asks for.
struct Request {
    std::string quantity;
    double value_SI = 0;
};

/// "pressure=10kPa,20kPa" -> one request a value. Error(usage): no '=', no such quantity, no number with a unit of the
/// quantity's kind.
[[nodiscard]] std::vector<Request> parse_requests(std::string_view text, const Curve& curve);

/// All columns at each crossing of the request, in the order of the path; none where the path does not reach it (a millionth of
/// the range beyond its ends counts as the end). Error(usage) for a quantity that the curve does not have.
[[nodiscard]] std::vector<std::vector<double>> crossing_rows(const Curve& curve, const Request& request);

/// One row for each crossing of each request: requests in the order given, crossings in the order of the path.
/// Errors: usage for a quantity that the curve does not have; bad_input for a value the path does not reach, with the
/// range that it does reach (a millionth of the range beyond its ends counts as the end).
[[nodiscard]] Curve rows_at(const Curve& curve, std::span<const Request> requests);

}  // namespace soft::post
