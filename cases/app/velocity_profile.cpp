#include "cases/app/velocity_profile.hpp"

#include "lbm/formats.hpp"
#include "lbm/opening.hpp"

#include <algorithm>
#include <cmath>

namespace velum::cases {
namespace {

/// Not scaled.
double shape(Patch const& patch, Vec2 const& at, core::Symmetry symmetry)
{
  if (symmetry == core::Symmetry::axisymmetric && patch.from[0] == 0)
    return 1 - std::pow(at[0] / patch.to[0], 2);
  double product = 1, squared = 0;
  for (int k = 0; k + 1 < core::dimensions(symmetry); ++k) {
    double const s = (at[k] - patch.from[k]) / (patch.to[k] - patch.from[k]);
    product *= 4 * s * (1 - s);
    squared += std::pow(2 * s - 1, 2);
  }
  return patch.disc ? std::max(0.0, 1 - squared) : product;
}

}  // namespace

template <class Real, class L, class Stored>
void shape_velocity(lbm::Fluid<Real, L, Stored> const& fluid, VelocityProfile profile,
                    Patch const& patch, std::vector<Vec2> const& at, Vec3 normal,
                    std::vector<lbm::Link>& links)
{
  if (profile == VelocityProfile::uniform) return;
  std::vector<double> shapes;
  double area = 0, flow = 0;
  for (std::size_t k = 0; k < links.size(); ++k) {
    shapes.push_back(shape(patch, at[k], fluid.symmetry));
    double const part = lbm::opening_area(fluid, {links[k]}, normal);
    area += part;
    flow += shapes[k] * part;
  }
  for (std::size_t k = 0; k < links.size(); ++k)
    links[k].weight = static_cast<float>(shapes[k] * area / flow);
}

#define VELUM_INSTANTIATE(Real, L, Stored)                                               \
  template void shape_velocity(lbm::Fluid<Real, lbm::L, Stored> const&, VelocityProfile, \
                               Patch const&, std::vector<Vec2> const&, Vec3,             \
                               std::vector<lbm::Link>&);
VELUM_EACH_FLUID(VELUM_INSTANTIATE)
#undef VELUM_INSTANTIATE

}  // namespace velum::cases
