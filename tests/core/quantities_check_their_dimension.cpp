#include "core/check.hpp"
#include "core/quantity.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace velum::tests {
namespace {

using core::Dimension;
using core::parse_quantity;

/// The sentence with which a text is refused; empty when it is accepted.
std::string refusal(std::string_view text, Dimension expected)
{
  try {
    parse_quantity(text, expected);
  } catch (core::InputError const& error) {
    return error.what();
  }
  return "";
}

bool mentions(std::string const& sentence, std::string_view part)
{
  return sentence.find(part) != std::string::npos;
}

TEST(Quantity, becomes_the_double_nearest_to_its_si_value)
{
  using enum Dimension;
  EXPECT_EQ(parse_quantity("100 kPa", pressure), 1e5);
  EXPECT_EQ(parse_quantity("0.946 MPa", pressure), 946000);
  EXPECT_EQ(parse_quantity("20 bar", pressure), 2e6);
  EXPECT_EQ(parse_quantity("40 um", length), 4e-5);
  EXPECT_EQ(parse_quantity("40 µm", length), 4e-5);
  EXPECT_EQ(parse_quantity("0.1 N/mm", stiffness), 100);
  EXPECT_EQ(parse_quantity("200 l/h", flow_rate), 0.2 / 3600);
  EXPECT_EQ(parse_quantity("5 ms", time), 5e-3);
  EXPECT_EQ(parse_quantity("0.5 1/s", frequency), 0.5);
  EXPECT_EQ(parse_quantity("998 kg/m3", density), 998);
  EXPECT_EQ(parse_quantity("1.14 g/cm^3", density), 1140);
  EXPECT_EQ(parse_quantity("1e-6 m2/s", kinematic_viscosity), 1e-6);
  EXPECT_EQ(parse_quantity("1 cSt", kinematic_viscosity), 1e-6);
  EXPECT_EQ(parse_quantity("1 mPa s", dynamic_viscosity), 1e-3);
  EXPECT_EQ(parse_quantity("1 mPa*s", dynamic_viscosity), 1e-3);
  EXPECT_EQ(parse_quantity("1 mm2", area), 1e-6);
  EXPECT_EQ(parse_quantity("1 mm²", area), 1e-6);
  EXPECT_EQ(parse_quantity("9.81 m s-2", acceleration), 9.81);
  EXPECT_EQ(parse_quantity("9.81 m/s/s", acceleration), 9.81);
  EXPECT_EQ(parse_quantity("3 N/mm2", pressure), 3e6);
  EXPECT_EQ(parse_quantity("180 deg", angle), 3.141592653589793);
  EXPECT_EQ(parse_quantity("0.3", dimensionless), 0.3);
  EXPECT_EQ(parse_quantity("30 %", dimensionless), 0.3);
}

TEST(Quantity, is_read_whatever_the_blanks)
{
  EXPECT_EQ(parse_quantity("100kPa", Dimension::pressure), 1e5);
  EXPECT_EQ(parse_quantity("  +100 \t kPa ", Dimension::pressure), 1e5);
  EXPECT_EQ(parse_quantity("0.1 N / mm", Dimension::stiffness), 100);
  EXPECT_EQ(parse_quantity("-.5mm", Dimension::length), -5e-4);
}

TEST(Quantity, without_a_unit_is_refused_with_an_example)
{
  auto const said = refusal("100", Dimension::pressure);
  EXPECT_TRUE(mentions(said, "a pressure needs one")) << said;
  EXPECT_TRUE(mentions(said, "\"100 kPa\"")) << said;
}

TEST(Quantity, of_another_dimension_is_named)
{
  auto const said = refusal("100 mm", Dimension::pressure);
  EXPECT_TRUE(mentions(said, "\"100 mm\" is a length, and a pressure is expected")) << said;
  EXPECT_TRUE(mentions(said, "kPa, Pa, MPa")) << said;
  EXPECT_TRUE(mentions(refusal("3 deg", Dimension::dimensionless), "is an angle"));
  EXPECT_TRUE(mentions(refusal("3 m/s", Dimension::dimensionless), "write the number alone"));
  EXPECT_TRUE(mentions(refusal("3 kg m", Dimension::mass), "none of the known quantities"));
}

TEST(Quantity, with_an_unknown_unit_is_refused_with_the_nearest_spelling)
{
  EXPECT_TRUE(mentions(refusal("100 kpa", Dimension::pressure), "Did you mean \"kPa\"?"));
  EXPECT_TRUE(mentions(refusal("20 bra", Dimension::pressure), "Did you mean \"bar\"?"));
  EXPECT_TRUE(mentions(refusal("998 kq/m3", Dimension::density), "Did you mean \"kg/m3\"?"));
  EXPECT_TRUE(mentions(refusal("1 furlong", Dimension::length), "unknown unit \"furlong\""));
  EXPECT_FALSE(mentions(refusal("1 furlong", Dimension::length), "Did you mean"));
}

TEST(Quantity, that_is_no_finite_number_is_refused)
{
  for (std::string_view text : {"nan mm", "inf mm", "-inf mm", "1e999 mm", "1e308 km"})
    EXPECT_TRUE(mentions(refusal(text, Dimension::length), "not a finite number")) << text;
  for (std::string_view text : {"", "  ", "mm", "mm 3", "-", "e3 mm", "ten mm"})
    EXPECT_TRUE(mentions(refusal(text, Dimension::length), "is not a length")) << text;
  EXPECT_TRUE(mentions(refusal("0,5 mm", Dimension::length), "decimal sign is a point"));
}

TEST(Quantity, with_a_broken_unit_is_refused)
{
  for (std::string_view text : {"1 N/", "1 /mm", "1 N//mm", "1 N*/mm", "1 N*", "1 mm99", "1 mm^",
                                "1 m m m3-", "1 -2", "1 2", "0x10 mm", "1 2 mm"})
    EXPECT_NE(refusal(text, Dimension::stiffness), "") << text;
}

TEST(Quantity, suggests_only_units_that_it_accepts_itself)
{
  for (int k = 0; k <= static_cast<int>(Dimension::flow_rate_per_depth); ++k) {
    auto const dimension = static_cast<Dimension>(k);
    for (auto const& unit : core::usual_units(dimension))
      EXPECT_EQ(refusal("1 " + unit, dimension), "") << core::name(dimension);
    EXPECT_EQ(parse_quantity("1 " + std::string(core::si_unit(dimension)), dimension), 1);
  }
}

}  // namespace
}  // namespace velum::tests
