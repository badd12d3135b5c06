#include "tests/core/field_samples.hpp"
#include "tests/core/scratch.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace velum::tests {
namespace {

/// ParaView's own readers see every time, cell value and node of a written run; the script beside
/// this file asks them.
TEST(LongParaView, opens_the_fields)
{
  if (std::system("command -v pvpython > /dev/null") != 0)
    GTEST_SKIP() << "skipped: ParaView is missing";
  Scratch const scratch("paraview");
  auto const file = SampleRun{}.write(scratch.folder, 3);
  std::filesystem::path const here = std::filesystem::path(__FILE__).parent_path();
  std::string const script = (here / "paraview_opens_the_fields.py").string();
  std::string const command = "pvpython '" + script + "' '" + file.index.string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0);
}

}  // namespace
}  // namespace velum::tests
