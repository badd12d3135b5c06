#include "contact/point_contact.hpp"

#include <algorithm>
#include <cmath>

#include "contact/penalty.hpp"

namespace velum::contact {
namespace {

double multiplier_of(PointContact const& c, std::size_t i)
{
  return c.multiplier.empty() ? 0 : c.multiplier[i];
}

core::Vec3 shifted(core::Vec3 X, int axis, double by)
{
  X[axis] += by;
  return X;
}

core::Vec3 normal(PointContact const& c, core::Vec3 const& X)
{
  core::Vec3 n;
  for (int a = 0; a < 3; ++a)
    n[a] = c.solid(shifted(X, a, c.probe)) - c.solid(shifted(X, a, -c.probe));
  return 1 / norm(n) * n;
}

}  // namespace

double pressing(PointContact const& c, std::size_t i, core::Vec3 const& X)
{
  return multiplier_of(c, i) - c.stiffness * (c.solid(X) - c.offset[i]);
}

Touch touch(PointContact const& c, std::size_t i, core::Vec3 const& X)
{
  double const gap = c.solid(X) - c.offset[i];
  double const t = traction(c.stiffness, gap, multiplier_of(c, i));
  return {gap, t, t > 0 ? normal(c, X) : core::Vec3{}};
}

std::array<std::array<double, 3>, 3> tangent(PointContact const& c, std::size_t i,
                                             core::Vec3 const& X)
{
  std::array<std::array<double, 3>, 3> K{};
  auto const at = touch(c, i, X);
  if (at.traction <= 0) return K;
  for (std::size_t b = 0; b < 3; ++b) {
    int const axis = static_cast<int>(b);
    auto const turned =
        normal(c, shifted(X, axis, c.probe)) - normal(c, shifted(X, axis, -c.probe));
    for (std::size_t a = 0; a < 3; ++a)
      K[a][b] = c.area[i] * (at.traction * turned[static_cast<int>(a)] / (2 * c.probe) -
                             c.stiffness * at.normal[static_cast<int>(a)] * at.normal[axis]);
  }
  return K;
}

double update_multipliers(PointContact& c, std::vector<core::Vec3> const& X)
{
  c.multiplier.resize(X.size(), 0);
  double change = 0;
  for (std::size_t i = 0; i < X.size(); ++i) {
    double const updated = touch(c, i, X[i]).traction;
    change = std::max(change, std::abs(updated - c.multiplier[i]));
    c.multiplier[i] = updated;
  }
  return change;
}

ContactSum sum_up(PointContact const& c, std::vector<core::Vec3> const& X)
{
  ContactSum sum;
  for (std::size_t i = 0; i < X.size(); ++i) {
    auto const at = touch(c, i, X[i]);
    sum.penetration = std::max(sum.penetration, -at.gap);
    if (at.traction <= 0) continue;
    sum.area += c.area[i];
    sum.force += c.area[i] * at.traction * at.normal;
    sum.largest = std::max(sum.largest, at.traction);
    sum.complementarity = std::max(sum.complementarity, std::abs(at.traction * at.gap));
  }
  return sum;
}

}  // namespace velum::contact
