// problem:   plane shear between a wall and a lid, n = 12, with the constants a hundred times what
//            is usual; Taylor-Green vortex in the periodic cube (square) of 24 cells at Re = 1600,
//            400 steps, the factor of Vreman's closure renewed every 4 steps. The vortex on each
//            lattice and precision
// reference: the shear is laminar under Vreman's closure and is not under Smagorinsky's; the vortex
//            without an eddy viscosity
// measure:   reported eddy viscosity and momentum that crosses a plane per step; kinetic energy
// tolerance: shear: 1e-9 of nu in the stress, 1e-6 of nu in nu_t; vortex: finite, energy that falls
//            between renewals, 0.2 % to 20 % less of it than without
// why:       in a plane shear but one entry of the gradient is above rounding, which the constant
//            magnifies; the vortex tells only that the closure takes energy out of eddies, an
//            amount of the order of that of nu, and leaves the march stable
#include <gtest/gtest.h>

#include <cmath>

#include "lbm/observe.hpp"
#include "lbm/vreman.hpp"
#include "tests/support/flow.hpp"
#include "tests/support/lattices.hpp"

namespace velum {
namespace {

struct Shear {
  lbm::EddyViscosity reported;
  double viscosity;  // momentum flux through the middle over |du/dy|
};

Shear shear(double nu, double smagorinsky, double vreman)
{
  int const rows = 12;
  double const lid = 0.005;
  lbm::Model model{lbm::Collision::central_moments, nu, 1.0 / 8, smagorinsky};
  model.periodic_x = true;
  auto flow = tests::make_flow(
      lbm::make_fluid<double>(4, rows, {0, 0}, core::Symmetry::planar, model), tests::no_solids(),
      [&](lbm::WallHit const& h) { return h.at[1] > rows / 2.0 ? -2 : -1; });
  flow.wall_velocity = {lid, 0};
  auto const closure = lbm::make_vreman(flow.fluid, vreman);
  for (int t = 0; t < 20000; ++t) {
    if (vreman > 0 && t % 4 == 0) lbm::set_vreman_share(flow.fluid, closure);
    tests::step(flow);
  }
  auto const now = lbm::cell_states(flow.fluid);
  double flux = 0;  // between rows n/2 - 1 and n/2, downwards
  for (int d = 1; d < 9; ++d) {
    int const cy = lbm::D2Q9::cy(d);
    int const cell = flow.fluid.cell(1, cy > 0 ? rows / 2 - 1 : rows / 2);
    if (cy != 0) flux -= lbm::D2Q9::cx(d) * cy * flow.fluid.f.outgoing(d, cell);
  }
  return {lbm::eddy_viscosity(flow.fluid), flux / (now(rows / 2, 1).ux - now(rows / 2 - 1, 1).ux)};
}

TEST(Vreman, LeavesPlaneShearLaminar)
{
  double const nu = 0.02, smagorinsky = 1;
  Shear const without = shear(nu, 1e-9, 0), with = shear(nu, smagorinsky, 2.5);
  EXPECT_NEAR(with.viscosity / without.viscosity, 1, 1e-9);
  EXPECT_LT(with.reported.max, 1e-6 * nu);
  Shear const other = shear(nu, smagorinsky, 0);
  EXPECT_GT(other.viscosity / without.viscosity, 1.01);
  EXPECT_GT(other.reported.mean, 0.01 * nu);
}

template <class F>
double energy(F const& fluid)
{
  auto const now = lbm::cell_states(fluid);
  double sum = 0;
  for (int row = 0; row < fluid.ny * fluid.nz; ++row)
    for (int x = 0; x < fluid.nx; ++x) {
      auto const& s = now(row, x);
      sum += (s.ux * s.ux + s.uy * s.uy + s.uz * s.uz) / 2;
    }
  return sum;
}

/// Share of the energy left after 400 steps.
template <class Format>
double taylor_green(Format, double vreman)
{
  using L = typename Format::L;
  int const n = 24, every = 4, steps = 400;
  double const k = 2 * std::acos(-1.0) / n, u0 = 0.06;
  lbm::Model model{lbm::Collision::central_moments, u0 / (1600 * k), 1.0 / 8, vreman > 0 ? 0.1 : 0};
  model.storage_range = lbm::storage_range_for(1.5 * u0, L::D);
  model.periodic_x = model.periodic_y = model.periodic_z = true;
  auto fluid = lbm::make_fluid<typename Format::Real, L, typename Format::Stored>(
      n, n, {}, core::Symmetry::planar, model, n);
  lbm::CellStates state("state", n * fluid.nz, n);
  for (int row = 0; row < n * fluid.nz; ++row)
    for (int x = 0; x < n; ++x) {
      double const X = k * (x + 0.5), Y = k * (row % n + 0.5);
      double const Z = L::D == 3 ? k * (row / n + 0.5) : 0;
      double const p = u0 * u0 / 16 * (std::cos(2 * X) + std::cos(2 * Y)) * (std::cos(2 * Z) + 2);
      state(row, x) = {L::D == 3 ? 3 * p : 4 * p, u0 * std::sin(X) * std::cos(Y) * std::cos(Z),
                       -u0 * std::cos(X) * std::sin(Y) * std::cos(Z), 0};
    }
  lbm::set_equilibrium(fluid, state);
  double const start = energy(fluid);
  double before = start;
  lbm::Vreman<typename Format::Real> closure;
  if (vreman > 0) closure = lbm::make_vreman(fluid, vreman);
  for (int t = 0; t < steps; t += every) {
    if (vreman > 0) lbm::set_vreman_share(fluid, closure);
    tests::march(fluid, every);
    double const now = energy(fluid);
    // later than the stress of the start, which the equilibrium lacks, takes to form
    if (t > steps / 8) {
      EXPECT_LT(now, before) << Format::name() << " step " << t;
    }
    before = now;
  }
  EXPECT_EQ(lbm::observe(fluid).not_finite, 0) << Format::name();
  return before / start;
}

TEST(Vreman, DampsTheTaylorGreenVortex)
{
  tests::with_each_format([](auto format) {
    double const without = taylor_green(format, 0), with = taylor_green(format, 0.025);
    std::printf("%s: energy left %.5f, without %.5f\n", decltype(format)::name().c_str(), with,
                without);
    EXPECT_LT(with / without, 0.998) << decltype(format)::name();
    EXPECT_GT(with / without, 0.8) << decltype(format)::name();
  });
}

}  // namespace
}  // namespace velum
