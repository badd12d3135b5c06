#include "ibm/loss.hpp"

#include "core/check.hpp"

#include <cmath>

namespace velum::ibm {

Loss orifice_loss(Liquid const& liquid, double area, double diameter, double discharge,
                  double transition)
{
  core::require(area > 0 && diameter > 0 && discharge > 0 && transition > 0,
                "an orifice needs an area, a diameter, a discharge coefficient and a Reynolds "
                "number of transition above 0");
  double const inertial = liquid.density / (2 * discharge * discharge * area * area);
  return {inertial * transition * area * liquid.viscosity / diameter, inertial};
}

Loss slit_loss(Liquid const& liquid, double width, double height, double length, double discharge)
{
  core::require(width > 0 && height > 0 && length > 0 && discharge > 0,
                "a gap needs a width, a height, a length and a discharge coefficient above 0");
  double const area = width * height * discharge;
  return {12 * liquid.density * liquid.viscosity * length / (width * height * height * height),
          liquid.density / (2 * area * area)};
}

double flow(Loss const& loss, double dp)
{
  // the root that does not lose its digits where friction rules
  double const size = 2 * std::abs(dp);
  double const root =
      std::sqrt(loss.viscous * loss.viscous + 2 * size * loss.inertial) + loss.viscous;
  return root > 0 ? std::copysign(size / root, dp) : 0;
}

}  // namespace velum::ibm
