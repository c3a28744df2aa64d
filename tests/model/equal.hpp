#pragma once
/// Equality of meshes, shapes and cases, with one expectation per field.
#include <gtest/gtest.h>

#include "model/case.hpp"
#include "model/shape.hpp"

namespace soft::model::test {

template <class List, class Same>
void expect_all(const List& left, const List& right, Same same) {
    ASSERT_EQ(left.size(), right.size());
    for (std::size_t i = 0; i < left.size(); ++i) same(left[i], right[i]);
}

void expect_equal(const mesh::Mesh& left, const mesh::Mesh& right);
void expect_equal(const Shape& left, const Shape& right);
void expect_equal(const Case& left, const Case& right);

}  // namespace soft::model::test
