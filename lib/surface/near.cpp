#include "surface/near.hpp"

#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <type_traits>

namespace soft::surface {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;   // distances: nothing here decides what is inside or out

Kernel::Point_3 at(const std::vector<mesh::Point>& points, int number) {
    const mesh::Point& p = points[static_cast<std::size_t>(number)];
    return {p[0], p[1], p[2]};
}

}  // namespace

template <std::size_t corners>
struct NearestOn<corners>::Tree {
    using Element = std::conditional_t<corners == 3, Kernel::Triangle_3, Kernel::Segment_3>;
    using Iterator = typename std::vector<Element>::const_iterator;
    using Primitive = std::conditional_t<corners == 3, CGAL::AABB_triangle_primitive<Kernel, Iterator>,
                                         CGAL::AABB_segment_primitive<Kernel, Iterator>>;
    std::vector<Element> elements;
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> aabb;
};

template <std::size_t corners>
NearestOn<corners>::NearestOn(const std::vector<mesh::Point>& points, const std::vector<std::array<int, corners>>& elements)
    : tree_(std::make_unique<Tree>()) {
    for (const auto& element : elements) {
        if constexpr (corners == 3)
            tree_->elements.emplace_back(at(points, element[0]), at(points, element[1]), at(points, element[2]));
        else
            tree_->elements.emplace_back(at(points, element[0]), at(points, element[1]));
    }
    tree_->aabb.insert(tree_->elements.cbegin(), tree_->elements.cend());
    tree_->aabb.build();
    tree_->aabb.accelerate_distance_queries();
}

template <std::size_t corners>
NearestOn<corners>::~NearestOn() = default;
template <std::size_t corners>
NearestOn<corners>::NearestOn(NearestOn&&) noexcept = default;
template <std::size_t corners>
NearestOn<corners>& NearestOn<corners>::operator=(NearestOn&&) noexcept = default;

template <std::size_t corners>
auto NearestOn<corners>::operator()(const mesh::Point& from) const -> Place {
    const auto [point, element] = tree_->aabb.closest_point_and_primitive(Kernel::Point_3(from[0], from[1], from[2]));
    const mesh::Point place{point.x(), point.y(), point.z()};
    return {place, static_cast<int>(element - tree_->elements.cbegin()), std::hypot(place[0] - from[0], place[1] - from[1], place[2] - from[2])};
}

template class NearestOn<3>;
template class NearestOn<2>;

}  // namespace soft::surface
