#include "core/signed_distance.hpp"

#include "core/check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace velum::core {
namespace {

template <int D>
bool is_finite(Vec<double, D> const& p)
{
  return std::all_of(p.c, p.c + D, [](double x) { return std::isfinite(x); });
}

/// Distance from the corner that the lines q = 0 make: q holds the distances from the sides, each
/// positive outside its own.
template <int D>
double from_sides(Vec<double, D> const& q)
{
  Vec<double, D> beyond = q;
  for (double& x : beyond.c) x = std::max(x, 0.0);
  return norm(beyond) + std::min(*std::max_element(q.c, q.c + D), 0.0);
}

}  // namespace

SignedDistance<3> sphere(Vec3 const& centre, double radius)
{
  require(is_finite(centre) && std::isfinite(radius) && radius > 0,
          "A sphere needs a positive radius.");
  return [=](Vec3 const& p) { return norm(p - centre) - radius; };
}

SignedDistance<3> cylinder(Vec3 const& from, Vec3 const& to, double radius)
{
  double const length = norm(to - from);
  require(std::isfinite(length) && length > 0, "A cylinder needs two different ends.");
  require(std::isfinite(radius) && radius > 0, "A cylinder needs a positive radius.");
  Vec3 const middle = 0.5 * (from + to), axis = (1 / length) * (to - from);
  return [=](Vec3 const& p) {
    double const along = dot(p - middle, axis);
    double const across = norm(p - middle - along * axis);
    return from_sides(Vec2{across - radius, std::abs(along) - 0.5 * length});
  };
}

template <int D>
SignedDistance<D> box(Vec<double, D> const& lo, Vec<double, D> const& hi)
{
  auto const centre = 0.5 * (lo + hi), half = 0.5 * (hi - lo);
  require(is_finite(lo) && is_finite(hi) && *std::min_element(half.c, half.c + D) > 0,
          "A box needs its first corner below its second in all directions.");
  return [=](Vec<double, D> const& p) {
    Vec<double, D> q;
    for (int k = 0; k < D; ++k) q[k] = std::abs(p[k] - centre[k]) - half[k];
    return from_sides(q);
  };
}

template <int D>
SignedDistance<D> unite(std::vector<SignedDistance<D>> parts)
{
  return [parts = std::move(parts)](Vec<double, D> const& p) {
    double nearest = std::numeric_limits<double>::infinity();
    for (auto const& part : parts) nearest = std::min(nearest, part(p));
    return nearest;
  };
}

template <int D>
SignedDistance<D> subtract(SignedDistance<D> a, SignedDistance<D> b)
{
  return [a = std::move(a), b = std::move(b)](Vec<double, D> const& p) {
    return std::max(a(p), -b(p));
  };
}

template <int D>
SignedDistance<D> scaled(SignedDistance<D> distance, double scale, Vec<double, D> const& shift)
{
  require(std::isfinite(scale) && scale > 0 && is_finite(shift),
          "A solid can only be scaled by a positive number.");
  return [distance = std::move(distance), scale, shift](Vec<double, D> const& p) {
    return scale * distance((1 / scale) * (p - shift));
  };
}

template SignedDistance<2> box(Vec2 const&, Vec2 const&);
template SignedDistance<3> box(Vec3 const&, Vec3 const&);
template SignedDistance<2> unite(std::vector<SignedDistance<2>>);
template SignedDistance<3> unite(std::vector<SignedDistance<3>>);
template SignedDistance<2> subtract(SignedDistance<2>, SignedDistance<2>);
template SignedDistance<3> subtract(SignedDistance<3>, SignedDistance<3>);
template SignedDistance<2> scaled(SignedDistance<2>, double, Vec2 const&);
template SignedDistance<3> scaled(SignedDistance<3>, double, Vec3 const&);

}  // namespace velum::core
