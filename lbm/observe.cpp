#include "lbm/observe.hpp"

#include <cmath>

#include "lbm/formats.hpp"
#include "lbm/smagorinsky.hpp"

namespace velum::lbm {

namespace {

struct Speed {
  double squared, rho;
  bool finite;
};

template <class Real, class L, class Stored>
KOKKOS_FORCEINLINE_FUNCTION Speed speed(Fluid<Real, L, Stored> const& fluid, int cell)
{
  Real site[L::Q], rho;
  core::Vec<Real, L::D> j;
  for (int d = 0; d < L::Q; ++d) site[d] = fluid.f.outgoing(d, cell);
  density_and_momentum<L>(site, rho, j);
  double j2 = 0;
  for (int a = 0; a < L::D; ++a) j2 += double(j[a]) * double(j[a]);
  double const u2 = j2 / ((1.0 + rho) * (1.0 + rho));
  // a comparison with NaN is false, so this also catches what is not a number
  bool const finite = u2 < 1e30 && double(rho) > -1 && double(rho) < 1e30;
  return {finite ? u2 : 1e60, double(rho), finite};
}

/// Relaxation time that smagorinsky_time() chose, from the deviator it left behind: collision
/// turns Pi into (1 - 1/tau) Pi, so that
///   (tau - tau0) |tau - 1| = 9/2 C^2 |(1 - 1/tau) Pi| / rho.
/// Of the roots that which grows from tau0; where tau0 < 1 it ends at nu_t = (1 - tau0)/6, far
/// above any strain the lattice can bear.
KOKKOS_FORCEINLINE_FUNCTION double time_after(double tau0, double magnitude,
                                              double constant_squared)
{
  double const a = 18 * constant_squared * magnitude, d = (1 - tau0) * (1 - tau0);
  if (tau0 >= 1) return (1 + tau0 + std::sqrt(d + a)) / 2;
  return (1 + tau0 - std::sqrt(d > a ? d - a : 0)) / 2;
}

}  // namespace

template <class Real, class L, class Stored>
Observation observe(Fluid<Real, L, Stored> const& fluid)
{
  Fluid<Real, L, Stored> const from = fluid;
  long const cells = fluid.cells();

  Observation seen;
  double rho_min = 0, rho_max = 0, mass = 0, squares = 0, largest = 0;
  long count = 0, not_finite = 0, clipped = 0;
  Kokkos::parallel_reduce(
      "velum::lbm::observe", Kokkos::RangePolicy<>(0, cells),
      KOKKOS_LAMBDA(long c, double& lo, double& hi, double& m, double& u2, long& n, long& bad,
                    long& clip, double& fastest) {
        int const cell = from.cell_of(c);
        if (!from.active(cell)) return;
        Speed const s = speed(from, cell);
        n += 1;
        bad += s.finite ? 0 : 1;
        if (s.squared > fastest) fastest = s.squared;
        if constexpr (Populations<Real, L, Stored>::fixed_point)
          for (int d = 0; d < L::Q; ++d) {
            int const stored = from.f.slots(d, cell);
            if (stored >= 32767 || stored <= -32767) clip += 1;
          }
        if (!s.finite) return;
        if (s.rho < lo) lo = s.rho;
        if (s.rho > hi) hi = s.rho;
        u2 += s.squared;
        m += core::ring(from.symmetry, from.origin[1] + int(c / from.nx) % from.ny + 0.5) * s.rho;
      },
      Kokkos::Min<double>(rho_min), Kokkos::Max<double>(rho_max), mass, squares, count, not_finite,
      clipped, Kokkos::Max<double>(largest));
  seen.cells = count;
  if (count == 0) return seen;

  seen.speed_max = std::sqrt(largest);
  seen.speed_squared_mean = squares / double(count);
  seen.rho_min = rho_min;
  seen.rho_max = rho_max;
  seen.mass = mass;
  seen.not_finite = not_finite;
  seen.clipped = clipped > 0;
  return seen;
}

template <class Real, class L, class Stored>
CellPlace worst_cell(Fluid<Real, L, Stored> const& fluid)
{
  Fluid<Real, L, Stored> const from = fluid;
  using Worst = Kokkos::MaxLoc<double, long>;
  Worst::value_type fastest;
  Kokkos::parallel_reduce(
      "velum::lbm::worst_cell", Kokkos::RangePolicy<>(0, fluid.cells()),
      KOKKOS_LAMBDA(long c, Worst::value_type& worst) {
        int const cell = from.cell_of(c);
        if (!from.active(cell)) return;
        double const u2 = speed(from, cell).squared;
        if (u2 > worst.val) {
          worst.val = u2;
          worst.loc = c;
        }
      },
      Worst(fastest));
  return {int(fastest.loc % fluid.nx), int(fastest.loc / fluid.nx % fluid.ny),
          int(fastest.loc / fluid.nx / fluid.ny)};
}

template <class Real, class L, class Stored>
EddyViscosity eddy_viscosity(Fluid<Real, L, Stored> const& fluid)
{
  Fluid<Real, L, Stored> const from = fluid;
  double const tau0 = 1 / fluid.model.omega();
  double const c2 = fluid.model.smagorinsky * fluid.model.smagorinsky;
  if (c2 == 0) return {};
  double sum = 0, max = 0;
  long count = 0;
  Kokkos::parallel_reduce(
      "velum::lbm::eddy_viscosity", Kokkos::RangePolicy<>(0, fluid.cells()),
      KOKKOS_LAMBDA(long c, double& total, double& largest, long& n) {
        int const cell = from.cell_of(c);
        if (!from.active(cell)) return;
        double site[L::Q];
        for (int d = 0; d < L::Q; ++d) site[d] = double(from.f.outgoing(d, cell));
        auto const m = moments<L>(site);
        double const rho = 1 + m.rho();
        core::Vec<double, L::D> u;
        for (int a = 0; a < L::D; ++a) u[a] = m.j(a) / rho;
        double const tau = time_after(tau0, deviator_magnitude(m, rho, u) / rho,
                                      double(from.eddy_share(cell)) * c2);
        double const nu_t = (tau - tau0) / 3;
        total += nu_t;
        if (nu_t > largest) largest = nu_t;
        n += 1;
      },
      sum, Kokkos::Max<double>(max), count);
  return {count ? sum / double(count) : 0, max > 0 ? max : 0};
}

#define VELUM_INSTANTIATE(Real, L, Stored)                      \
  template CellPlace worst_cell(Fluid<Real, L, Stored> const&); \
  template Observation observe(Fluid<Real, L, Stored> const&);  \
  template EddyViscosity eddy_viscosity(Fluid<Real, L, Stored> const&);
VELUM_EACH_FLUID(VELUM_INSTANTIATE)
#undef VELUM_INSTANTIATE

}  // namespace velum::lbm
