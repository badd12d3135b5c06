#pragma once
#include <Kokkos_Core.hpp>
#include <cstdint>

namespace velum::lbm {

/// Powers (a, b, c) of the moment  sum f cx^a cy^b cz^c.
struct Powers {
  int p[3];

  KOKKOS_FUNCTION constexpr int operator[](int a) const { return p[a]; }
  KOKKOS_FUNCTION constexpr int order() const { return p[0] + p[1] + p[2]; }
  KOKKOS_FUNCTION friend constexpr bool operator==(Powers const& a, Powers const& b)
  {
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
  }
  KOKKOS_FUNCTION friend constexpr Powers operator+(Powers const& a, Powers const& b)
  {
    return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}};
  }
};

/// n numbers of -1, 0 or 1 in two bits each: a direction known only at run time is then looked up
/// in a register, where a table would be built on the stack at every call.
template <class Number>
constexpr std::uint64_t packed(int n, Number number)
{
  std::uint64_t bits = 0;
  for (int i = 0; i < n; ++i) bits |= std::uint64_t(number(i) + 1) << (2 * i);
  return bits;
}

/// The first power along one direction.
KOKKOS_FUNCTION constexpr Powers unit(int a)
{
  return {{a == 0 ? 1 : 0, a == 1 ? 1 : 0, a == 2 ? 1 : 0}};
}

/// A velocity set: D dimensions, Q directions, opposite ones side by side (0 at rest; 1, 2; 3, 4;
/// ...), weights w, and Q moments: density, momentum, second moments (squares first), and higher
/// ones from (1 + D + D (D + 1) / 2) on. The speed of sound squared is 1/3.
template <class L>
concept Lattice = requires(int i)
{
  L::D;
  L::Q;
  L::c(i, 0);
  L::w(i);
  L::opposite(i);
  L::powers(i);
};

/// Number of moments up to the second order.
template <class L>
inline constexpr int second_order_end = 1 + L::D + L::D*(L::D + 1) / 2;

/// cx^a cy^b cz^c of direction i.
template <class L>
KOKKOS_FUNCTION constexpr int monomial(int i, Powers e)
{
  int product = 1;
  for (int a = 0; a < L::D; ++a)
    for (int n = 0; n < e[a]; ++n) product *= L::c(i, a);
  return product;
}

/// Moment of the weights, that of the fluid at rest with density 1.
template <class L>
KOKKOS_FUNCTION constexpr double rest_moment(Powers e)
{
  double sum = 0;
  for (int i = 0; i < L::Q; ++i) sum += L::w(i) * monomial<L>(i, e);
  return sum;
}

/// Place of a moment in the lattice's list, -1 if it is none of the independent ones.
template <class L>
KOKKOS_FUNCTION constexpr int moment_index(Powers e)
{
  for (int k = 0; k < L::Q; ++k)
    if (L::powers(k) == e) return k;
  return -1;
}

/// Place of the second moment P_ab.
template <class L>
KOKKOS_FUNCTION constexpr int second_moment(int a, int b)
{
  return moment_index<L>(unit(a) + unit(b));
}

/// Direction with the component along one axis reversed: the image of i in a plane across it.
template <class L>
KOKKOS_FUNCTION constexpr int mirrored(int i, int axis)
{
  for (int k = 0; k < L::Q; ++k) {
    bool same = true;
    for (int a = 0; a < L::D; ++a) same = same && L::c(k, a) == (a == axis ? -1 : 1) * L::c(i, a);
    if (same) return k;
  }
  return -1;
}

/// Proof at compile time: weights, isotropy up to the fourth order, opposites, independent moments.
template <class L>
constexpr bool is_consistent()
{
  auto const near = [](double a, double b) { return a - b < 1e-15 && b - a < 1e-15; };
  double const cs2 = 1.0 / 3;
  auto const delta = [](int a, int b) { return a == b ? 1.0 : 0.0; };
  if (!near(rest_moment<L>({}), 1)) return false;
  for (int a = 0; a < L::D; ++a)
    for (int b = 0; b < L::D; ++b) {
      if (!near(rest_moment<L>(unit(a) + unit(b)), cs2 * delta(a, b))) return false;
      for (int c = 0; c < L::D; ++c) {
        if (!near(rest_moment<L>(unit(a) + unit(b) + unit(c)), 0)) return false;
        for (int d = 0; d < L::D; ++d)
          if (!near(rest_moment<L>(unit(a) + unit(b) + unit(c) + unit(d)),
                    cs2 * cs2 *
                        (delta(a, b) * delta(c, d) + delta(a, c) * delta(b, d) +
                         delta(a, d) * delta(b, c))))
            return false;
      }
    }
  for (int i = 0; i < L::Q; ++i) {
    for (int a = 0; a < L::D; ++a) {
      if (L::c(L::opposite(i), a) != -L::c(i, a)) return false;
      if (mirrored<L>(i, a) < 0) return false;
    }
    if (moment_index<L>(L::powers(i)) != i) return false;
  }
  return true;
}

}  // namespace velum::lbm
