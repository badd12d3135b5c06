#pragma once
#include "contact/surface_contact.hpp"

namespace velum::contact {

/// The points of a layout, each small triangle giving a third of its undeformed area (times one
/// half where both bodies' points touch) to each of its corners.
/// @throws InputError  less than one part per side; points of the first body where there is no
/// other
std::vector<SurfacePoint> surface_points(SurfaceContact const& c, PointLayout const& layout);

/// Place of a point among the places of the nodes.
inline core::Vec3 place_of(SurfacePoint const& p, std::vector<core::Vec3> const& place)
{
  core::Vec3 x;
  for (std::size_t i = 0; i < 3; ++i) x += p.share[i] * place[static_cast<std::size_t>(p.nodes[i])];
  return x;
}

}  // namespace velum::contact
