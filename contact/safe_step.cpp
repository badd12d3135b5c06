#include "contact/safe_step.hpp"

#include <algorithm>
#include <limits>

namespace velum::contact {

double largest_safe_step(PointContact const& c, std::vector<core::Vec3> const& X,
                         std::vector<core::Vec3> const& V, double share)
{
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < X.size(); ++i)
    if (double const speed = norm(V[i]); speed > 0)
      step = std::min(step, share * std::max(c.offset[i], c.solid(X[i])) / speed);
  return step;
}

double largest_safe_step(Contact const& c, core::Markers const& m, double share)
{
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < m.X.size(); ++i)
    if (double const speed = norm(m.V[i]); speed > 0) {
      double const way = std::max(m.offset[i], core::distance(c.obstacle, m.X[i]));
      step = std::min(step, share * way / speed);
    }
  return step;
}

double largest_safe_step(SurfaceContact const& c, std::vector<core::Vec3> const& V, double share)
{
  core::Vec3 mean;
  for (auto const& v : V) mean += 1 / static_cast<double>(V.size()) * v;
  double fastest = 0;
  for (auto const& v : V) fastest = std::max(fastest, norm(v - mean));
  if (fastest == 0) return std::numeric_limits<double>::infinity();
  double const thickness = 2 * std::ranges::min(c.half);
  return share * thickness / (2 * fastest);
}

}  // namespace velum::contact
