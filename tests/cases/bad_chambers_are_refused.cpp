// problem:   chambers, orifices, ports and the closure of the gap, written wrongly
// reference: README: file, line, key, what is wrong, what is allowed, the nearest spelling
// measure:   the sentence
// tolerance: none
// why:       a lumped part that hangs on nothing would silently change the physics
#include "tests/cases/scene_file.hpp"

#include <gtest/gtest.h>

namespace velum::tests {
namespace {

/// The small valve fed from below, its pilot chamber lumped.
std::string const piloted = edited(small_valve, "{ side = \"x+\", from = \"1 mm\", to = \"5 mm\" }",
                                   "{ side = \"x-\", from = \"3.6 mm\", to = \"4.9 mm\" }") +
                            R"(output_every_note = 0
[gap]
cells = 4
[chamber.pilot]
side = "above"
volume = "100 mm3"
[orifice.bleed]
from = "inlet"
to = "pilot"
area = "0.5 mm2"
[orifice.relief]
from = "pilot"
to = "outlet"
area = "0.5 mm2"
[orifice.relief.seat]
diameter = "2 mm"
land = "0.4 mm"
lift = "0.1 mm"
)";

std::string const scene = edited(piloted, "output_every_note = 0\n", "");

/// The refusal with one edit, from the key on.
std::string refused(std::string const& old, std::string const& by)
{
  auto const sentence = refusal(edited(scene, old, by));
  auto const at = sentence.find(": ");
  return at == std::string::npos ? sentence : sentence.substr(at + 2);
}

TEST(BadChamber, TheSceneItselfIsAccepted) { EXPECT_EQ(refusal(scene), ""); }

TEST(BadChamber, EndsOfAnOrificeMustExist)
{
  EXPECT_EQ(refused("from = \"inlet\"", "from = \"inlte\""),
            "orifice.bleed.from = \"inlte\" names no chamber, boundary with a pressure, or port of "
            "the scene; did you mean \"inlet\"?");
  EXPECT_EQ(refused("to = \"pilot\"", "to = \"inlet\""),
            "orifice.bleed.to must be another place than \"from\".");
}

TEST(BadChamber, NothingOfTheLatticeIsAbove)
{
  EXPECT_EQ(refused("{ side = \"x-\", from = \"3.6 mm\"", "{ side = \"x+\", from = \"3.6 mm\""),
            "inlet.patches[0] is on the side \"x+\", above the membrane, where chamber \"pilot\" "
            "is and no fluid of the lattice; join it by an orifice.");
  EXPECT_EQ(refused("[run]", "[coupling]\nmethod = \"diffuse\"\n[run]"),
            "gap needs coupling.method = \"sharp\".");
}

TEST(BadChamber, OnlyOneIsAbove)
{
  EXPECT_EQ(refused("[orifice.bleed]",
                    "[chamber.other]\nside = \"above\"\nvolume = \"1 mm3\"\n[orifice.bleed]"),
            "chamber.pilot.side = \"above\" is taken by another chamber.");
}

TEST(BadChamber, PortsNeedAnOrifice)
{
  EXPECT_EQ(
      refused("[orifice.bleed]",
              "[boundary.drain]\nkind = \"port\"\npatches = [{ side = \"x-\", from = \"5.2 mm\", "
              "to = \"5.8 mm\" }]\n[orifice.bleed]")
          .substr(0, 24),
      "boundary.drain.patches[0");
  EXPECT_EQ(refused("[orifice.bleed]",
                    "[boundary.drain]\nkind = \"port\"\npatches = [{ side = \"seat\", from = \"3.1 "
                    "mm\", to = \"3.4 mm\" }]\n[orifice.bleed]"),
            "boundary.drain.kind = \"port\" takes its flow from orifices, but none begins or ends "
            "there.");
}

TEST(BadChamber, CoefficientsHaveTheirRange)
{
  EXPECT_EQ(refused("cells = 4", "cells = 4\ndischarge = 1.2"),
            "gap.discharge = 1.2 must not exceed 1: no passage passes more than its section.");
}

TEST(BadChamber, AMemberNeedsItsSeatAndMaterial)
{
  EXPECT_EQ(refused("lift = \"0.1 mm\"\n",
                    "lift = \"0.1 mm\"\n[orifice.relief.membrane]\nmaterial = \"ruber\"\nradius = "
                    "\"1.35 mm\"\nboss = \"1 mm\"\nthickness = \"0.3 mm\"\n"),
            "orifice.relief.membrane.material = \"ruber\" names no material of the scene; did you "
            "mean \"rubber\"?");
}

TEST(BadChamber, TheLumpedFidelityNeedsTheWholeValve)
{
  auto const text =
      edited(edited(scene, "\"axisymmetric\"", "\"lumped\""), "[outlet]", "[boundary.other]");
  EXPECT_TRUE(refusal(text).ends_with("fidelity = \"lumped\" needs an outlet; the scene has none."))
      << refusal(text);
}

}  // namespace
}  // namespace velum::tests
