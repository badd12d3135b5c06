#pragma once
#include <Kokkos_Core.hpp>
#include <cmath>

namespace velum::core {

/// Fixed-size vector in registers; usable on host and device.
template <class Real, int N>
struct Vec {
  Real c[N] = {};

  KOKKOS_FUNCTION Real& operator[](int i) { return c[i]; }
  KOKKOS_FUNCTION Real const& operator[](int i) const { return c[i]; }

  KOKKOS_FUNCTION Vec& operator+=(Vec const& b)
  {
    for (int i = 0; i < N; ++i) c[i] += b.c[i];
    return *this;
  }
  KOKKOS_FUNCTION Vec& operator-=(Vec const& b)
  {
    for (int i = 0; i < N; ++i) c[i] -= b.c[i];
    return *this;
  }
  KOKKOS_FUNCTION Vec& operator*=(Real s)
  {
    for (int i = 0; i < N; ++i) c[i] *= s;
    return *this;
  }
  KOKKOS_FUNCTION friend Vec operator+(Vec a, Vec const& b) { return a += b; }
  KOKKOS_FUNCTION friend Vec operator-(Vec a, Vec const& b) { return a -= b; }
  KOKKOS_FUNCTION friend Vec operator*(Real s, Vec a) { return a *= s; }
  KOKKOS_FUNCTION friend Vec operator*(Vec a, Real s) { return a *= s; }
};

template <class Real, int N>
KOKKOS_FUNCTION Real dot(Vec<Real, N> const& a, Vec<Real, N> const& b)
{
  Real s = 0;
  for (int i = 0; i < N; ++i) s += a[i] * b[i];
  return s;
}

template <class Real, int N>
KOKKOS_FUNCTION Real norm(Vec<Real, N> const& a)
{
  using Kokkos::sqrt;
  using std::sqrt;
  return sqrt(dot(a, a));
}

/// A point or direction of the plane (planar) or of the meridional plane (axisymmetric):
/// [0] along the axis, [1] across it (the radius where the scene is axisymmetric).
using Vec2 = Vec<double, 2>;

/// The direction a turned left by a quarter turn.
inline Vec2 left_of(Vec2 const& a) { return {-a[1], a[0]}; }

/// A point or direction of space. What holds a place of either kind of scene is a Vec3 too, whose
/// last component a plane one leaves 0.
using Vec3 = Vec<double, 3>;

inline Vec2 in_plane(Vec3 const& a) { return {a[0], a[1]}; }

/// Vector product: normal to a and b, right-handed, as long as their parallelogram is large.
template <class Real>
KOKKOS_FUNCTION Vec<Real, 3> cross(Vec<Real, 3> const& a, Vec<Real, 3> const& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace velum::core
