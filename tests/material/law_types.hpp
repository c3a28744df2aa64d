#pragma once
/// Every law of the list as a type of GoogleTest's typed suites.
#include <gtest/gtest.h>

#include <tuple>

#include "material/law.hpp"

namespace soft::material::sample {

template <class List>
struct TypesOf;
template <class... L>
struct TypesOf<std::tuple<L...>> {
    using type = ::testing::Types<L...>;
};
using EveryLawType = TypesOf<LawList>::type;

}  // namespace soft::material::sample
