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

using Kernel = CGAL::Simple_cartesian<double>;  // inexact: distances only, no inside/outside decisions

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
    using Aabb = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
    Aabb aabb;

    [[nodiscard]] ClosestPoint closest_point(const mesh::Point& from,
                                             const typename Aabb::Point_and_primitive_id& found) const {
        const mesh::Point point{found.first.x(), found.first.y(), found.first.z()};
        return {point, static_cast<int>(found.second - elements.cbegin()),
                std::hypot(point[0] - from[0], point[1] - from[1], point[2] - from[2])};
    }
};

template <std::size_t corners>
NearestOn<corners>::NearestOn(const std::vector<mesh::Point>& points,
                              const std::vector<std::array<int, corners>>& elements)
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
auto NearestOn<corners>::operator()(const mesh::Point& from) const -> ClosestPoint {
    return tree_->closest_point(from,
                                tree_->aabb.closest_point_and_primitive(Kernel::Point_3(from[0], from[1], from[2])));
}

template <std::size_t corners>
auto NearestOn<corners>::within(const mesh::Point& from, double distance_m) const -> std::optional<ClosestPoint> {
    const typename Tree::Aabb::Point_and_primitive_id border{Kernel::Point_3(from[0] + distance_m, from[1], from[2]),
                                                             tree_->elements.cbegin()};
    const auto found = tree_->aabb.closest_point_and_primitive(Kernel::Point_3(from[0], from[1], from[2]), border);
    if (found.first == border.first) return std::nullopt;  // initial guess of the search: nothing is nearer
    return tree_->closest_point(from, found);
}

template class NearestOn<3>;
template class NearestOn<2>;

}  // namespace soft::surface
