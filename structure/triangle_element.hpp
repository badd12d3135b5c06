#pragma once
#include "structure/load.hpp"
#include "structure/plane_stress.hpp"
#include "structure/sheet.hpp"

#include <Eigen/Geometry>

namespace velum::structure {

/// A triangle of constant strain in its undeformed state: area, and the gradients of its three
/// shape functions in an orthonormal frame of its own plane.
struct TriangleShape {
  double area;
  Eigen::Matrix<double, 3, 2> gradient;  ///< dN_a / dX
};

inline TriangleShape triangle_shape(Sheet const& s, int e)
{
  auto const& t = s.triangles[static_cast<std::size_t>(e)];
  Eigen::Vector3d const p = node3(s.reference, t[0]), u = node3(s.reference, t[1]) - p,
                        v = node3(s.reference, t[2]) - p;
  double const base = u.norm(), along = u.dot(v) / base, height = u.cross(v).norm() / base;
  TriangleShape k;
  k.area = base * height / 2;
  // corners at (0, 0), (base, 0), (along, height)
  k.gradient << -1 / base, (along - base) / (base * height), 1 / base, -along / (base * height), 0,
      1 / height;
  return k;
}

/// The two columns of F: what the frame's axes have become.
inline Eigen::Matrix<double, 3, 2> deformation_gradient(Sheet const& s, Eigen::VectorXd const& x,
                                                        TriangleShape const& k, int e)
{
  Eigen::Matrix<double, 3, 2> F = Eigen::Matrix<double, 3, 2>::Zero();
  auto const& t = s.triangles[static_cast<std::size_t>(e)];
  for (int a = 0; a < 3; ++a) F += node3(x, t[a]) * k.gradient.row(a);
  return F;
}

using Vector9 = Eigen::Matrix<double, 9, 1>;
using Matrix9 = Eigen::Matrix<double, 9, 9>;

/// A triangle in its current state: strain, energy, and the derivative of (C11, C22, C12) by its
/// nine coordinates.
struct TriangleElement {
  double volume;  ///< reference area times thickness
  TriangleShape shape;
  Eigen::Matrix<double, 3, 2> F;
  PlaneStress energy;  ///< per volume
  Eigen::Matrix<double, 3, 9> strain_rate;
};

inline TriangleElement triangle_element(Sheet const& s, Eigen::VectorXd const& x, int e)
{
  TriangleElement k;
  k.shape = triangle_shape(s, e);
  k.volume = k.shape.area * s.thickness[e];
  k.F = deformation_gradient(s, x, k.shape, e);
  auto const f1 = k.F.col(0), f2 = k.F.col(1);
  k.energy = plane_stress(s.material, f1.dot(f1), f2.dot(f2), f1.dot(f2));
  for (int a = 0; a < 3; ++a) {
    double const b1 = k.shape.gradient(a, 0), b2 = k.shape.gradient(a, 1);
    k.strain_rate.block<1, 3>(0, 3 * a) = 2 * b1 * f1.transpose();
    k.strain_rate.block<1, 3>(1, 3 * a) = 2 * b2 * f2.transpose();
    k.strain_rate.block<1, 3>(2, 3 * a) = b2 * f1.transpose() + b1 * f2.transpose();
  }
  return k;
}

/// Gradient of the element's energy by its nine coordinates.
inline Vector9 element_force(TriangleElement const& k)
{
  return k.volume * k.strain_rate.transpose() * k.energy.gradient;
}

/// Second derivative of the element's energy: of the material, and of the strains themselves;
/// symmetric, exact.
inline Matrix9 element_tangent(TriangleElement const& k)
{
  Matrix9 K = k.strain_rate.transpose() * k.energy.hessian * k.strain_rate;
  auto const& g = k.energy.gradient;
  auto const& B = k.shape.gradient;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      double const stress = 2 * g[0] * B(a, 0) * B(b, 0) + 2 * g[1] * B(a, 1) * B(b, 1) +
                            g[2] * (B(a, 0) * B(b, 1) + B(a, 1) * B(b, 0));
      K.block<3, 3>(3 * a, 3 * b).diagonal().array() += stress;
    }
  return k.volume * K;
}

/// Adds the matrix of some nodes' coordinates to that of all.   k: [3n, 3n]
template <std::size_t n, class Matrix>
void add_block(Triplets& entries, std::array<int, n> const& nodes, Matrix const& k)
{
  int const size = 3 * static_cast<int>(n);
  auto const place = [&](int i) { return 3 * nodes[static_cast<std::size_t>(i / 3)] + i % 3; };
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j) entries.emplace_back(place(i), place(j), k(i, j));
}

/// Principal stretches in the plane of the element, the larger first.
inline Eigen::Vector2d principal_stretches(Eigen::Matrix<double, 3, 2> const& F)
{
  double const a = F.col(0).squaredNorm(), b = F.col(1).squaredNorm(), c = F.col(0).dot(F.col(1));
  double const mean = (a + b) / 2, radius = std::hypot((a - b) / 2, c);
  // the smaller from the determinant: the difference would cancel
  double const larger = mean + radius, smaller = (a * b - c * c) / larger;
  return {std::sqrt(larger), std::sqrt(smaller > 0 ? smaller : 0)};
}

}  // namespace velum::structure
