#include "structure/line_bending.hpp"

#include "structure/normal_part.hpp"

#include <algorithm>
#include <numbers>

namespace velum::structure {
namespace {

using Map = BendingNode::Map;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// First of the three nodes' coordinates in the whole vector; a missing node's are not looked at.
int first_of(BendingNode const& b) { return 2 * (b.node - 1); }

Vector6 coordinates(BendingNode const& b, Eigen::VectorXd const& x)
{
  Vector6 c = Vector6::Zero();
  c.segment<2>(2) = x.segment<2>(2 * b.node);
  if (b.behind) c.segment<2>(4) = x.segment<2>(2 * b.node + 2);
  if (b.before && !b.on_axis) c.segment<2>(0) = x.segment<2>(2 * b.node - 2);
  return c;
}

struct Curvatures {
  Jet<6> k1, k2;
};

/// @param second  whether the Hessians are wanted
Curvatures curvatures(BendingNode const& b, Eigen::VectorXd const& x, bool second = false)
{
  Vector6 const c = coordinates(b, x);
  Map const maps[1] = {b.tangent};
  auto const normal = unit_normal<2, 6>(b.tangent * c + b.tangent_held, maps, second);
  Curvatures k{normal_part<2, 6>(normal, b.turn * c + b.turn_held, b.turn, second), {}};
  if (b.on_axis) {
    k.k2 = k.k1;
  } else if (b.Y == 0) {
    k.k2.value = 0;
    k.k2.gradient.setZero();
    if (second) k.k2.hessian.setZero();
  } else {
    auto const tilt = normal_part<2, 6>(normal, Eigen::Vector2d(0, 1), Map(Map::Zero()), second);
    double const y = c[3], share = -1 / (b.Y * b.Y);
    Vector6 const by_y = Vector6::Unit(3);
    k.k2.value = share * y * tilt.value;
    k.k2.gradient = share * (y * tilt.gradient + tilt.value * by_y);
    if (second)
      k.k2.hessian = share * (y * tilt.hessian + by_y * tilt.gradient.transpose() +
                              tilt.gradient * by_y.transpose());
  }
  return k;
}

/// Derivatives of the energy by e1 and e2.
Eigen::Vector2d moments(BendingNode const& b, Curvatures const& k)
{
  return b.area * b.stiffness * b.law * Eigen::Vector2d(k.k1.value - b.k1, k.k2.value - b.k2);
}

/// The slope of the element between the node and the other one, as a map; on the axis the node
/// before is the image of that behind.
Map slope(BendingNode const& b, bool behind, double length)
{
  Map map = Map::Zero();
  Eigen::Matrix2d const one = Eigen::Matrix2d::Identity() / length;
  map.block<2, 2>(0, 2) = behind ? -one : one;
  if (behind)
    map.block<2, 2>(0, 4) = one;
  else if (b.on_axis)
    map.block<2, 2>(0, 4) = one * Eigen::Vector2d(-1, 1).asDiagonal();
  else
    map.block<2, 2>(0, 0) = -one;
  return map;
}

/// Tangent and turn from the slopes of both sides. A clamped end holds the undeformed slope in the
/// place of the side that is missing, and the normal with it; one that is free to turn has the
/// slope of its element, and its turn is none of the energy's.
void find_slopes(BendingNode& b, Membrane const& m, double before, double behind, bool clamped)
{
  double const L = (before + behind) / 2;
  Map const minus = b.before ? slope(b, false, before) : Map(Map::Zero());
  Map const plus = b.behind ? slope(b, true, behind) : Map(Map::Zero());
  b.turn = (plus - minus) / L;
  b.tangent_held = b.turn_held = Eigen::Vector2d::Zero();
  if (b.before && b.behind) {
    b.tangent = (plus + minus) / 2;
    return;
  }
  if (!clamped) {
    b.tangent = plus + minus;
    b.turn = Map::Zero();
    return;
  }
  b.tangent = Map::Zero();
  b.tangent_held = (b.before ? minus : plus) * coordinates(b, m.reference);
  b.turn_held = (b.before ? 1 : -1) / L * b.tangent_held;
}

}  // namespace

LineBending line_bending(Membrane const& m, Rim rim)
{
  LineBending all;
  int const nodes = node_count(m);
  for (int a = 0; a < nodes; ++a) {
    BendingNode b{};
    b.node = a;
    b.on_axis = a == 0 && starts_on_axis(m);
    b.before = a > 0 || b.on_axis;
    b.behind = a + 1 < nodes;
    bool const end = !b.before || !b.behind;
    bool const clamped = rim == Rim::clamped && m.fixed[2 * a] && m.fixed[2 * a + 1];
    bool const ring = m.symmetry == core::Symmetry::axisymmetric;
    if (end && !clamped && !ring) continue;
    auto const here = node(m.reference, a);
    auto const length = [&](int other) { return norm(node(m.reference, other) - here); };
    double const behind = b.behind ? length(a + 1) : 0;
    double const before = b.on_axis ? behind : b.before ? length(a - 1) : 0;
    double const L = (before + behind) / 2;
    find_slopes(b, m, before, behind, clamped);
    b.Y = ring && !(end && clamped) ? here[1] : 0;
    b.law << 1, 0.5, 0.5, 1;
    if (end && !clamped) b.law << 0, 0, 0, 0.75;
    b.area = b.on_axis ? std::numbers::pi * L * L / 4 : core::ring(m.symmetry, here[1]) * L;
    double const H =
        (m.thickness[std::max(a - 1, 0)] + m.thickness[std::min(a, element_count(m) - 1)]) / 2;
    b.stiffness = shear_modulus(m.material) * H * H * H / 3;
    auto const k = curvatures(b, m.reference);
    b.k1 = k.k1.value;
    b.k2 = k.k2.value;
    all.push_back(b);
  }
  return all;
}

double bending_energy(LineBending const& bending, Eigen::VectorXd const& x)
{
  double energy = 0;
  for (auto const& b : bending) {
    auto const k = curvatures(b, x);
    energy += moments(b, k).dot(Eigen::Vector2d(k.k1.value - b.k1, k.k2.value - b.k2)) / 2;
  }
  return energy;
}

Load bending_load(LineBending const& bending)
{
  return [&bending](Eigen::VectorXd const& x, Eigen::VectorXd& force, Triplets* tangent) {
    for (auto const& b : bending) {
      auto const k = curvatures(b, x, tangent != nullptr);
      Eigen::Vector2d const m = moments(b, k);
      Vector6 const gradient = m[0] * k.k1.gradient + m[1] * k.k2.gradient;
      int const first = first_of(b);
      int const from = b.before && !b.on_axis ? 0 : 2, to = b.behind ? 6 : 4;
      for (int i = from; i < to; ++i) force[first + i] -= gradient[i];
      if (!tangent) continue;
      auto const &g1 = k.k1.gradient, &g2 = k.k2.gradient;
      Matrix6 const K = b.area * b.stiffness *
                            (b.law(0, 0) * g1 * g1.transpose() + b.law(1, 1) * g2 * g2.transpose() +
                             b.law(0, 1) * (g1 * g2.transpose() + g2 * g1.transpose())) +
                        m[0] * k.k1.hessian + m[1] * k.k2.hessian;
      for (int i = from; i < to; ++i)
        for (int j = from; j < to; ++j) tangent->emplace_back(first + i, first + j, -K(i, j));
    }
  };
}

Load bending_load(std::shared_ptr<LineBending const> b)
{
  return [b, load = bending_load(*b)](Eigen::VectorXd const& x, Eigen::VectorXd& force,
                                      Triplets* tangent) { load(x, force, tangent); };
}

}  // namespace velum::structure
