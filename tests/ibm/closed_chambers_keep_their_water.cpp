// problem:   a box without openings, parted by a membrane whose middle goes to and fro by up to two
//            cells, in two shapes at once that are out of step, so that it returns by another way
//            than it went; 1000 strokes; planar and axisymmetric, thick and thin, tau - 1/2 from
//            3e-3 to 0.15; double and single precision
// reference: the water of a chamber is what it was: volume by the faces, plus the deviations from
//            rest over its cells, weighted by the rings of their links
// measure:   largest departure at any end of a stroke over the content
// tolerance: 1e-10 in double: 4e5 sums of rounding 1e-16; in single 1e-6 a stroke of 200 steps
//            cannot be told from the rounding of what is stored
// why:       interpolated walls that move, and cells covered and uncovered, keep water to second
//            order only: without a budget 12 such strokes lose 7e-3 of it (ibm/region_mass.hpp)
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/chambers.hpp"

namespace velum {
namespace {

using core::Symmetry;

struct Case {
  Symmetry symmetry;
  double thickness, viscosity;
};

/// Water of both chambers, [0] plus side, [1] minus side.
template <class Real>
std::array<double, 2> content(tests::SharpSceneOf<Real> const& s)
{
  auto const& fluid = s.fluid;
  auto const c = tests::chambers(s);
  auto left = s.body.mass.surplus;
  std::array<double, 2> sum = {c.side[0].volume, c.side[1].volume};
  for (int j = 0; j < fluid.ny; ++j)
    for (int i = 0; i < fluid.nx; ++i) {
      auto const at = s.body.cells.at(i, j);
      if (!ibm::is_fluid(at)) continue;
      for (int d = 0; d < lbm::D2Q9::Q; ++d)
        sum[at == ibm::fluid_plus ? 0 : 1] += lbm::link_ring(fluid.symmetry, j + 0.5, d) *
                                              double(fluid.f.outgoing(d, fluid.cell(i, j)));
    }
  // what the budget has not yet taken back is on its way
  for (std::size_t k = 0; k < s.body.mass.regions.runs.size(); ++k) {
    auto const& run = s.body.mass.regions.runs[k];
    double& surplus = left[std::size_t(run.region)];
    sum[s.body.cells.at(run.first, run.row) == ibm::fluid_plus ? 0 : 1] -= surplus;
    surplus = 0;
  }
  return sum;
}

/// Largest departure of the content over the strokes, relative.
template <class Real>
double drift(Case const& c, int strokes)
{
  int const height = 12, period = 200;
  double const pi = std::acos(-1.0), largest = 2 * 2 * pi / period;  // two cells to either side
  tests::PistonSpec spec{
      .nx = 28, .ny = height, .symmetry = c.symmetry, .place = 14.3, .thickness = c.thickness};
  spec.open = false;
  spec.model.viscosity = c.viscosity;
  auto s = tests::make_piston<Real>(spec);
  auto const shape = tests::clamped_speed(c.symmetry, height);
  auto const before = content(s);
  double worst = 0;
  for (int n = 0; n < strokes; ++n) {
    for (int t = 0; t < period; ++t) {
      double const phase = 2 * pi * (t + 0.5) / period;
      tests::drive(s, [&](double y) {
        double const other = shape(y) * std::sin(3 * pi * y / height);
        return largest * (0.8 * std::sin(phase) * shape(y) + 0.3 * std::cos(2 * phase) * other);
      });
      ibm::step(s);
    }
    auto const now = content(s);
    for (int k : {0, 1})
      worst = std::max(worst, std::abs(now[std::size_t(k)] / before[std::size_t(k)] - 1));
  }
  return worst;
}

TEST(ClosedChamber, KeepsItsWaterOverAThousandStrokes)
{
  for (Case const& c :
       {Case{Symmetry::planar, 2, 0.05}, Case{Symmetry::planar, 0.01, 0.001},
        Case{Symmetry::axisymmetric, 2, 0.001}, Case{Symmetry::axisymmetric, 0.01, 0.05}})
    EXPECT_LT(drift<double>(c, 1000), 1e-10)
        << int(c.symmetry) << " h " << c.thickness << " nu " << c.viscosity;
}

TEST(ClosedChamber, KeepsItsWaterInSinglePrecision)
{
  EXPECT_LT(drift<float>({Symmetry::planar, 2, 0.01}, 100), 1e-6);
  EXPECT_LT(drift<float>({Symmetry::axisymmetric, 2, 0.01}, 100), 1e-6);
}

}  // namespace
}  // namespace velum
