#include <gtest/gtest.h>

#include "cases/app/table_file.hpp"
#include "tests/cases/scene_file.hpp"

namespace velum::tests {
namespace {

struct ReferenceTable : testing::Test {
  TemporaryFolder folder;

  cases::TableFile read(std::string const& text)
  {
    std::ofstream(folder.path / "t.csv") << text;
    return cases::read_table_file(folder.path / "t.csv", {"x", "u"});
  }
  std::string refused(std::string const& text)
  {
    try {
      auto const table = read(text);
      cases::number(table, 0, "u");
    } catch (core::InputError const& error) {
      return std::string(error.what()).substr(folder.path.string().size() + 1);
    }
    return {};
  }
};

TEST_F(ReferenceTable, CommentsAreSkippedAndEmptyCellsAreNothing)
{
  auto const table = read("# source\n\nx, u ,v\n1,2.5,\n-3e-2,,7\n");
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(cases::number(table, 0, "u"), 2.5);
  EXPECT_EQ(cases::number(table, 0, "v"), std::nullopt);
  EXPECT_EQ(cases::number(table, 1, "x"), -0.03);
  EXPECT_EQ(cases::number(table, 1, "w"), std::nullopt);
}

TEST_F(ReferenceTable, FaultsSayFileLineAndWhatIsWrong)
{
  EXPECT_EQ(refused("x,v\n1,2\n"),
            "t.csv: has no column \"u\"; a reference of this kind needs the columns x, u.");
  EXPECT_EQ(refused("x,u\n"), "t.csv: has no rows.");
  EXPECT_EQ(refused("x,u\n1,2,3\n"), "t.csv:2: has 3 values, but the header names 2 columns.");
  EXPECT_EQ(refused("# a\nx,u\n1,two\n"), "t.csv:3: \"two\" in column \"u\" is not a number.");
}

}  // namespace
}  // namespace velum::tests
