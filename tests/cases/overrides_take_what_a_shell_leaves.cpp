#include "cases/app/overrides.hpp"
#include "cases/app/scene.hpp"
#include "core/check.hpp"

#include <gtest/gtest.h>

namespace velum::tests {
namespace {

/// The scene { a = { b = 1, rows = [{ c = 2 }] } } after one override.
toml::table after(std::string const& text)
{
  toml::table scene = toml::parse("[a]\nb = 1\nrows = [{ c = 2 }]\n");
  cases::apply_override(scene, text);
  return scene;
}

TEST(Override, TextWithUnitNeedsNoQuotes)
{
  EXPECT_EQ(after("a.b=300 kPa")["a"]["b"].value<std::string>(), "300 kPa");
  EXPECT_EQ(after("a.b=\"300 kPa\"")["a"]["b"].value<std::string>(), "300 kPa");
  EXPECT_EQ(after("a.b = trt")["a"]["b"].value<std::string>(), "trt");
}

TEST(Override, NumbersAndTruthsKeepTheirType)
{
  EXPECT_EQ(after("a.b=0.25")["a"]["b"].value_exact<double>(), 0.25);
  EXPECT_EQ(after("a.b=3")["a"]["b"].value_exact<std::int64_t>(), 3);
  EXPECT_EQ(after("a.b=true")["a"]["b"].value_exact<bool>(), true);
}

TEST(Override, ArraysWorkWithAndWithoutTheQuotesInside)
{
  for (std::string const text : {"a.b=[\"25 um\",\"0 um\"]", "a.b=[25 um, 0 um]"}) {
    auto const scene = after(text);
    EXPECT_EQ(scene["a"]["b"][0].value<std::string>(), "25 um");
    EXPECT_EQ(scene["a"]["b"][1].value<std::string>(), "0 um");
  }
  auto const table = after("a.b=[[0 ms, 0 kPa], [5 ms, 1 kPa]]");
  EXPECT_EQ(table["a"]["b"][1][1].value<std::string>(), "1 kPa");
}

TEST(Override, PathsReachIntoArraysAndMakeMissingTables)
{
  EXPECT_EQ(after("a.rows[0].c=7 mm")["a"]["rows"][0]["c"].value<std::string>(), "7 mm");
  EXPECT_EQ(after("les.constant=0.2")["les"]["constant"].value<double>(), 0.2);
}

TEST(Override, PathsThatLeadNowhereAreRefused)
{
  for (std::string const text :
       {"a.b.c=1", "a.rows[1].c=1", "a..b=1", "a.rows[x].c=1", "=1", "a.b="})
    EXPECT_THROW(after(text), core::InputError) << text;
}

}  // namespace
}  // namespace velum::tests
