#include "structure/spring.hpp"

#include "core/check.hpp"
#include "structure/triangle_element.hpp"
#include "structure/triangle_part.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

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

Eigen::VectorXd normalised(Eigen::VectorXd const& w)
{
  double const sum = w.sum();
  core::require(sum > 0, "the spring's patch does not touch the membrane: enlarge its radius");
  return w / sum;
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
  return normalised(w);
}

Eigen::VectorXd patch_weights(Sheet const& s, double radius)
{
  Eigen::VectorXd w = Eigen::VectorXd::Zero(node_count(s));
  for (int e = 0; e < element_count(s); ++e) {
    auto const& t = s.triangles[static_cast<std::size_t>(e)];
    Eigen::Vector3d inwards;
    for (int a = 0; a < 3; ++a) {
      Eigen::Vector3d const X = node3(s.reference, t[static_cast<std::size_t>(a)]);
      inwards[a] = radius - std::hypot(X[1], X[2]);
    }
    Eigen::Vector3d const share =
        triangle_shape(s, e).area * integral(part_above(inwards), Eigen::Vector4d::Ones());
    for (int a = 0; a < 3; ++a) w[t[static_cast<std::size_t>(a)]] += share[a];
  }
  return normalised(w);
}

template <class Body>
double spring_force(Body const& m, Spring const& spring, Eigen::VectorXd const& weights,
                    Eigen::VectorXd const& x)
{
  constexpr int d = Body::dimension;
  double away = 0;
  for (int a = 0; a < node_count(m); ++a) away -= weights[a] * (x[d * a] - m.reference[d * a]);
  return -spring.stiffness * (spring.free_length - spring.installed_length - away);
}

template <class Body>
Load spring_load(Body const& m, Spring const& spring)
{
  constexpr int d = Body::dimension;
  struct Share {
    int dof;
    double weight, reference;
  };
  std::vector<Share> patch;
  Eigen::VectorXd const w = patch_weights(m, spring.radius);
  for (int a = 0; a < node_count(m); ++a)
    if (w[a] > 0) patch.push_back({d * a, w[a], m.reference[d * a]});
  return [patch, spring](Eigen::VectorXd const& x, Eigen::VectorXd& force, Triplets* tangent) {
    double away = 0;
    for (auto const& s : patch) away -= s.weight * (x[s.dof] - s.reference);
    double const preload = spring.free_length - spring.installed_length;
    for (auto const& s : patch) force[s.dof] -= spring.stiffness * (preload - away) * s.weight;
    if (!tangent) return;
    for (auto const& row : patch)
      for (auto const& column : patch)
        tangent->emplace_back(row.dof, column.dof, -spring.stiffness * row.weight * column.weight);
  };
}

template double spring_force(Membrane const&, Spring const&, Eigen::VectorXd const&,
                             Eigen::VectorXd const&);
template double spring_force(Sheet const&, Spring const&, Eigen::VectorXd const&,
                             Eigen::VectorXd const&);
template Load spring_load(Membrane const&, Spring const&);
template Load spring_load(Sheet const&, Spring const&);

}  // namespace velum::structure
