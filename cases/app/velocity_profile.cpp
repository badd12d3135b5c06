#include "cases/app/velocity_profile.hpp"

#include "lbm/opening.hpp"

#include <cmath>

namespace velum::cases {

template <class Real>
void shape_velocity(lbm::Fluid<Real> const& fluid, VelocityProfile profile,
                    std::vector<double> const& at, double from, double to, core::Vec3 normal,
                    std::vector<lbm::Link>& links)
{
  if (profile == VelocityProfile::uniform) return;
  bool const bore = fluid.symmetry == core::Symmetry::axisymmetric && from == 0;
  std::vector<double> shape;
  double area = 0, flow = 0;
  for (std::size_t k = 0; k < links.size(); ++k) {
    double const s = (at[k] - from) / (to - from);
    shape.push_back(bore ? 1 - s * s : 4 * s * (1 - s));
    double const part = lbm::opening_area(fluid, {links[k]}, normal);
    area += part;
    flow += shape[k] * part;
  }
  for (std::size_t k = 0; k < links.size(); ++k)
    links[k].weight = static_cast<float>(shape[k] * area / flow);
}

template void shape_velocity(lbm::Fluid<float> const&, VelocityProfile, std::vector<double> const&,
                             double, double, core::Vec3, std::vector<lbm::Link>&);
template void shape_velocity(lbm::Fluid<double> const&, VelocityProfile, std::vector<double> const&,
                             double, double, core::Vec3, std::vector<lbm::Link>&);

}  // namespace velum::cases
