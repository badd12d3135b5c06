#include "lbm/observe.hpp"

#include <cmath>

#include "lbm/moments.hpp"

namespace velum::lbm {

namespace {

struct Speed {
  double squared, rho;
  bool finite;
};

template <class Real>
KOKKOS_FORCEINLINE_FUNCTION Speed speed(Populations<Real> const& f, int i, int j)
{
  Real site[9], rho, jx, jy;
  for (int d = 0; d < 9; ++d) site[d] = f(d, j + 1, i + 1);
  density_and_momentum(site, rho, jx, jy);
  double const u2 = (double(jx) * jx + double(jy) * jy) / ((1.0 + rho) * (1.0 + rho));
  // a comparison with NaN is false, so this also catches what is not a number
  bool const finite = u2 < 1e30 && double(rho) > -1 && double(rho) < 1e30;
  return {finite ? u2 : 1e60, double(rho), finite};
}

/// Relaxation time that smagorinsky_rate() chose, from the deviator it left behind: collision
/// turns Pi into (1 - 1/tau) Pi, so that
///   (tau - tau0) |tau - 1| = 9/2 C^2 |(1 - 1/tau) Pi| / rho.
/// Of the roots that which grows from tau0; where tau0 < 1 it ends at nu_t = (1 - tau0)/6, far
/// above any strain the lattice can bear.
KOKKOS_FORCEINLINE_FUNCTION double smagorinsky_time(double tau0, double magnitude,
                                                    double constant_squared)
{
  double const a = 18 * constant_squared * magnitude, d = (1 - tau0) * (1 - tau0);
  if (tau0 >= 1) return (1 + tau0 + std::sqrt(d + a)) / 2;
  return (1 + tau0 - std::sqrt(d > a ? d - a : 0)) / 2;
}

}  // namespace

template <class Real>
Observation observe(Fluid<Real> const& fluid)
{
  int const nx = fluid.nx;
  auto const f = fluid.f;
  auto const active = fluid.active;
  auto const symmetry = fluid.symmetry;
  double const y0 = fluid.origin[1];
  long const cells = long(fluid.nx) * fluid.ny;

  Observation seen;
  double rho_min = 0, rho_max = 0, mass = 0;
  long count = 0, not_finite = 0;
  Kokkos::parallel_reduce(
      "velum::lbm::observe", Kokkos::RangePolicy<>(0, cells),
      KOKKOS_LAMBDA(long c, double& lo, double& hi, double& m, long& n, long& bad) {
        int const j = int(c / nx), i = int(c % nx);
        if (!active(j + 1, i + 1)) return;
        Speed const s = speed(f, i, j);
        n += 1;
        bad += s.finite ? 0 : 1;
        if (!s.finite) return;
        if (s.rho < lo) lo = s.rho;
        if (s.rho > hi) hi = s.rho;
        m += core::ring(symmetry, y0 + j + 0.5) * s.rho;
      },
      Kokkos::Min<double>(rho_min), Kokkos::Max<double>(rho_max), mass, count, not_finite);
  seen.cells = count;
  if (count == 0) return seen;

  using Worst = Kokkos::MaxLoc<double, long>;
  Worst::value_type fastest;
  Kokkos::parallel_reduce(
      "velum::lbm::fastest_cell", Kokkos::RangePolicy<>(0, cells),
      KOKKOS_LAMBDA(long c, Worst::value_type& worst) {
        int const j = int(c / nx), i = int(c % nx);
        if (!active(j + 1, i + 1)) return;
        double const u2 = speed(f, i, j).squared;
        if (u2 > worst.val) {
          worst.val = u2;
          worst.loc = c;
        }
      },
      Worst(fastest));
  seen.speed_max = std::sqrt(fastest.val);
  seen.worst_i = int(fastest.loc % nx);
  seen.worst_j = int(fastest.loc / nx);
  seen.rho_min = rho_min;
  seen.rho_max = rho_max;
  seen.mass = mass;
  seen.not_finite = not_finite;
  return seen;
}

template <class Real>
EddyViscosity eddy_viscosity(Fluid<Real> const& fluid)
{
  int const nx = fluid.nx;
  auto const f = fluid.f;
  auto const active = fluid.active;
  double const tau0 = 1 / fluid.model.omega();
  double const c2 = fluid.model.smagorinsky * fluid.model.smagorinsky;
  if (c2 == 0) return {};
  double sum = 0, max = 0;
  long count = 0;
  Kokkos::parallel_reduce(
      "velum::lbm::eddy_viscosity", Kokkos::RangePolicy<>(0, long(fluid.nx) * fluid.ny),
      KOKKOS_LAMBDA(long c, double& total, double& largest, long& n) {
        int const j = int(c / nx), i = int(c % nx);
        if (!active(j + 1, i + 1)) return;
        double site[9];
        for (int d = 0; d < 9; ++d) site[d] = double(f(d, j + 1, i + 1));
        Moments<double> const m = moments(site);
        double const rho = 1 + m.rho, ux = m.jx / rho, uy = m.jy / rho;
        double const N = m.N - rho * (ux * ux - uy * uy), P = m.Pxy - rho * ux * uy;
        double const tau = smagorinsky_time(tau0, std::sqrt(N * N + 4 * P * P) / rho, c2);
        double const nu_t = (tau - tau0) / 3;
        total += nu_t;
        if (nu_t > largest) largest = nu_t;
        n += 1;
      },
      sum, Kokkos::Max<double>(max), count);
  return {count ? sum / double(count) : 0, max > 0 ? max : 0};
}

template Observation observe(Fluid<float> const&);
template Observation observe(Fluid<double> const&);
template EddyViscosity eddy_viscosity(Fluid<float> const&);
template EddyViscosity eddy_viscosity(Fluid<double> const&);

}  // namespace velum::lbm
