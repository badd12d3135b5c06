#include "structure/sheet_bending.hpp"

#include "structure/normal_part.hpp"
#include "structure/triangle_element.hpp"

#include <map>

namespace velum::structure {
namespace {

using Vector18 = Eigen::Matrix<double, 18, 1>;
using Matrix18 = Eigen::Matrix<double, 18, 18>;
using Map18 = Eigen::Matrix<double, 3, 18>;

/// The triangle on the other side of each directed side, by its opposite corner.
using Neighbours = std::map<std::pair<int, int>, int>;

Neighbours opposite_corners(Sheet const& s)
{
  Neighbours corners;
  for (auto const& t : s.triangles)
    for (int i = 0; i < 3; ++i) corners[{t[i], t[(i + 1) % 3]}] = t[(i + 2) % 3];
  return corners;
}

/// Coordinates of the undeformed triangle in its own frame, first corner at the origin, second on
/// the first axis.
struct Frame {
  Eigen::Vector3d origin, first, second;

  Frame(Eigen::Vector3d const& a, Eigen::Vector3d const& b, Eigen::Vector3d const& c)
      : origin(a), first((b - a).normalized())
  {
    second = (b - a).cross(c - a).cross(b - a).normalized();
  }
  Eigen::Vector2d operator()(Eigen::Vector3d const& p) const
  {
    return {first.dot(p - origin), second.dot(p - origin)};
  }
};

/// Gradients of the three shape functions of a triangle in the plane.
Eigen::Matrix<double, 3, 2> gradients(Eigen::Vector2d const (&p)[3])
{
  Eigen::Matrix2d edges;
  edges << p[1] - p[0], p[2] - p[0];
  Eigen::Matrix2d const inverse = edges.inverse();
  Eigen::Matrix<double, 3, 2> g;
  g.row(1) = inverse.row(0);
  g.row(2) = inverse.row(1);
  g.row(0) = -g.row(1) - g.row(2);
  return g;
}

/// Where a neighbour's far corner lies when it is unfolded about the side from p to q, in whose
/// frame the own triangle is on the left.
Eigen::Vector2d unfolded(Eigen::Vector2d const& p, Eigen::Vector2d const& q,
                         Eigen::Vector3d const& P, Eigen::Vector3d const& Q,
                         Eigen::Vector3d const& far)
{
  Eigen::Vector3d const side = Q - P;
  double const length = side.norm(), along = side.dot(far - P) / length;
  double const away = side.cross(far - P).norm() / length;
  Eigen::Vector2d const t = (q - p) / length, out(t[1], -t[0]);
  return p + along * t + away * out;
}

/// Adds l n_b times the slope to (k11, k22, 2 k12): for one weight of a slope along the two axes.
Eigen::Vector3d flux(Eigen::Vector2d const& normal, double a, double b)
{
  return {normal[0] * a, normal[1] * b, normal[0] * b + normal[1] * a};
}

Eigen::Vector3d point(Eigen::VectorXd const& x, int node) { return x.segment<3>(3 * node); }

/// Curvatures with their derivatives by the 18 coordinates.
/// @param second  whether the Hessians are wanted
std::array<Jet<18>, 3> curvatures(BendingTriangle const& b, Eigen::VectorXd const& x,
                                  bool second = false)
{
  auto const map_of = [](auto const& weights) {
    Map18 map = Map18::Zero();
    for (int a = 0; a < 6; ++a) map.block<3, 3>(0, 3 * a).diagonal().setConstant(weights[a]);
    return map;
  };
  Eigen::Matrix<double, 3, 6> places;
  for (int a = 0; a < 6; ++a) places.col(a) = point(x, b.nodes[static_cast<std::size_t>(a)]);
  Map18 const maps[2] = {map_of(b.slope.col(0)), map_of(b.slope.col(1))};
  auto const normal = unit_normal<3, 18>(places * b.slope, maps, second);
  auto const part = [&](int c) {
    Eigen::Vector3d const g = places * b.curvature.col(c) + b.held.col(c);
    return normal_part<3, 18>(normal, g, map_of(b.curvature.col(c)), second);
  };
  return {part(0), part(1), part(2)};
}

Eigen::Vector3d moments(BendingTriangle const& b, std::array<Jet<18>, 3> const& k)
{
  Eigen::Vector3d const e(k[0].value - b.k0[0], k[1].value - b.k0[1], k[2].value - b.k0[2]);
  return b.stiffness * Eigen::Vector3d(e[0] + e[1] / 2, e[1] + e[0] / 2, e[2] / 4);
}

}  // namespace

SheetBending sheet_bending(Sheet const& s, Rim rim)
{
  auto const corners = opposite_corners(s);
  SheetBending all;
  for (int e = 0; e < element_count(s); ++e) {
    auto const& t = s.triangles[static_cast<std::size_t>(e)];
    Eigen::Vector3d P[3];
    for (int i = 0; i < 3; ++i) P[i] = point(s.reference, t[i]);
    Frame const frame(P[0], P[1], P[2]);
    Eigen::Vector2d const p[3] = {frame(P[0]), frame(P[1]), frame(P[2])};
    BendingTriangle b;
    b.area = triangle_shape(s, e).area;
    double const H = s.thickness[e];
    b.stiffness = shear_modulus(s.material) * H * H * H / 3;
    b.slope.setZero();
    b.curvature.setZero();
    b.held.setZero();
    b.slope.topRows<3>() = gradients(p);
    for (int i = 0; i < 3; ++i) {
      int const j = (i + 1) % 3, k = (i + 2) % 3;  // the side opposite to corner i
      b.nodes[static_cast<std::size_t>(i)] = t[i];
      b.nodes[static_cast<std::size_t>(3 + i)] = t[i];
      Eigen::Vector2d const side = p[k] - p[j];
      Eigen::Vector2d const outwards = Eigen::Vector2d(side[1], -side[0]) / b.area;  // l n / A
      auto const across = corners.find({t[k], t[j]});
      if (across != corners.end()) {
        int const far = across->second;
        b.nodes[static_cast<std::size_t>(3 + i)] = far;
        Eigen::Vector2d const q[3] = {p[k], p[j],
                                      unfolded(p[j], p[k], P[j], P[k], point(s.reference, far))};
        auto const g = gradients(q);
        int const at[3] = {k, j, 3 + i};
        for (int n = 0; n < 3; ++n)
          b.curvature.row(at[n]) += 0.5 * flux(outwards, g(n, 0), g(n, 1)).transpose();
      } else if (rim == Rim::clamped && s.fixed[static_cast<std::size_t>(3 * t[j])] &&
                 s.fixed[static_cast<std::size_t>(3 * t[k])]) {
        for (int c = 0; c < 3; ++c)
          b.held.col(c) +=
              flux(outwards, 1, 0)[c] * frame.first + flux(outwards, 0, 1)[c] * frame.second;
      }
    }
    b.k0.setZero();
    auto const k0 = curvatures(b, s.reference);
    b.k0 = Eigen::Vector3d(k0[0].value, k0[1].value, k0[2].value);
    all.push_back(b);
  }
  return all;
}

double bending_energy(SheetBending const& bending, Eigen::VectorXd const& x)
{
  double energy = 0;
  for (auto const& b : bending) {
    auto const k = curvatures(b, x);
    Eigen::Vector3d const e = Eigen::Vector3d(k[0].value, k[1].value, k[2].value) - b.k0;
    energy += b.area / 2 * e.dot(moments(b, k));
  }
  return energy;
}

Load bending_load(SheetBending const& bending)
{
  return [&bending](Eigen::VectorXd const& x, Eigen::VectorXd& force, Triplets* tangent) {
    for (auto const& b : bending) {
      auto const k = curvatures(b, x, tangent != nullptr);
      Eigen::Vector3d const m = moments(b, k);
      Vector18 gradient = Vector18::Zero();
      for (int c = 0; c < 3; ++c)
        gradient += b.area * m[c] * k[static_cast<std::size_t>(c)].gradient;
      for (int a = 0; a < 6; ++a)
        force.segment<3>(3 * b.nodes[static_cast<std::size_t>(a)]) -= gradient.segment<3>(3 * a);
      if (!tangent) continue;
      Eigen::Matrix<double, 18, 3> rates;
      rates << k[0].gradient, k[1].gradient, k[2].gradient;
      Eigen::Matrix3d D;
      D << 1, 0.5, 0, 0.5, 1, 0, 0, 0, 0.25;
      Matrix18 K = b.stiffness * rates * D * rates.transpose();
      for (int c = 0; c < 3; ++c) K += m[c] * k[static_cast<std::size_t>(c)].hessian;
      K *= -b.area;
      add_block(*tangent, b.nodes, K);
    }
  };
}

}  // namespace velum::structure
