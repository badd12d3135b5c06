// problem:   linear flows u = G^T x in a box of walls, 8 cells a side, of a density that varies
//            from cell to cell: a y, b z, c x along x, y, z; strain; strain and rotation; a full
//            gradient; after an even and an odd number of steps; plane shear along every pair of
//            axes; a solid cell and a body's two sides in the box; a rotation with hardly any
//            strain; an arbitrary flow that mirrors and an axis bound. Each lattice and precision
// reference: Vreman's formula in the form of his paper (Phys. Fluids 16 (2004) 3670), from the 3 x
//            3 tensor, out of plane zero; zero in plane shear and beside what is no fluid; the
//            same flow in a periodic box of twice the size, begun at two places, so that each of
//            the planes lies once amid the cells
// measure:   nu_t = factor C^2 |S|, |S| of the deviator, which is what the step makes of the
//            factor
// tolerance: nu_t: 4 times the rounding of a population over |G|, and 1e-6, of C_V |G|; images:
//            1e-5 in double, 1e-3 in single and 16-bit storage; zeros: bitwise
// why:       differences of a linear flow are exact, so what is left is rounding: of the factor,
//            kept in single precision, and of populations, whose sum a gradient divides by |G|;
//            ratios of differences of an arbitrary flow magnify it
#include <gtest/gtest.h>

#include <cmath>

#include "core/check.hpp"
#include "lbm/vreman.hpp"
#include "tests/support/lattices.hpp"

namespace velum {
namespace {

struct Tensor {
  double g[3][3];  // d u_b / d x_a
};

/// The part that a lattice of D dimensions sees.
Tensor within(Tensor t, int D)
{
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      if (a >= D || b >= D) t.g[a][b] = 0;
  return t;
}

double magnitude(Tensor const& t)
{
  double sum = 0;
  for (auto const& row : t.g)
    for (double x : row) sum += x * x;
  return std::sqrt(sum);
}

double strain(Tensor const& t, int D)
{
  double sum = 0, trace = 0;
  for (int a = 0; a < D; ++a) trace += t.g[a][a];
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) {
      double const s = (t.g[a][b] + t.g[b][a]) / 2 - (a == b ? trace / D : 0);
      sum += 2 * s * s;
    }
  return std::sqrt(sum);
}

double vreman(Tensor const& t, double constant)
{
  double b[3][3] = {};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int m = 0; m < 3; ++m) b[i][j] += t.g[m][i] * t.g[m][j];
  double const B = b[0][0] * b[1][1] - b[0][1] * b[0][1] + b[0][0] * b[2][2] - b[0][2] * b[0][2] +
                   b[1][1] * b[2][2] - b[1][2] * b[1][2];
  return constant * std::sqrt(std::max(B, 0.0)) / magnitude(t);
}

/// Equilibrium of the state that at(i, j, k) gives.
template <class F, class At>
void set(F& fluid, At const& at)
{
  lbm::CellStates state("state", fluid.ny * fluid.nz, fluid.nx);
  for (int k = 0; k < fluid.nz; ++k)
    for (int j = 0; j < fluid.ny; ++j)
      for (int i = 0; i < fluid.nx; ++i) state(k * fluid.ny + j, i) = at(i, j, k);
  lbm::set_equilibrium(fluid, state);
}

template <class F>
auto shares(F& fluid, double constant = 0.025)
{
  lbm::set_vreman_share(fluid, lbm::make_vreman(fluid, constant));
  auto const host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), fluid.eddy_share);
  return [host, fluid](int i, int j, int k = 0) { return double(host(fluid.cell(i, j, k))); };
}

constexpr int n = 8;
constexpr double fastest = 0.2;

lbm::Model eddying(int dimensions, double smagorinsky = 0.1)
{
  lbm::Model model{lbm::Collision::central_moments, 1e-3, 1.0 / 8, smagorinsky};
  model.storage_range = lbm::storage_range_for(fastest, dimensions);
  return model;
}

template <class Format>
auto make_box(Format, lbm::Model const& model)
{
  return lbm::make_fluid<typename Format::Real, typename Format::L, typename Format::Stored>(
      n, n, {}, core::Symmetry::planar, model, n);
}

/// Linear flow around the middle of the box.
template <class F>
void set_linear(F& fluid, Tensor const& t)
{
  set(fluid, [&](int i, int j, int k) {
    double const x[3] = {i + 0.5 - n / 2, j + 0.5 - n / 2, fluid.nz > 1 ? k + 0.5 - n / 2 : 0};
    double u[3] = {};
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) u[b] += t.g[a][b] * x[a];
    return lbm::CellState{0.02 * std::sin(i + 2.0 * j + 3.0 * k), u[0], u[1], u[2]};
  });
}

