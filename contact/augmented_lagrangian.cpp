#include "contact/augmented_lagrangian.hpp"

#include "contact/penalty.hpp"

#include <algorithm>
#include <cmath>

namespace velum::contact {

double update_multipliers(Contact& c, core::Markers const& markers)
{
  c.multiplier.resize(markers.X.size(), 0);
  double change = 0;
  for (std::size_t i = 0; i < markers.X.size(); ++i) {
    double const updated = traction(c.stiffness, gap(c, markers, i), c.multiplier[i]);
    change = std::max(change, std::abs(updated - c.multiplier[i]));
    c.multiplier[i] = updated;
  }
  return change;
}

double complementarity(Contact const& c, core::Markers const& markers)
{
  double largest = 0;
  for (std::size_t i = 0; i < markers.X.size(); ++i)
    largest = std::max(largest, std::abs(multiplier_of(c, i) * gap(c, markers, i)));
  return largest;
}

}  // namespace velum::contact
