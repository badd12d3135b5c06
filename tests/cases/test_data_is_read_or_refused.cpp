#include "tests/cases/test_file.hpp"

#include <gtest/gtest.h>

namespace velum::tests {
namespace {

using structure::StressKind;
using structure::TestMode;

std::string refused(std::string const& old, std::string const& by)
{
  return test_refusal(edited(plain_test, old, by));
}

TEST(TestData, IsReadInSiWithItsOtherColumnsLeftAlone)
{
  auto const file = read_test(plain_test);
  EXPECT_EQ(file.kind, "uniaxial");
  EXPECT_EQ(file.test.mode, TestMode::uniaxial);
  EXPECT_EQ(file.test.kind, StressKind::engineering);
  EXPECT_TRUE(file.states_stress_kind);
  ASSERT_EQ(file.test.stretch.size(), 10u);
  EXPECT_DOUBLE_EQ(file.test.stretch[2], 1.2);
  EXPECT_DOUBLE_EQ(file.test.stress[2], 0.5056e6);
  EXPECT_EQ(file.ignored, std::vector<std::string>{"time [s]"});
}

TEST(TestData, StressIsEngineeringUnlessSaidToBeTrue)
{
  auto const plain = read_test(edited(plain_test, "engineering_stress [MPa]", "stress [kPa]"));
  EXPECT_EQ(plain.test.kind, StressKind::engineering);
  EXPECT_FALSE(plain.states_stress_kind);
  EXPECT_DOUBLE_EQ(plain.test.stress[2], 0.5056e3);
  auto const true_ = read_test(edited(plain_test, "engineering_stress", "true_stress"));
  EXPECT_EQ(true_.test.kind, StressKind::true_);
  EXPECT_TRUE(true_.states_stress_kind);
}

TEST(TestData, StrainMayBeInPercentOrPlain)
{
  auto const percent =
      read_test("# test = planar\r\nstrain [%],stress [N/mm2]\r\n10,0.2\r\n20,0.4\r\n30,0.5\r\n");
  EXPECT_EQ(percent.test.mode, TestMode::planar);
  EXPECT_DOUBLE_EQ(percent.test.stretch[1], 1.2);
  EXPECT_DOUBLE_EQ(percent.test.stress[1], 0.4e6);
  auto const plain = read_test(
      "\xEF\xBB\xBF# test = equibiaxial\nstrain [1],stress [Pa]\n"
      "0.1,2\n0.2,4\n");
  EXPECT_EQ(plain.test.mode, TestMode::equibiaxial);
  EXPECT_DOUBLE_EQ(plain.test.stretch[1], 1.2);
}

TEST(TestData, OfABulgeIsTheTrueStressAtItsPole)
{
  auto const file = read_test(
      "# test = bulge\n# thickness = 0.5 mm\n"
      "stretch,pressure [kPa],radius [mm]\n1.1,10,30\n1.2,15,25\n");
  EXPECT_EQ(file.test.mode, TestMode::equibiaxial);
  EXPECT_EQ(file.test.kind, StressKind::true_);
  EXPECT_NEAR(file.test.stress[1], 15e3 * 25e-3 * 1.2 * 1.2 / (2 * 0.5e-3), 1e-6);
}

TEST(BadTestData, MustSayWhatWasTested)
{
  EXPECT_EQ(refused("# test = uniaxial\n", ""),
            "data.csv: does not say what was tested; begin it with a line \"# test = uniaxial\"; "
            "tests are uniaxial, equibiaxial, planar or bulge.");
  EXPECT_EQ(refused("# test = uniaxial", "# test = uniaxal"),
            "data.csv: \"# test = uniaxal\" is no test; did you mean \"uniaxial\"? Tests are "
            "uniaxial, equibiaxial, planar or bulge.");
}

TEST(BadTestData, MustHaveItsColumnsWithUnits)
{
  EXPECT_EQ(refused("engineering_stress", "enginering_stress"),
            "data.csv:3: has no column of stress: \"engineering_stress [MPa]\" or \"true_stress "
            "[MPa]\"; did you mean \"engineering_stress\"?");
  EXPECT_EQ(refused("stretch,", "lambda,"),
            "data.csv:3: has no column of deformation: \"stretch\" or \"strain [%]\".");
  EXPECT_EQ(refused("engineering_stress [MPa]", "engineering_stress"),
            "data.csv:3: column \"engineering_stress\" has no unit; write \"engineering_stress "
            "[kPa]\".");
  EXPECT_EQ(refused("stretch,", "strain,"),
            "data.csv:3: column \"strain\" has no unit; write \"strain [1] or [%]\".");
  EXPECT_EQ(refused("[MPa]", "[mm]"),
            "data.csv:3: column \"engineering_stress [mm]\": \"1 mm\" is a length, and a pressure "
            "is expected: write it in kPa, Pa, MPa, bar, mbar, hPa, mmHg or psi, for "
            "example \"1 kPa\".");
  EXPECT_EQ(refused("time [s]", "true_stress [MPa]"),
            "data.csv:3: has both a column \"engineering_stress [MPa]\" and a column \"true_stress "
            "[MPa]\"; which one is meant?");
  EXPECT_EQ(refused("time [s]", "stretch"), "data.csv:3: has two columns \"stretch\".");
  EXPECT_EQ(test_refusal("# test = uniaxial\nstretch;stress [MPa]\n1,1;0,2\n1,2;0,4\n"),
            "data.csv:3: has 3 values, but the header names 1 columns.");
  EXPECT_EQ(test_refusal("# test = uniaxial\nstretch;stress [MPa]\n1.1;0.2\n1.2;0.4\n"),
            "data.csv:2: separates its columns by semicolons; write commas, and points as decimal "
            "signs.");
  EXPECT_EQ(test_refusal("# test = bulge\nstretch,pressure [kPa],radius [mm]\n1.1,10,30\n1.2,15,"
                         "25\n"),
            "data.csv: a bulge needs the undeformed thickness: a line \"# thickness = 0.5 mm\".");
}

TEST(BadTestData, MustHaveNumbers)
{
  EXPECT_EQ(refused("0.5056", "n/a"),
            "data.csv:6: \"n/a\" in column \"engineering_stress [MPa]\" is not a number.");
  EXPECT_EQ(refused("0.5056", "nan"),
            "data.csv:6: \"nan\" in column \"engineering_stress [MPa]\" is not a number.");
  EXPECT_EQ(refused("1.2, 0.5056", ", 0.5056"), "data.csv:6: has no value in column \"stretch\".");
}

TEST(BadTestData, MustBeALoadingBranchOfRubber)
{
  EXPECT_EQ(refused("1.2,", "-1.2,"),
            "data.csv:6: a stretch of -1.2 in column \"stretch\" is none: it is positive, and 1 at "
            "rest; a strain goes in a column \"strain [%]\".");
  EXPECT_EQ(refused("1.9,", "190,"),
            "data.csv:13: a stretch of 190 in column \"stretch\" is beyond any rubber; if it is in "
            "percent, write \"stretch [%]\".");
  EXPECT_EQ(refused("1.9,", "1.7,"),
            "data.csv:13: the stretch turns back, from 1.8 to 1.7; give the loading branch alone, "
            "sorted.");
  EXPECT_EQ(test_refusal("# test = uniaxial\nstretch,stress [MPa]\n1.100,0.2\n1.101,0.2\n"),
            "data.csv: the stretch goes from 1.1 to 1.101 only; a law takes a spread of at least "
            "0.01.");
  EXPECT_EQ(test_refusal("# test = uniaxial\nstretch,stress [MPa]\n1.1,-0.2\n1.2,-0.3\n"),
            "data.csv: the stress is compressive where the sheet is stretched, or zero throughout; "
            "tension is positive.");
}

}  // namespace
}  // namespace velum::tests
