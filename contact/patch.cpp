#include "contact/patch.hpp"

#include "contact/penalty.hpp"

#include <algorithm>

namespace velum::contact {
namespace {

/// lambda - k g: the traction where positive, minus the clearance (times k) where negative.
double pressing(Contact const& c, core::Markers const& markers, int i)
{
  return multiplier_of(c, i) - c.stiffness * gap(c, markers, i);
}

/// Zero between a touching marker and its free neighbour, in marker numbers.
double edge(Contact const& c, core::Markers const& markers, int touching, int free)
{
  if (free < 0 || free >= static_cast<int>(markers.X.size())) return touching;
  double const in = pressing(c, markers, touching), out = pressing(c, markers, free);
  return touching + (free - touching) * in / (in - out);
}

}  // namespace

Patch contact_patch(Contact const& c, core::Markers const& markers)
{
  Patch p;
  for (int i = 0; i < static_cast<int>(markers.X.size()); ++i) {
    auto const nearest = core::nearest_surface(c.obstacle, markers.X[i]);
    double const g = nearest.distance - markers.offset[i];
    double const t = traction(c.stiffness, g, multiplier_of(c, i));
    p.penetration = std::max(p.penetration, -g);
    if (t <= 0) continue;
    if (p.first < 0) p.first = i;
    p.last = i;
    p.force += markers.area[i] * t;
    p.resultant += markers.area[i] * t * nearest.normal;
  }
  if (p.first < 0) return p;
  p.begin = edge(c, markers, p.first, p.first - 1);
  p.end = edge(c, markers, p.last, p.last + 1);
  return p;
}

}  // namespace velum::contact
