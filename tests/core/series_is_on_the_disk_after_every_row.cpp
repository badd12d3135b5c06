#include "core/check.hpp"
#include "core/output/series.hpp"
#include "tests/core/scratch.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace velum::tests {
namespace {

using namespace core;

TEST(Series, is_on_the_disk_after_every_row)
{
  Scratch const scratch("series");
  auto const file = scratch.folder / "series.csv";
  auto series = start_series(file, {{"inlet_pressure", "Pa"}, {"leak", "m3/s"}});
  EXPECT_EQ(text_of(file), "time [s],inlet_pressure [Pa],leak [m3/s]\n");
  append(series, 0, {1e5, 0});
  EXPECT_EQ(text_of(file), "time [s],inlet_pressure [Pa],leak [m3/s]\n0,100000,0\n");
  append(series, 0.1, {100000.25, 0.1 + 0.2});
  EXPECT_TRUE(text_of(file).ends_with("\n0.1,100000.25,0.30000000000000004\n"));
  append(series, 0.2, {NAN, INFINITY});
  EXPECT_TRUE(text_of(file).ends_with("\n0.2,nan,inf\n"));
}

TEST(Series, refuses_what_would_break_the_table)
{
  Scratch const scratch("series");
  auto const file = scratch.folder / "series.csv";
  auto series = start_series(file, {{"leak", "m3/s"}});
  EXPECT_THROW(append(series, 0, {}), InputError);
  EXPECT_THROW(append(series, 0, {1, 2}), InputError);
  EXPECT_THROW(start_series(file, {{"a,b", "m"}}), InputError);
  EXPECT_THROW(start_series(scratch.folder / "nowhere" / "series.csv", {}), InputError);
}

TEST(Series, goes_on_after_the_rows_that_count)
{
  Scratch const scratch("series");
  auto const file = scratch.folder / "series.csv";
  std::vector<Column> const columns = {{"leak", "m3/s"}};
  {
    auto series = start_series(file, columns);
    for (int k = 0; k < 4; ++k) append(series, k, {10.0 * k});
    EXPECT_EQ(series.rows, 4);
    series.file << "4,4";  // cut short
  }
  for (int const rows : {9, 2}) {
    auto series = resume_series(file, columns, rows);
    EXPECT_EQ(series.rows, rows == 9 ? 4 : 2);
    append(series, 7, {70});
    EXPECT_TRUE(text_of(file).ends_with(rows == 9 ? "\n3,30\n7,70\n" : "\n1,10\n7,70\n"));
  }
  EXPECT_THROW(resume_series(file, {{"flow", "m3/s"}}, 1), InputError);
  EXPECT_EQ(resume_series(scratch.folder / "new.csv", columns, 3).rows, 0);
}

TEST(Series, says_when_the_disk_is_full)
{
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "skipped: there is no /dev/full";
  EXPECT_THROW(start_series("/dev/full", {{"leak", "m3/s"}}), InputError);
}

}  // namespace
}  // namespace velum::tests