template <class Format>
double tolerance(Format, lbm::Model const& model, Tensor const& t)
{
  double const range = std::is_integral_v<typename Format::Stored> ? model.storage_range / 4 : 1;
  return 1e-6 + 4 * Format::rounding() * range / magnitude(t);
}

std::vector<Tensor> gradients()
{
  double const a = 0.01, b = 0.02, c = 0.015;
  return {{{{0, 0, c}, {a, 0, 0}, {0, b, 0}}},      {{{a, 0, 0}, {0, -a, 0}, {0, 0, 0}}},
          {{{-2 * a, 0, 0}, {0, a, 0}, {0, 0, a}}}, {{{a, b, 0}, {-b, -a, 0}, {0, 0, 0}}},
          {{{a, b, c}, {-c, b, a}, {b, -a, -c}}},   {{{0, c, 0}, {a, 0, b}, {0, -a, 0}}}};
}

bool at_side(int i, int size) { return i == 0 || i == size - 1; }

template <class F, class Check>
void each_cell(F const& fluid, Check const& check)
{
  for (int k = 0; k < fluid.nz; ++k)
    for (int j = 0; j < fluid.ny; ++j)
      for (int i = 0; i < fluid.nx; ++i) check(i, j, k);
}

template <class Format>
void expect_formula(Format format, Tensor const& t, double smagorinsky, bool turned)
{
  constexpr int D = Format::L::D;
  double const constant = 0.03;
  auto const model = eddying(D, smagorinsky);
  auto fluid = make_box(format, model);
  fluid.f.step = turned;
  set_linear(fluid, t);
  auto const share = shares(fluid, constant);
  double const near = constant * magnitude(t) * tolerance(format, model, t);
  each_cell(fluid, [&](int i, int j, int k) {
    if (at_side(i, n) || at_side(j, n) || (D == 3 && at_side(k, n)))
      ASSERT_EQ(share(i, j, k), 0) << Format::name();
    else
      ASSERT_NEAR(share(i, j, k) * smagorinsky * smagorinsky * strain(t, D), vreman(t, constant),
                  near)
          << Format::name() << " at " << i << " " << j << " " << k;
  });
}

TEST(Vreman, GivesTheViscosityOfItsFormulaAndNoneAtWalls)
{
  tests::with_each_format([](auto format) {
    for (Tensor const& t : gradients())
      for (double smagorinsky : {0.1, 0.3})
        for (bool turned : {false, true})
          expect_formula(format, within(t, decltype(format)::L::D), smagorinsky, turned);
  });
}

TEST(Vreman, VanishesInPlaneShearWhereSmagorinskyDoesNot)
{
  tests::with_each_format([](auto format) {
    using Format = decltype(format);
    constexpr int D = Format::L::D;
    auto const model = eddying(D);
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b) {
        if (a == b) continue;
        Tensor t{};
        t.g[a][b] = 0.02;
        auto fluid = make_box(format, model);
        set_linear(fluid, t);
        ASSERT_EQ(fluid.eddy_share(fluid.cell(2, 2)), 1) << "Smagorinsky's own";
        auto const share = shares(fluid);
        // of Smagorinsky's viscosity, which has C_V = 5/2 C^2
        each_cell(fluid, [&](int i, int j, int k) {
          ASSERT_LE(share(i, j, k), 2.5 * tolerance(format, model, t)) << Format::name();
        });
      }
  });
}

TEST(Vreman, SparesTheCellsBesideSolidsAndBodies)
{
  tests::with_each_format([](auto format) {
    using Format = decltype(format);
    constexpr int D = Format::L::D;
    auto fluid = make_box(format, eddying(D));
    int const s = 3, z = D == 3 ? s : 0, face = 5;  // a solid cell; the body's plane before i = 5
    std::vector<std::uint8_t> mask;
    each_cell(fluid, [&](int i, int j, int k) {
      mask.push_back(i == s && j == s && k == z ? 0 : i < face ? 1 : 2);
    });
    lbm::mark(fluid, mask);
    set_linear(fluid, within(gradients()[4], D));
    auto const share = shares(fluid);
    each_cell(fluid, [&](int i, int j, int k) {
      int const away = std::abs(i - s) + std::abs(j - s) + std::abs(k - z);
      bool const side = at_side(i, n) || at_side(j, n) || (D == 3 && at_side(k, n));
      bool const spared = side || away <= 1 || i == face - 1 || i == face;
      ASSERT_EQ(share(i, j, k) == 0, spared) << Format::name() << " " << i << " " << j << " " << k;
    });
  });
}

