#pragma once
#include "structure/membrane.hpp"
#include "structure/membrane_energy.hpp"

#include <Eigen/Core>

#include <cmath>

namespace velum::structure {

/// Kinematics of element e: straight between its nodes, so the meridional stretch is constant;
/// the hoop stretch is taken at mid-length (one point: second order, no locking, and exact in the
/// element that touches the axis, where y/Y is constant).
struct LineElement {
  double L;       ///< reference length
  double A;       ///< reference area: 2 pi Y L, or L per unit depth
  double Y;       ///< reference radius at mid-length
  double l;       ///< current length
  double l1, l2;  ///< meridional and hoop stretch
  double tx, ty;  ///< unit tangent, from node e to node e + 1
};

inline LineElement line_element(Membrane const& m, Eigen::VectorXd const& x, int e)
{
  int const a = 2 * e, b = a + 2;
  LineElement k;
  k.L = std::hypot(m.reference[b] - m.reference[a], m.reference[b + 1] - m.reference[a + 1]);
  k.Y = 0.5 * (m.reference[a + 1] + m.reference[b + 1]);
  k.A = core::ring(m.symmetry, k.Y) * k.L;
  double const dx = x[b] - x[a], dy = x[b + 1] - x[a + 1];
  k.l = std::sqrt(dx * dx + dy * dy);
  k.tx = dx / k.l, k.ty = dy / k.l;
  k.l1 = k.l / k.L;
  k.l2 = m.symmetry == core::Symmetry::axisymmetric ? 0.5 * (x[a + 1] + x[b + 1]) / k.Y : 1;
  return k;
}

/// Current thickness of an incompressible element, H / (l1 l2).
inline double current_thickness(Membrane const& m, LineElement const& k, int e)
{
  return m.thickness[e] / (k.l1 * k.l2);
}

/// Gradient of the element's energy A W(l1, l2) by its four coordinates (x_e, y_e, x_e+1, y_e+1).
inline Eigen::Vector4d element_force(Membrane const& m, Eigen::VectorXd const& x, int e)
{
  auto const k = line_element(m, x, e);
  auto const w = membrane_energy(m.material, m.thickness[e], k.l1, k.l2);
  double const along = k.A * w.T1 / k.L;
  double const hoop = m.symmetry == core::Symmetry::axisymmetric ? k.A * w.T2 / (2 * k.Y) : 0;
  return {-along * k.tx, -along * k.ty + hoop, along * k.tx, along * k.ty + hoop};
}

/// Second derivative of the element's energy: material part of both stretches and the geometric
/// part T1 (1 - t t^T) / l; symmetric, exact.
inline Eigen::Matrix4d element_tangent(Membrane const& m, Eigen::VectorXd const& x, int e)
{
  auto const k = line_element(m, x, e);
  auto const w = membrane_energy(m.material, m.thickness[e], k.l1, k.l2);
  double const hoop = m.symmetry == core::Symmetry::axisymmetric ? 1 / (2 * k.Y) : 0;
  Eigen::Vector4d const d1 = Eigen::Vector4d(-k.tx, -k.ty, k.tx, k.ty) / k.L;
  Eigen::Vector4d const d2(0, hoop, 0, hoop);
  Eigen::Vector4d const across(k.ty, -k.tx, -k.ty, k.tx);
  return k.A * (w.K11 * d1 * d1.transpose() + w.K22 * d2 * d2.transpose() +
                w.K12 * (d1 * d2.transpose() + d2 * d1.transpose()) +
                w.T1 / (k.L * k.l) * across * across.transpose());
}

}  // namespace velum::structure
