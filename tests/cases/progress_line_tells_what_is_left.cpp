#include "cases/app/progress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace velum::tests {
namespace {

cases::Progress at(double time)
{
  return {.time = time, .end = 0.1, .mlups = 12.34, .mach = 0.0567, .coupling = "3 sub-steps"};
}

std::string written(bool quiet, bool terminal)
{
  std::FILE* file = std::tmpfile();
  cases::ProgressLine line(quiet, file, terminal);
  for (int k = 0; k <= 1000; ++k) line.show(at(1e-4 * k));
  line.finish();
  std::string text(static_cast<std::size_t>(std::ftell(file)), '\0');
  std::rewind(file);
  auto const read = std::fread(text.data(), 1, text.size(), file);
  text.resize(read);
  std::fclose(file);
  return text;
}

auto count(std::string const& text, char c) { return std::count(text.begin(), text.end(), c); }

TEST(Progress, LineShowsTimeShareRestSpeedMachAndCoupling)
{
  EXPECT_EQ(cases::progress_text(at(0.025), 60),
            "25.00 of 100.00 ms   25 %  3 min 00 s left  12.3 MLUPS  Mach 0.057  3 sub-steps");
}

TEST(Progress, LineOfARunWithoutALatticeHasNoSpeed)
{
  EXPECT_EQ(cases::progress_text({.time = 0.025, .end = 0.1, .coupling = "gap 1.0 um"}, 60),
            "25.00 of 100.00 ms   25 %  3 min 00 s left  gap 1.0 um");
}

TEST(Progress, PlainLinesComeAtEveryTenth)
{
  auto const text = written(false, false);
  EXPECT_EQ(count(text, '\n'), 11);
  EXPECT_EQ(count(text, '\r'), 0);
}

TEST(Progress, TerminalHasOneLineThatIsRewritten)
{
  auto const text = written(false, true);
  EXPECT_EQ(count(text, '\n'), 1);
  EXPECT_EQ(text.back(), '\n');
  EXPECT_GE(count(text, '\r'), 2);
}

TEST(Progress, QuietWritesNothing)
{
  EXPECT_EQ(written(true, false), "");
  EXPECT_EQ(written(true, true), "");
}

}  // namespace
}  // namespace velum::tests
