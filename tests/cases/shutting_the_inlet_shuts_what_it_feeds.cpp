// problem:   the stage of a run in which the inlet is shut, of a valve with bleed and relief, its
//            boundaries named as usual or otherwise
// reference: only passages that begin or end at the inlet are shut; without a boundary of that name
//            none is
// measure:   which passages of the network can pass anything
// tolerance: none
// why:       a logical statement
#include "cases/app/pressure_network.hpp"
#include "tests/cases/long_run.hpp"

#include <gtest/gtest.h>

namespace velum::tests {
namespace {

/// Whether each passage is open with the inlet shut, after the pilot has opened.
std::vector<bool> open_when_shut(std::string const& text)
{
  auto const scene = read_text(text);
  auto const derived = cases::derive(scene);
  auto made = cases::make_network(scene, derived);
  cases::set_network(made.network, made.key, scene, derived, 1e-3, true);
  std::vector<bool> open;
  for (auto const& p : made.network.passages) open.push_back(p.loss.has_value());
  return open;
}

TEST(ShutInlet, shuts_the_bleed_and_nothing_else)
{
  EXPECT_EQ(open_when_shut(quick_piloted_valve), (std::vector<bool>{false, true}));
  auto const renamed =
      edited(edited(quick_piloted_valve, "[inlet]", "[boundary.feed]"), "\"inlet\"", "\"feed\"");
  EXPECT_EQ(open_when_shut(renamed), (std::vector<bool>{true, true}));
}

}  // namespace
}  // namespace velum::tests
