#include "tests/cases/scene_file.hpp"

#include <gtest/gtest.h>

namespace velum::tests {
namespace {

/// The refusal of the small valve with one edit.
std::string refused(std::string const& old, std::string const& by)
{
  return refusal(edited(small_valve, old, by));
}

TEST(BadInput, TheSmallValveItselfIsAccepted) { EXPECT_EQ(refusal(small_valve), ""); }

TEST(BadInput, UnknownKeyHasLineNearestSpellingAndAllowedKeys)
{
  EXPECT_EQ(
      refused("dx = \"100 um\"", "dxx = \"100 um\""),
      "scene.toml:4: lattice.dxx is not a key of [lattice]; did you mean \"dx\"? Allowed: dx, "
      "from, to, mach, time_step, collision, magic, wall_rule, precision, shift, periodic, "
      "symmetry, stencil.");
  EXPECT_EQ(refused("[fluid]", "[fluids]").substr(0, 76),
            "scene.toml:7: fluids is not a key of the scene; did you mean \"fluid\"? Allowe");
}

TEST(BadInput, KeyOfAnotherKindSaysWhichKeysThisKindHas)
{
  EXPECT_EQ(refused("pressure = \"50 kPa\"", "velocity = \"1 m/s\""),
            "scene.toml:19: inlet.velocity is not a key of [inlet] with kind = \"traction\". "
            "Allowed: kind, pressure, patches, profile.");
}

TEST(BadInput, MissingKeySaysWhatItMustBe)
{
  EXPECT_EQ(refused("viscosity = \"1e-6 m2/s\"\n", ""),
            "scene.toml:7: fluid.viscosity is missing; it must be a kinematic viscosity, such as "
            "\"1 m2/s\".");
  EXPECT_EQ(refused("[run]\nsettle = \"10 ms\"\noutput_every = \"5 ms\"\n", ""),
            "scene.toml: run is missing; it must be a table [run].");
}

TEST(BadInput, WrongUnitSaysWhatItIsAndWhatIsExpected)
{
  auto const sentence = refused("pressure = \"50 kPa\"", "pressure = \"50 kg\"");
  EXPECT_TRUE(
      sentence.starts_with("scene.toml:19: inlet.pressure: \"50 kg\" is a mass, and a "
                           "pressure is expected"))
      << sentence;
}

TEST(BadInput, NumberWithoutUnitIsRefused)
{
  EXPECT_EQ(refused("dx = \"100 um\"", "dx = 100"),
            "scene.toml:4: lattice.dx must be a length written as text with its unit, such as \"1 "
            "mm\", but is the number 100.");
}

TEST(BadInput, WrongWordHasNearestAndAllowedWords)
{
  EXPECT_EQ(refused("kind = \"traction\"", "kind = \"tracton\""),
            "scene.toml:18: inlet.kind cannot be the text \"tracton\"; did you mean \"traction\"? "
            "Allowed: traction, pressure, velocity, flow_rate, outflow, port, moving_wall.");
}

TEST(BadInput, SchemeOfTheMembraneIsOneOfThree)
{
  for (auto const* scheme : {"auto", "explicit", "implicit"})
    EXPECT_EQ(refusal(small_valve, {std::string("coupling.membrane=") + scheme}), "");
  EXPECT_EQ(refusal(small_valve, {"coupling.membrane=implicitly"}),
            "--set: coupling.membrane cannot be the text \"implicitly\"; did you mean "
            "\"implicit\"? Allowed: auto, explicit, implicit.");
}

TEST(BadInput, NegativeOrZeroCellIsRefused)
{
  EXPECT_EQ(refused("dx = \"100 um\"", "dx = \"-100 um\""),
            "scene.toml:4: lattice.dx must be positive, but is \"-100 um\".");
  EXPECT_EQ(refused("dx = \"100 um\"", "dx = \"0 um\""),
            "scene.toml:4: lattice.dx must be positive, but is \"0 um\".");
}

TEST(BadInput, InvertedDomainIsRefused)
{
  EXPECT_EQ(
      refused("to = [\"2 mm\", \"6 mm\"]", "to = [\"-4 mm\", \"6 mm\"]"),
      "scene.toml:6: lattice.to must be larger than lattice.from in its first coordinate, but "
      "-4 mm is not above -4 mm.");
}

TEST(BadInput, MembraneOutsideTheDomainIsRefused)
{
  EXPECT_EQ(refused("radius = \"5 mm\"", "radius = \"7 mm\""),
            "scene.toml:34: membrane.radius puts the membrane, from 0 mm to 7 mm, outside the "
            "domain, which goes from 0 mm to 6 mm there.");
  EXPECT_EQ(refused("position = \"0 mm\"", "position = \"1.5 mm\""),
            "scene.toml:33: membrane.position = 1.5 mm puts the membrane, 2 mm thick, outside the "
            "domain, which goes from -4 mm to 2 mm there.");
}

TEST(BadInput, RimWithoutWallIsRefused)
{
  EXPECT_EQ(refused("radius = \"5 mm\"", "radius = \"4.5 mm\""),
            "scene.toml:34: membrane.radius = 4.5 mm puts the clamped rim in the open: it must lie "
            "in or touch a solid, or reach the edge of the domain, but the nearest wall is 0.5 mm "
            "away.");
  EXPECT_EQ(refusal(edited(edited(small_valve, "radius = \"5 mm\"", "radius = \"4.5 mm\""),
                           "thickness =", "rim = \"hinged\"\nthickness =")),
            "scene.toml:34: membrane.radius = 4.5 mm puts the hinged rim in the open: it must lie "
            "in or touch a solid, or reach the edge of the domain, but the nearest wall is 0.5 mm "
            "away.");
}

TEST(BadInput, OpenContourIsRefused)
{
  std::string const points =
      R"([["-1.2 mm", "3 mm"], ["-1.2 mm", "3.5 mm"], ["-5 mm", "3.5 mm"], ["-5 mm", "3 mm"]])";
  EXPECT_EQ(refused(points, R"([["-1.2 mm", "3 mm"], ["-1.2 mm", "3.5 mm"], ["-1.2 mm", "3 mm"]])"),
            "scene.toml:16: solid.seat.points is an open contour: it has 2 different points, and a "
            "closed contour needs at least 3.");
  EXPECT_EQ(
      refused(points,
              R"([["0 mm", "0 mm"], ["1 mm", "1 mm"], ["1 mm", "0 mm"], ["0 mm", "1 mm"]])"),
      "scene.toml:16: solid.seat.points is a contour that crosses itself: the edge from (0, 0) "
      "mm to (1, 1) mm meets the edge from (1, 0) mm to (0, 1) mm.");
  EXPECT_EQ(refused(points, R"([["0 mm", "0 mm"], ["1 mm", "0 mm"], ["2 mm", "0 mm"]])"),
            "scene.toml:16: solid.seat.points turns back on itself at (2, 0) mm.");
}

TEST(BadInput, PressureOnAClosedWallIsRefused)
{
  EXPECT_EQ(
      refused("from = \"1 mm\", to = \"5 mm\"", "from = \"5 mm\", to = \"6 mm\""),
      "scene.toml:21: inlet.patches[0] lies on a closed wall: from 5 mm to 6 mm no fluid cell "
      "opens to \"x+\"; move the patch or the solid.");
  EXPECT_EQ(refused("{ side = \"x+\", from = \"1 mm\", to = \"5 mm\" }",
                    "{ side = \"casing\", from = \"5.5 mm\", to = \"6 mm\" }"),
            "scene.toml:21: inlet.patches[0] lies on a closed wall: from 5.5 mm to 6 mm no fluid "
            "cell opens to \"casing\"; move the patch or the solid.");
}

TEST(BadInput, PatchOnTheAxisOrOutsideOrTwiceIsRefused)
{
  EXPECT_EQ(refused("side = \"x+\"", "side = \"y-\""),
            "scene.toml:21: inlet.patches[0].side = \"y-\" is the axis of symmetry; nothing can "
            "enter there.");
  EXPECT_EQ(refused("to = \"5 mm\" }", "to = \"7 mm\" }"),
            "scene.toml:21: inlet.patches[0].to = 7 mm is outside the domain, which goes from 0 mm "
            "to 6 mm there.");
  EXPECT_EQ(refused("side = \"x-\"", "side = \"x+\""),
            "scene.toml:25: outlet.patches[0] overlaps inlet.patches[0].");
}

TEST(BadInput, NanInATableIsRefused)
{
  EXPECT_EQ(refused("\"50 kPa\"", R"([["0 ms", "0 kPa"], ["5 ms", "nan kPa"]])"),
            "scene.toml:19: inlet.pressure[1][1]: \"nan kPa\" is not a finite number.");
  EXPECT_EQ(refused("\"50 kPa\"", R"([["0 ms", "0 kPa"], ["5 ms", nan]])"),
            "scene.toml:19: inlet.pressure[1][1] must be a pressure written as text with its unit, "
            "such as \"1 kPa\", but is the number nan.");
}

TEST(BadInput, TableThatDoesNotIncreaseIsRefused)
{
  EXPECT_EQ(
      refused("\"50 kPa\"", R"([["0 ms", "0 kPa"], ["5 ms", "1 kPa"], ["5 ms", "2 kPa"]])"),
      "scene.toml:19: inlet.pressure[2] must follow the row before it: the first column of the "
      "table inlet.pressure has to increase strictly.");
}

TEST(BadInput, NamesThatPointNowhereHaveTheNearestName)
{
  EXPECT_EQ(refused("material = \"rubber\"", "material = \"ruber\""),
            "scene.toml:32: membrane.material = \"ruber\" names no material of the scene; did you "
            "mean \"rubber\"?");
  EXPECT_EQ(refused("seat = \"seat\"", "seat = \"lid\""),
            "scene.toml:38: contact.seat = \"lid\" names no solid of the scene; allowed: casing or "
            "seat.");
  EXPECT_EQ(
      refused("side = \"x-\"", "side = \"set\""),
      "scene.toml:25: outlet.patches[0].side = \"set\" names no side or solid of the scene; did "
      "you mean \"seat\"?");
}

TEST(BadInput, MissingFileAndBrokenTomlAreRefused)
{
  try {
    cases::read_scene("no/such/scene.toml");
    FAIL();
  } catch (core::InputError const& error) {
    EXPECT_STREQ(error.what(), "no/such/scene.toml: there is no such scene file.");
  }
  EXPECT_TRUE(refused("dx = \"100 um\"", "dx = \"100 um")
                  .starts_with("scene.toml:4: is not valid "
                               "TOML: "));
}

TEST(BadInput, OverridesAreRefusedLikeTheFile)
{
  EXPECT_EQ(refusal(small_valve, {"lattice.dxx=1"}).substr(0, 51),
            "--set: lattice.dxx is not a key of [lattice]; did y");
  EXPECT_EQ(refusal(small_valve, {"solid.saet.round=1 mm"}),
            "--set: solid.saet does not exist; did you mean \"seat\"?");
  EXPECT_EQ(refusal(small_valve, {"inlet.patches[3].to=1 mm"}),
            "--set: inlet.patches[3] does not exist.");
  EXPECT_EQ(refusal(small_valve, {"inlet.pressure"}),
            "--set: \"inlet.pressure\" is not of the form key=value, such as inlet.pressure=\"300 "
            "kPa\".");
  EXPECT_EQ(refusal(small_valve, {"membrane.radius=7 mm"}).substr(0, 43),
            "--set: membrane.radius puts the membrane, f");
}

TEST(BadInput, InletAmongTheFurtherBoundariesIsRefused)
{
  EXPECT_EQ(
      refused("[inlet]", "[boundary.inlet]"),
      "scene.toml:18: boundary.inlet.kind belongs to a boundary whose table is simply [inlet].");
}

TEST(BadInput, SceneWithoutDriveNeedsATimeStep)
{
  EXPECT_EQ(
      refused("\"50 kPa\"", "\"0 kPa\""),
      "scene.toml:3: lattice needs a time_step, such as \"0.1 us\": nothing in the scene has a "
      "pressure or velocity from which it could be derived.");
}

TEST(BadInput, ALiftStopKnowsWhatItIsFor)
{
  auto const with = [](std::string const& stop) {
    return refused("[membrane]", "[membrane.stop]\n" + stop + "[membrane]");
  };
  EXPECT_TRUE(with("radius = \"3 mm\"\n").find("membrane.stop.position is missing") !=
              std::string::npos);
  EXPECT_TRUE(with("position = \"2 mm\"\nradius = \"30 mm\"\n")
                  .ends_with("membrane.stop.radius must not exceed that of the membrane."));
  EXPECT_EQ(with("position = \"2 mm\"\nradius = \"3 mm\"\n"), "");
}

}  // namespace
}  // namespace velum::tests
