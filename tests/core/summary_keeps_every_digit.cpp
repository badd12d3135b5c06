#include "core/check.hpp"
#include "core/output/folder.hpp"
#include "core/output/summary.hpp"
#include "tests/core/scratch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

namespace velum::tests {
namespace {

using namespace core;

TEST(Summary, is_this_text)
{
  Summary const summary{{{"pressure_jump_held", 0.9999, "1"},
                         {"leak", 1.25e-15, "m3/s"},
                         {"mach_max", std::numeric_limits<double>::quiet_NaN(), "1"},
                         {"wall_time", std::numeric_limits<double>::infinity(), "s"}},
                        {{"time step", "chosen so that \"Ma\" <= 0.1"}, {"path", "a\\b\n\x01"}}};
  EXPECT_EQ(to_json(summary), R"({
  "pressure_jump_held": {"value": 0.9999, "unit": "1"},
  "leak": {"value": 1.25e-15, "unit": "m3/s"},
  "mach_max": {"value": null, "unit": "1"},
  "wall_time": {"value": null, "unit": "s"},
  "assumptions": {
    "path": "a\\b\u000a\u0001",
    "time step": "chosen so that \"Ma\" <= 0.1"
  }
}
)");
  EXPECT_EQ(to_json({}), "{\n  \"assumptions\": {}\n}\n");
}

TEST(Summary, numbers_read_back_as_the_same_double)
{
  for (double const value : {0.1, 1.0 / 3, 1e300, 5e-324, -123456789.123456789, 0.0}) {
    auto const text = to_json({{{"x", value, "m"}}, {}});
    std::string const key = "\"value\": ";
    EXPECT_EQ(std::strtod(text.c_str() + text.find(key) + key.size(), nullptr), value) << text;
  }
}

TEST(Summary, reads_back_as_it_was_written)
{
  Scratch const scratch("summary_read");
  auto const file = scratch.folder / "summary.json";
  Summary const written{{{"leak", -1.25e-15, "m3/s"},
                         {"third", 1.0 / 3, "1"},
                         {"mach_max", std::numeric_limits<double>::quiet_NaN(), "1"}},
                        {{"time step", "chosen so that \"Ma\" <= 0.1"}, {"path", "a\\b\n\x01"}}};
  write_summary(file, written);
  auto const read = read_summary(file);
  EXPECT_EQ(to_json(read), to_json(written));
  EXPECT_TRUE(std::isnan(read.figures[2].value));
  EXPECT_EQ(read.assumptions, written.assumptions);
  write_summary(file, {});
  EXPECT_EQ(to_json(read_summary(file)), to_json({}));
}

TEST(Summary, is_refused_where_it_is_cut_short_or_something_else)
{
  Scratch const scratch("summary_cut");
  auto const file = scratch.folder / "summary.json";
  EXPECT_THROW(read_summary(file), InputError);
  // up to the last brace, behind which there is a line break alone
  std::string const whole = to_json({{{"leak", 1, "1"}}, {{"gap", "a law"}, {"path", "\x01"}}});
  for (std::size_t length = 0; length + 1 < whole.size(); ++length) {
    write_atomically(file, whole.substr(0, length));
    EXPECT_THROW(read_summary(file), InputError) << whole.substr(0, length);
  }
  write_atomically(file, R"({"leak": {"value": "none", "unit": "1"}})");
  EXPECT_THROW(read_summary(file), InputError);
}

TEST(Summary, refuses_two_entries_of_one_name)
{
  EXPECT_THROW(to_json({{{"leak", 1, "1"}, {"leak", 2, "1"}}, {}}), InputError);
  EXPECT_THROW(to_json({{{"assumptions", 1, "1"}}, {}}), InputError);
}

TEST(Summary, replaces_the_old_file_and_leaves_nothing_beside_it)
{
  Scratch const scratch("summary");
  auto const file = scratch.folder / "summary.json";
  write_summary(file, {{{"leak", 1, "1"}, {"penetration", 1e-6, "m"}}, {}});
  write_summary(file, {});
  EXPECT_EQ(text_of(file), to_json({}));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(scratch.folder), {}), 1);
  EXPECT_THROW(write_summary(scratch.folder / "nowhere" / "summary.json", {}), InputError);
}

TEST(RunFolder, is_made_with_its_parents_and_found_unwritable)
{
  Scratch const scratch("folder");
  auto const made = make_folder(scratch.folder / "a" / "b");
  EXPECT_TRUE(made.is_absolute());
  EXPECT_TRUE(std::filesystem::is_empty(made));
  EXPECT_NO_THROW(make_folder(made));

  write_atomically(scratch.folder / "file", "text");
  EXPECT_THROW(make_folder(scratch.folder / "file"), InputError);
  EXPECT_THROW(make_folder(scratch.folder / "file" / "run"), InputError);
  EXPECT_THROW(make_folder("/proc/velum"), InputError);
}

}  // namespace
}  // namespace velum::tests
