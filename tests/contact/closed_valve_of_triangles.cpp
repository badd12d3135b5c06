// problem:   the closed valve's membrane (radius 8.25 mm, 2 mm thick, spring of 0.1 N/mm) on its
//            seat, in fluid at rest at 20, 100 and 300 kPa above and outside, 0 inside, lip linear;
//            of triangles in space against the revolved seat; meshes of 10, 16 and 32 rings, and,
//            at 300 kPa, of 16 whose nodes are moved about by a quarter of their distance there
// reference: the same of 330 line elements about the axis (closed_valve_deflects_as_computed.cpp),
//            whose seat force is within 0.05 % of that of 1320
// measure:   relative error of the deflection of the middle and of the seat's axial force; slope of
//            the deflection's error from 16 to 32 rings; forces across the axis
// tolerance: 16 rings 1 % in both (the issue's), more than that of 10 rings; 32 rings 0.3 % and
//            0.5 %; order 1.85 +- 0.2; across 2e-3 of the force
// why:       linear triangles are second order, at the middle h^2 log(1/h); the force is the sealed
//            area's, and the edge of the contact is known to a part of a triangle; the force across
//            is a sum over nodes that differ with the pattern of triangles, which repeats six times
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/revolved.hpp"
#include "ibm/sheet_hydrostatic.hpp"
#include "structure/sheet_mesh.hpp"
#include "tests/contact/valve_membrane.hpp"

