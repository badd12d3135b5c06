// problem:   decaying shear wave with velocity along the last direction of the lattice and wave
//            vector along x, at rest and carried by a mean flow U along x, in a periodic strip of
//            n cells; each lattice, collision and precision
// reference: amplitude ~ exp(-nu k^2 t), phase k U t
// measure:   complex amplitude of the first Fourier mode: viscosity from its modulus, speed from
//            its phase; their errors over n = 16, 32, 64 (time scaled with n^2, U with 1/n)
// tolerance: order 2 or better: above 1.8 on the finest pair of double precision; viscosity within
//            1 % and carrier within 0.5 % at n = 64 in every precision
// why:       the scheme is second order in this scaling; cumulants with parametrised rates are of
//            fourth order, so only a lower bound is asked. 16-bit storage rounds to 2e-5 of the
//            weight here, up to 1 % of the part of a population that carries the stress
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "tests/support/lattices.hpp"

namespace velum {
namespace {

struct Errors {
  double viscosity, speed;
};

template <class Format>
Errors wave(Format, lbm::Collision collision, int n)
{
  using L = typename Format::L;
  double const nu = 0.02, pi = std::acos(-1.0), k = 2 * pi / n;
  double const U = 3.2 / n, amplitude = 1.6 / n;
  lbm::Model model{collision, nu, 1.0 / 8};
  model.storage_range = lbm::storage_range_for(U + amplitude, L::D);
  model.periodic_x = model.periodic_y = model.periodic_z = true;
  auto fluid = lbm::make_fluid<typename Format::Real, L, typename Format::Stored>(
      n, 3, {}, core::Symmetry::planar, model, 3);
  lbm::CellStates state("state", 3 * fluid.nz, n);
  for (int row = 0; row < 3 * fluid.nz; ++row)
    for (int i = 0; i < n; ++i) {
      double const wave = amplitude * std::cos(k * (i + 0.5));
      state(row, i) = {0, U, L::D == 2 ? wave : 0, L::D == 3 ? wave : 0};
    }
  lbm::set_equilibrium(fluid, state);
  auto const mode = [&] {
    auto const now = lbm::cell_states(fluid);
    std::complex<double> sum = 0;
    for (int row = 0; row < 3 * fluid.nz; ++row)
      for (int i = 0; i < n; ++i)
        sum += (L::D == 2 ? now(row, i).uy : now(row, i).uz) *
               std::exp(std::complex<double>(0, -k * (i + 0.5)));
    return sum;
  };
  tests::march(fluid, n * n / 16);  // the stress of the start, which the equilibrium lacks, forms
  auto const before = mode();
  int const steps = n * n / 4;
  tests::march(fluid, steps);
  auto const ratio = mode() / before;
  // the phase is known up to whole turns, of which the reference makes nearly all
  double turn = -std::arg(ratio) - k * U * steps;
  turn -= 2 * pi * std::round(turn / (2 * pi));
  return {std::abs(std::log(std::abs(ratio)) / (-k * k * steps) / nu - 1),
          std::abs(turn / (k * U * steps))};
}

TEST(ShearWave, DecaysAndTravelsRightOnEachLattice)
{
  tests::with_each_format([](auto format) {
    using Format = decltype(format);
    for (auto c : tests::collisions<typename Format::L>()) {
      Errors const e = wave(format, c, 64);
      EXPECT_LT(e.viscosity, 0.01) << Format::name() << " collision " << int(c);
      EXPECT_LT(e.speed, 0.005) << Format::name() << " collision " << int(c);
    }
  });
}

TEST(ShearWave, IsOfSecondOrder)
{
  tests::with_each_format([](auto format) {
    using Format = decltype(format);
    if constexpr (sizeof(typename Format::Stored) == 8)
      for (auto c : tests::collisions<typename Format::L>()) {
        Errors const coarse = wave(format, c, 16), fine = wave(format, c, 32);
        std::string const name = Format::name() + " collision " + std::to_string(int(c));
        EXPECT_GT(std::log2(coarse.viscosity / fine.viscosity), 1.8) << name;
        EXPECT_GT(std::log2(coarse.speed / fine.speed), 1.8) << name;
      }
  });
}

}  // namespace
}  // namespace velum
