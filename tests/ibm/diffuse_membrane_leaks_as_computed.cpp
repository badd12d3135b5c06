// problem:   a flat diffuse membrane held at rest between a higher and a lower pressure, at five
//            places in a cell, its faces 6, 4, 2 and 0 cells apart
// reference: one pass of forcing stops the fluid but for the slip that its own force leaves. With
//            dp/2 on each face and c(h) = sum phi(x) phi(x - h), at a marker
//            dp/2 = 2 rho (u - (3/8 + c) (dp/2) / 2 rho):  u = (5/8 - c) dp / 4 rho,
//            dp / 6.4 rho where the faces are 4 or more apart; one face alone: dp / 3.2 rho
// measure:   volume flow per area through the opening; the ledger's leak through the membrane
// tolerance: 0.5 %; the ledger 1e-3
// why:       the formula is that of the discrete equations; compressibility enters with dp squared,
//            and a little sound still rings between the stiffest membranes and the openings
#include <gtest/gtest.h>

#include "tests/ibm/diffuse_box.hpp"

namespace velum {
namespace {

double overlap(double X, double h)
{
  double sum = 0;
  for (int x = -4; x <= 12; ++x) sum += ibm::Peskin4::phi(x - X) * ibm::Peskin4::phi(x - X - h);
  return sum;
}

TEST(DiffuseMembrane, LeaksAsComputed)
{
  constexpr double dp = 0.006;
  for (double h : {6.0, 4.0, 2.0, 1e-3})
    for (double shift : {0.0, 0.2, 0.4, 0.6, 0.8}) {
      tests::PistonSpec spec{.nx = 24, .ny = 4, .place = 12 + shift, .thickness = h};
      spec.model.periodic_y = true;
      auto s = tests::make_diffuse_box(spec);
      tests::drive(s, [](double) { return 0.0; });
      s.targets[0] = dp;
      for (int t = 0; t < 8000; ++t) ibm::step(s);
      double const flow = -s.openings[1].mass_flow / spec.ny;
      double const slip = (0.625 - overlap(shift, h)) / 4;
      EXPECT_NEAR(flow / dp, slip, 0.005 * slip) << h << " " << shift;
      double const before = s.ledger.membrane_down;
      ibm::step(s);
      EXPECT_NEAR(s.ledger.membrane_down - before, -flow * spec.ny, 1e-3 * flow * spec.ny);
    }
}

}  // namespace
}  // namespace velum