TEST(Vreman, IsBoundedWhereThereIsHardlyAnyStrain)
{
  double const turn = 0.02, constant = 0.025;
  for (double rate : {0.0, 1e-12, 1e-6, 1e-4}) {
    Tensor const t{{{rate, turn, 0}, {-turn, -rate, 0}, {0, 0, 0}}};
    auto fluid = make_box(tests::Format<lbm::D3Q19, double, double>{}, eddying(3));
    set_linear(fluid, t);
    double const nu_t = shares(fluid, constant)(3, 3, 3) * 0.01 * strain(t, 3);
    EXPECT_NEAR(nu_t, 10 * constant * strain(t, 3), 1e-6 * constant * turn) << rate;
    EXPECT_LE(nu_t, vreman(t, constant));
  }
}

TEST(Vreman, IsZeroInAFluidAtRestOrOutOfNumbers)
{
  tests::with_each_format([](auto format) {
    using Format = decltype(format);
    for (double u : {0.0, std::nan("")}) {
      if (u != 0 && std::is_integral_v<typename Format::Stored>) continue;
      auto fluid = make_box(format, eddying(Format::L::D));
      set(fluid, [&](int, int, int) { return lbm::CellState{0, u, u, u}; });
      auto const share = shares(fluid);
      each_cell(fluid, [&](int i, int j, int k) { ASSERT_EQ(share(i, j, k), 0); });
    }
  });
}

/// Number between -1 and 1, as good as random.
double noise(int seed)
{
  double const x = std::sin(12.9898 * seed + 4.1) * 43758.5453;
  return 2 * (x - std::floor(x)) - 1;
}

constexpr int half[3] = {5, 4, 3};

/// An arbitrary flow, symmetric about the planes 0 and half of every axis.
lbm::CellState mirrored_flow(int i, int j, int k)
{
  int at[3] = {i, j, k};
  double sign[3] = {1, 1, 1};
  for (int a = 0; a < 3; ++a)
    if ((at[a] %= 2 * half[a]) >= half[a]) {
      at[a] = 2 * half[a] - 1 - at[a];
      sign[a] = -1;
    }
  int const seed = 3 * (at[0] + half[0] * (at[1] + half[1] * at[2]));
  return {0, 0.05 * sign[0] * noise(seed), 0.05 * sign[1] * noise(seed + 1),
          0.05 * sign[2] * noise(seed + 2)};
}

template <class Format>
void expect_images(Format, lbm::Model const& bounded, core::Symmetry symmetry)
{
  using Real = typename Format::Real;
  using L = typename Format::L;
  using Stored = typename Format::Stored;
  double const near = sizeof(Stored) == 8 ? 1e-5 : 1e-3;
  auto fluid = lbm::make_fluid<Real, L, Stored>(half[0], half[1], {}, symmetry, bounded, half[2]);
  set(fluid, mirrored_flow);
  auto const share = shares(fluid);
  lbm::Model model = eddying(L::D);
  model.periodic_x = model.periodic_y = model.periodic_z = true;
  for (bool late : {false, true}) {
    auto whole = lbm::make_fluid<Real, L, Stored>(2 * half[0], 2 * half[1], {},
                                                  core::Symmetry::planar, model, 2 * half[2]);
    int const x = late ? half[0] : 0, y = late ? half[1] : 0, z = late && L::D == 3 ? half[2] : 0;
    set(whole, [&](int i, int j, int k) { return mirrored_flow(i + x, j + y, k + z); });
    auto const expected = shares(whole);
    each_cell(fluid, [&](int i, int j, int k) {
      double const e = expected(i + x, j + y, k + z);
      ASSERT_GT(e, 0);
      ASSERT_NEAR(share(i, j, k) / e, 1, near)
          << Format::name() << " at " << i << " " << j << " " << k;
    });
  }
}

TEST(Vreman, SeesThroughMirrorsPeriodicSidesAndTheAxis)
{
  tests::with_each_format([](auto format) {
    lbm::Model model = eddying(decltype(format)::L::D);
    model.mirrors = 0b111111;
    expect_images(format, model, core::Symmetry::planar);
    if constexpr (decltype(format)::L::D == 2) {
      model.mirrors &= ~lbm::mirror(1, false);
      expect_images(format, model, core::Symmetry::axisymmetric);
    }
  });
}

TEST(Vreman, NeedsASmagorinskyConstantToActThrough)
{
  auto const fluid = make_box(tests::Format<lbm::D2Q9, double, double>{}, eddying(2, 0));
  EXPECT_THROW(lbm::make_vreman(fluid), core::InputError);
}

}  // namespace
}  // namespace velum