namespace velum::tests {
namespace {

constexpr double stiffness = 1e12;

/// Steps to 3 mm (the spring's patch), 4.3 mm, 5.45 mm (what may touch), and to the rim.
struct Rings {
  int middle, between, seat, rim;
};
constexpr Rings coarse{2, 1, 5, 2}, medium{3, 2, 8, 3}, fine{6, 4, 16, 6};

structure::TriangleMesh disc(Rings const& n)
{
  std::vector<double> radii;
  auto const append = [&](double from, double to, int steps) {
    auto const more = structure::graded(from, to, steps);
    radii.insert(radii.end(), more.begin() + 1, more.end());
  };
  append(0, 3e-3, n.middle);
  append(3e-3, 4.3e-3, n.between);
  append(4.3e-3, 5.45e-3, n.seat);
  append(5.45e-3, 8.25e-3, n.rim);
  return structure::disc_mesh(radii);
}

/// Moves the nodes in the plane, all but the middle and the rim.
structure::TriangleMesh shaken(structure::TriangleMesh mesh, double by)
{
  auto const rim = structure::rim_points(mesh);
  for (int i = 1; i < mesh.points.size() / 3; ++i) {
    if (std::ranges::binary_search(rim, i)) continue;
    mesh.points[3 * i + 1] += by * std::sin(37.0 * i);
    mesh.points[3 * i + 2] += by * std::sin(53.0 * i + 1);
  }
  return mesh;
}

struct ClosedSheet {
  structure::Sheet sheet;
  std::shared_ptr<contact::PointContact> seat;
  ibm::RegionSeeds seeds;
};

ibm::SheetHydrostaticReport settle(ClosedSheet& s, ibm::HydrostaticLoad const& load)
{
  return ibm::hydrostatic_equilibrium(s.sheet, s.seat, s.seeds,
                                      {structure::spring_load(s.sheet, spring_of_the_valve)}, load,
                                      false);
}

/// Pulled onto its seat by the spring alone.
ClosedSheet closed_sheet(structure::TriangleMesh const& mesh)
{
  ClosedSheet s{structure::make_sheet(mesh, 2e-3, structure::neo_hookean_rubber(0.946e6), 1140),
                {},
                {structure::rim_points(mesh), {0}}};
  for (int p : s.seeds.upstream) structure::clamp(s.sheet, p);
  double const top = -1.1e-3, foot = -3e-3;
  auto const profile =
      core::polygon({{foot, 5e-3}, {top, 5e-3}, {top, 5.5e-3}, {foot, 5.5e-3}}, 0.15e-3);
  s.seat = std::make_shared<contact::PointContact>(
      ibm::make_sheet_contact(s.sheet, core::revolved(profile), stiffness));
  EXPECT_TRUE(settle(s, {}).regions.sealed);
  return s;
}

struct Closed {
  double pressure, deflection, force;
};

std::vector<double> const pressures{20e3, 100e3, 300e3};

std::vector<Closed> of_lines(std::vector<double> const& pressures)
{
  std::vector<Closed> closed;
  auto line = closed_valve(stiffness, false, 2.5e-5);
  for (double p : pressures) {
    auto const r = press(line, p, contact::LipPressure::linear, false);
    closed.push_back({p, line.membrane.position[0], r.patch.resultant[0]});
  }
  return closed;
}

std::vector<Closed> of_triangles(structure::TriangleMesh const& mesh,
                                 std::vector<double> const& pressures)
{
  std::vector<Closed> closed;
  auto s = closed_sheet(mesh);
  for (double p : pressures) {
    auto const r = settle(s, {p, 0, p, contact::LipPressure::linear});
    EXPECT_TRUE(r.regions.sealed) << p;
    EXPECT_LT(r.contact.penetration, 3e-6) << p;
    EXPECT_LT(r.moved, 1e-9) << p;
    EXPECT_LT(std::hypot(r.contact.force[1], r.contact.force[2]), 2e-3 * r.contact.force[0]) << p;
    closed.push_back({p, s.sheet.position[0], r.contact.force[0]});
  }
  return closed;
}

/// Errors relative to lines; recorded by name.
std::vector<Closed> errors(std::string const& name, structure::TriangleMesh const& mesh,
                           std::vector<Closed> const& lines)
{
  std::vector<double> pressures;
  for (auto const& l : lines) pressures.push_back(l.pressure);
  auto const triangles = of_triangles(mesh, pressures);
  std::vector<Closed> e;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    e.push_back({pressures[i], std::abs(triangles[i].deflection / lines[i].deflection - 1),
                 std::abs(triangles[i].force / lines[i].force - 1)});
    testing::Test::RecordProperty(fmt::format("{}_at_{}_kPa", name, pressures[i] / 1e3),
                                  fmt::format("deflection {:.3f} %, force {:.3f} %",
                                              100 * e[i].deflection, 100 * e[i].force));
  }
  return e;
}

TEST(ClosedValve, of_triangles_is_that_of_lines)
{
  auto const lines = of_lines(pressures);
  auto const few = errors("rings_10", disc(coarse), lines);
  auto const more = errors("rings_16", disc(medium), lines);
  for (std::size_t i = 0; i < pressures.size(); ++i) {
    EXPECT_LT(more[i].deflection, 0.01) << pressures[i];
    EXPECT_LT(more[i].force, 0.01) << pressures[i];
    EXPECT_GT(few[i].deflection, more[i].deflection) << pressures[i];
  }
}

TEST(ClosedValve, of_irregular_triangles_is_that_of_lines)
{
  for (auto const& e : errors("shaken", shaken(disc(medium), 0.036e-3), of_lines({300e3}))) {
    EXPECT_LT(e.deflection, 0.01);
    EXPECT_LT(e.force, 0.01);
  }
}

TEST(LongClosedValve, of_fine_triangles_is_that_of_lines)
{
  auto const lines = of_lines(pressures);
  auto const more = errors("rings_16", disc(medium), lines);
  auto const many = errors("rings_32", disc(fine), lines);
  for (std::size_t i = 0; i < pressures.size(); ++i) {
    EXPECT_LT(many[i].deflection, 0.003) << pressures[i];
    EXPECT_LT(many[i].force, 0.005) << pressures[i];
    EXPECT_NEAR(std::log2(more[i].deflection / many[i].deflection), 1.85, 0.2) << pressures[i];
  }
}

}  // namespace
}  // namespace velum::tests
