#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

namespace velum::structure {

/// The unit normal of a surface element in d dimensions whose tangents are linear in its N
/// coordinates, and, for second derivatives of what it projects, its derivative.
template <int d, int N>
struct UnitNormal {
  using Map = Eigen::Matrix<double, d, N>;
  Eigen::Matrix<double, d, 1> n;
  Eigen::Matrix<double, d, d - 1> dual;  ///< contravariant tangents
  Map tangent_map[d - 1];                ///< d tangent / d coordinates
  Map derivative;                        ///< d n / d coordinates: -sum of dual (n . d tangent)
};

template <int d, int N>
UnitNormal<d, N> unit_normal(Eigen::Matrix<double, d, d - 1> const& tangents,
                             Eigen::Matrix<double, d, N> const (&maps)[d - 1], bool second)
{
  UnitNormal<d, N> u;
  if constexpr (d == 3)
    u.n = tangents.col(0).cross(tangents.col(1)).normalized();
  else
    u.n = Eigen::Vector2d(tangents(1), -tangents(0)).normalized();  // to the right
  u.dual = tangents * (tangents.transpose() * tangents).inverse();
  for (int b = 0; b < d - 1; ++b) u.tangent_map[b] = maps[b];
  if (!second) return u;
  u.derivative.setZero();
  for (int b = 0; b < d - 1; ++b) u.derivative -= u.dual.col(b) * (u.n.transpose() * maps[b]);
  return u;
}

/// A scalar with its gradient and, where asked for, its Hessian by N coordinates.
template <int N>
struct Jet {
  double value;
  Eigen::Matrix<double, N, 1> gradient;
  Eigen::Matrix<double, N, N> hessian;
};

/// The normal part g . n of a vector g that is linear in the coordinates, dg = G dx. With
/// n . tangent = 0 and n . n = 1 varied twice,
///   d(g.n) = n^T M,   d2(g.n) = M^T T + T^T M - (g.n) T^T T,   M = G - sum of (g . dual_b) B_b,
/// T the derivative of n and B_b those of the tangents.
/// @param second  whether the Hessian is wanted; it costs the most
template <int d, int N>
Jet<N> normal_part(UnitNormal<d, N> const& u, Eigen::Matrix<double, d, 1> const& g,
                   Eigen::Matrix<double, d, N> const& G, bool second)
{
  Eigen::Matrix<double, d, N> M = G;
  for (int b = 0; b < d - 1; ++b) M -= g.dot(u.dual.col(b)) * u.tangent_map[b];
  Jet<N> jet;
  jet.value = g.dot(u.n);
  jet.gradient = M.transpose() * u.n;
  if (!second) return jet;
  auto const& T = u.derivative;
  Eigen::Matrix<double, N, N> const mixed = M.transpose() * T;
  jet.hessian = mixed + mixed.transpose() - jet.value * (T.transpose() * T);
  return jet;
}

}  // namespace velum::structure
