#include "contact/contact.hpp"

#include "contact/penalty.hpp"

#include <limits>

namespace velum::contact {
namespace {

/// Rate at which the normal turns along the tangent s: the curvature of the level line of distance.
double curvature(core::Obstacle const& obstacle, core::Vec2 const& X, core::Vec2 const& s,
                 double probe)
{
  auto const ahead = core::gradient(obstacle, X + probe * s);
  auto const behind = core::gradient(obstacle, X - probe * s);
  return dot(s, ahead - behind) / (2 * probe);
}

/// Returns the marker's distance from the obstacle.
double add_force(Contact const& c, core::Markers& markers, std::size_t i)
{
  auto const nearest = core::nearest_surface(c.obstacle, markers.X[i]);
  double const t = traction(c.stiffness, nearest.distance - markers.offset[i], multiplier_of(c, i));
  if (t > 0) markers.F[i] += markers.area[i] * t * nearest.normal;
  return nearest.distance;
}

}  // namespace

double gap(Contact const& c, core::Markers const& markers, std::size_t i)
{
  return core::distance(c.obstacle, markers.X[i]) - markers.offset[i];
}

void add_forces(Contact const& c, core::Markers& markers)
{
  for (std::size_t i = 0; i < markers.X.size(); ++i) add_force(c, markers, i);
}

void add_forces(Contact const& c, core::Markers& markers, Clearance& seen)
{
  if (!c.multiplier.empty()) return add_forces(c, markers);
  auto const& X = markers.X;
  if (seen.X.size() != X.size()) {
    seen.X.assign(X.size(), {});
    seen.distance.assign(X.size(), -std::numeric_limits<double>::infinity());
  }
  for (std::size_t i = 0; i < X.size(); ++i) {
    if (seen.distance[i] - norm(X[i] - seen.X[i]) > markers.offset[i]) continue;
    seen.distance[i] = add_force(c, markers, i);
    seen.X[i] = X[i];
  }
}

void tangents(Contact const& c, core::Markers const& markers, double probe,
              std::vector<SymmetricBlock>& blocks)
{
  blocks.assign(markers.X.size(), {});
  for (std::size_t i = 0; i < markers.X.size(); ++i) {
    auto const nearest = core::nearest_surface(c.obstacle, markers.X[i]);
    double const t =
        traction(c.stiffness, nearest.distance - markers.offset[i], multiplier_of(c, i));
    if (t <= 0) continue;
    auto const n = nearest.normal, s = core::left_of(n);
    double const kappa = probe > 0 ? curvature(c.obstacle, markers.X[i], s, probe) : 0;
    double const normal = -markers.area[i] * c.stiffness, turn = markers.area[i] * t * kappa;
    blocks[i] = {.xx = normal * n[0] * n[0] + turn * s[0] * s[0],
                 .xy = normal * n[0] * n[1] + turn * s[0] * s[1],
                 .yy = normal * n[1] * n[1] + turn * s[1] * s[1]};
  }
}

}  // namespace velum::contact
