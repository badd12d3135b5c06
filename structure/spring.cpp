#include "structure/spring.hpp"

#include "core/check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace velum::structure {
namespace {

/// Part [0, 1] of the straight element from a to b that lies within |y| <= radius; empty: from >
/// to.
std::pair<double, double> part_within(double a, double b, double radius)
{
  if (a == b) return std::abs(a) <= radius ? std::pair{0.0, 1.0} : std::pair{1.0, 0.0};
  double const low = (-radius - a) / (b - a), high = (radius - a) / (b - a);
  return {std::max(0.0, std::min(low, high)), std::min(1.0, std::max(low, high))};
}

}  // namespace

Eigen::VectorXd patch_weights(Membrane const& m, double radius)
{
  Eigen::VectorXd w = Eigen::VectorXd::Zero(node_count(m));
  for (int e = 0; e < element_count(m); ++e) {
    auto const a = node(m.reference, e), b = node(m.reference, e + 1);
    auto const [from, to] = part_within(a[1], b[1], radius);
    if (from >= to) continue;
    // Simpson's rule integrates the product of shape function and ring length exactly.
    double const third = (to - from) * norm(b - a) / 6;
    for (auto const& [xi, weight] :
         std::array{std::pair{from, 1.0}, std::pair{0.5 * (from + to), 4.0}, std::pair{to, 1.0}}) {
      double const area = third * weight * core::ring(m.symmetry, a[1] + xi * (b[1] - a[1]));
      w[e] += (1 - xi) * area;
      w[e + 1] += xi * area;
    }
  }
  double const sum = w.sum();
  core::require(sum > 0, "the spring's patch does not touch the membrane: enlarge its radius");
  return w / sum;
}

double spring_force(Membrane const& m, Spring const& spring, Eigen::VectorXd const& weights,
                    Eigen::VectorXd const& x)
{
  double away = 0;
  for (int a = 0; a < node_count(m); ++a) away -= weights[a] * (x[2 * a] - m.reference[2 * a]);
  return -spring.stiffness * (spring.free_length - spring.installed_length - away);
}

Load spring_load(Membrane const& m, Spring const& spring)
{
  Eigen::VectorXd const w = patch_weights(m, spring.radius);
  Eigen::VectorXd const reference = m.reference;
  int used = static_cast<int>(w.size());
  while (used > 0 && w[used - 1] == 0) --used;
  return [w, reference, used, spring](Eigen::VectorXd const& x, Eigen::VectorXd& force,
                                      Triplets* tangent) {
    double away = 0;
    for (int a = 0; a < used; ++a) away -= w[a] * (x[2 * a] - reference[2 * a]);
    double const preload = spring.free_length - spring.installed_length;
    for (int a = 0; a < used; ++a) force[2 * a] -= spring.stiffness * (preload - away) * w[a];
    if (!tangent) return;
    for (int a = 0; a < used; ++a)
      for (int b = 0; b < used; ++b)
        tangent->emplace_back(2 * a, 2 * b, -spring.stiffness * w[a] * w[b]);
  };
}

}  // namespace velum::structure
