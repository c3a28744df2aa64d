#pragma once
#include <string>

#include "optimize/search.hpp"

namespace soft::optimize::test {

inline Variable variable(const std::string& key, double from, double to) {
    Variable one;
    one.key = key;
    one.from = from;
    one.to = to;
    return one;
}

inline const Progress silent = [](const Found&) {};

}  // namespace soft::optimize::test
