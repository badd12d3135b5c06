// problem:   the 4-point delta at any place in a cell, in the bulk, over the axis, beside a wall,
//            across a periodic side; random velocities and marker forces
// reference: Peskin's conditions: sum 1 (odd and even cells 1/2 each), no first moment, sum of
//            squares 3/8; and the identities of a spreading that is the adjoint of interpolating:
//            sum ring f_x = sum F_x, sum ring u.f = sum U.F; a constant velocity is read as it is
// measure:   difference, relative
// tolerance: 1e-13
// why:       all of these hold exactly; only round-off of a few hundred terms is left
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "ibm/stencil.hpp"
#include "lbm/moments.hpp"

namespace velum {
namespace {

using core::Symmetry;
using core::Vec2;
using ibm::Peskin4;

TEST(Delta, MeetsPeskinsConditionsEverywhereInACell)
{
  for (int k = 0; k <= 1000; ++k) {
    double const X = k / 1000.0;
    double even = 0, odd = 0, first = 0, squares = 0;
    for (int x = -3; x <= 4; ++x) {
      double const phi = Peskin4::phi(x - X);
      (x % 2 == 0 ? even : odd) += phi;
      first += (x - X) * phi;
      squares += phi * phi;
    }
    EXPECT_NEAR(even, 0.5, 1e-14) << X;
    EXPECT_NEAR(odd, 0.5, 1e-14) << X;
    EXPECT_NEAR(first, 0, 1e-14) << X;
    EXPECT_NEAR(squares, 0.375, 1e-14) << X;
  }
}

constexpr int nx = 14, ny = 12, solid_rows = 3, markers = 200;

/// Fluid with a solid in its top rows, random velocities of density 1 below.
struct Bench {
  lbm::Fluid<double> fluid;
  lbm::CellStates state{"state", ny, nx};
  ibm::MarkerField X{"X", 2, markers}, U{"U", 4, markers}, F{"F", 2, markers};
  ibm::Stencils stencils{"stencils", markers};
  std::mt19937 random{7};

  double draw(double lo, double hi)
  {
    return std::uniform_real_distribution<double>(lo, hi)(random);
  }
};

/// The populations that arrive at every cell are the equilibrium of its state.
void set_arriving(Bench& b)
{
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i)
      for (int d = 0; d < 9; ++d) {
        auto const& s = b.state(j, i);
        b.fluid.f.set_arriving(d, b.fluid.cell(i, j),
                               lbm::equilibrium<lbm::D2Q9>(d, s.rho, core::Vec2{s.ux, s.uy}));
      }
}

Bench make_bench(Symmetry symmetry, bool constant)
{
  lbm::Model model;
  model.periodic_x = true;
  Bench b{.fluid = lbm::make_fluid<double>(nx, ny, {0, 0}, symmetry, model)};
  lbm::use_force_field(b.fluid);
  std::vector<std::uint8_t> mask;
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      b.state(j, i) = {0, constant ? 0.01 : b.draw(-0.02, 0.02),
                       constant ? 0 : b.draw(-0.02, 0.02)};
      mask.push_back(j < ny - solid_rows);
    }
  lbm::mark(b.fluid, mask);
  set_arriving(b);
  auto const X = Kokkos::create_mirror_view(b.X);
  auto const F = Kokkos::create_mirror_view(b.F);
  for (int k = 0; k < markers; ++k) {
    X(0, k) = b.draw(0, nx);
    X(1, k) = b.draw(0, ny - solid_rows);  // up to the face of the solid
    for (int d : {0, 1}) F(d, k) = b.draw(-1, 1);
  }
  Kokkos::deep_copy(b.X, X);
  Kokkos::deep_copy(b.F, F);
  ibm::locate(b.fluid, b.X, b.stencils, markers);
  ibm::interpolate(b.fluid, b.stencils, b.U, markers);
  ibm::spread(b.fluid, b.stencils, b.F, markers);
  return b;
}

TEST(Delta, SpreadingIsTheAdjointOfInterpolating)
{
  for (auto symmetry : {Symmetry::planar, Symmetry::axisymmetric}) {
    Bench b = make_bench(symmetry, false);
    auto const U = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), b.U);
    auto const F = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), b.F);
    auto const f = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), b.fluid.force);
    double given = 0, got = 0, power_at_markers = 0, power_in_cells = 0;
    for (int k = 0; k < markers; ++k) {
      given += F(0, k);
      power_at_markers += U(0, k) * F(0, k) + U(1, k) * F(1, k);
    }
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        double const ring = core::ring(symmetry, j + 0.5);
        got += ring * f(0, b.fluid.cell(i, j));
        power_in_cells += ring * (b.state(j, i).ux * f(0, b.fluid.cell(i, j)) +
                                  b.state(j, i).uy * f(1, b.fluid.cell(i, j)));
        if (j >= ny - solid_rows) {
          EXPECT_EQ(f(0, b.fluid.cell(i, j)), 0);
        }
      }
    EXPECT_NEAR(got, given, 1e-13 * markers);
    EXPECT_NEAR(power_in_cells, power_at_markers, 1e-13 * markers);
    EXPECT_GT(std::abs(power_at_markers), 1e-3);  // the identity is not 0 = 0
  }
}

TEST(Delta, ReadsAConstantVelocityBesideWallsAndOverTheAxis)
{
  for (auto symmetry : {Symmetry::planar, Symmetry::axisymmetric}) {
    Bench b = make_bench(symmetry, true);
    auto const U = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), b.U);
    for (int k = 0; k < markers; ++k) {
      EXPECT_NEAR(U(0, k), 0.01, 1e-15);
      EXPECT_NEAR(U(2, k), 1, 1e-14);
    }
  }
}

}  // namespace
}  // namespace velum
