// problem:   the shipped pilot membrane on twice its cells, to 8 ms: clamped, bending, its middle
//            lifted by 0.4 mm in 5 ms, driving the water one way; 43 explicit sub-steps, and
//            implicit steps
// reference: the volume that its lower face sweeps; its own equilibrium with the same middle; and a
//            run in which the water pushes back
// measure:   water displaced against volume swept, at worst; volume swept at the end against that
// in
//            equilibrium; largest lift
// tolerance: 5 %; 0.1 %; 1e-9 of the lift; the two runs differ
// why:       3.6 % seen on this grid and 1.8 % on the shipped one: what is lost lies where the
// lower
//            face passes the lattice, half a cell of error in its place at first; damping of 2000
//            1/s leaves e^-3 of some per mille after the 3 ms of rest
#include <gtest/gtest.h>

#include "cases/app/coupled_run.hpp"
#include "tests/cases/scene_file.hpp"
#include "tests/support/summary.hpp"

namespace velum::tests {
namespace {

TEST(PilotMembrane, DisplacesWhatItSweepsAndEndsInItsEquilibrium)
{
  TemporaryFolder const folder;
  auto const run = [&](std::string const& feedback, std::string const& membrane) {
    auto const scene = cases::read_scene(
        "cases/pilot_membrane/scene.toml",
        {"lattice.dx=50 um", "membrane.element=50 um", "run.settle=8 ms", "run.output_every=8 ms",
         "lattice.mach=0.02", "coupling.feedback=" + feedback, "coupling.membrane=" + membrane});
    cases::run_coupled(scene, {.out = folder.path, .quiet = true});
    return figure(folder.path, "shape_error");
  };
  for (auto const* membrane : {"explicit", "implicit"}) {
    double const one_way = run("one_way", membrane);
    EXPECT_NEAR(figure(folder.path, "centre_displacement") / 0.4e-3, 1, 1e-9);
    EXPECT_LT(figure(folder.path, "displaced_volume_error"), 0.05);
    EXPECT_NEAR(one_way, 0, 1e-3);
    EXPECT_NE(run("two_way", membrane), one_way);
  }
}

TEST(PilotMembrane, BendsWhereItIsThick)
{
  auto const bends = [](std::vector<std::string> const& set) {
    return cases::has_bending(*read_text(small_valve, set).membrane);
  };
  EXPECT_TRUE(bends({"membrane.bending=auto"}));
  EXPECT_FALSE(bends({"membrane.bending=auto", "membrane.thickness=0.09 mm"}));
  EXPECT_TRUE(bends({"membrane.bending=on", "membrane.thickness=0.09 mm"}));
}

}  // namespace
}  // namespace velum::tests
