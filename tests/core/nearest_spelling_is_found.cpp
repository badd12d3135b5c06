#include "core/spelling.hpp"

#include <gtest/gtest.h>

namespace velum::tests {
namespace {

std::vector<std::string> const keys = {"inlet",    "outlet",    "membrane",
                                       "pressure", "flow_rate", "dx"};

TEST(Spelling, one_slip_is_recognised)
{
  EXPECT_EQ(core::nearest("presure", keys), "pressure");    // a letter lost
  EXPECT_EQ(core::nearest("membrrane", keys), "membrane");  // a letter twice
  EXPECT_EQ(core::nearest("inlat", keys), "inlet");         // a wrong letter
  EXPECT_EQ(core::nearest("oultet", keys), "outlet");       // two swapped
  EXPECT_EQ(core::nearest("flow-rate", keys), "flow_rate");
  EXPECT_EQ(core::nearest("Dx", keys), "dx");  // wrong case
}

TEST(Spelling, wrong_case_is_nearer_than_a_wrong_letter)
{
  EXPECT_EQ(core::nearest("kpa", {"mpa", "kPa"}), "kPa");
}

TEST(Spelling, nothing_near_gives_nothing)
{
  EXPECT_EQ(core::nearest("viscosity", keys), "");
  EXPECT_EQ(core::nearest("", keys), "");
  EXPECT_EQ(core::nearest("q", {"x", "y"}), "");
  EXPECT_EQ(core::nearest("inlet", {}), "");
}

TEST(Spelling, lists_read_as_a_sentence)
{
  EXPECT_EQ(core::any_of({}), "");
  EXPECT_EQ(core::any_of({"a"}), "a");
  EXPECT_EQ(core::any_of({"a", "b"}), "a or b");
  EXPECT_EQ(core::any_of({"a", "b", "c"}), "a, b or c");
}

}  // namespace
}  // namespace velum::tests
