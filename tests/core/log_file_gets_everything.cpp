#include "core/check.hpp"
#include "core/log.hpp"
#include "tests/core/scratch.hpp"

#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

namespace velum::tests {
namespace {

using namespace core;

/// What the console shows of one message and one warning.
std::string console_output(std::filesystem::path const& folder, Console console)
{
  auto const before = spdlog::default_logger();
  testing::internal::CaptureStdout();
  start_log(folder, console);
  spdlog::info("the step is {} s", 1e-7);
  spdlog::warn("it is short");
  spdlog::set_default_logger(before);
  return testing::internal::GetCapturedStdout();
}

TEST(Log, file_gets_everything_and_a_quiet_console_the_warnings)
{
  Scratch const scratch("log");
  for (Console const console : {Console::normal, Console::quiet}) {
    EXPECT_EQ(console_output(scratch.folder, console),
              console == Console::quiet ? "warning: it is short\n"
                                        : "the step is 1e-07 s\nwarning: it is short\n");
    auto const text = text_of(scratch.folder / "log.txt");
    EXPECT_NE(text.find("info: the step is 1e-07 s\n"), std::string::npos) << text;
    EXPECT_NE(text.find("warning: it is short\n"), std::string::npos) << text;
  }
}

TEST(Log, that_cannot_be_written_is_said)
{
  Scratch const scratch("log");
  std::ofstream(scratch.folder / "file") << "in the way";
  EXPECT_THROW(start_log(scratch.folder / "file", Console::quiet), InputError);
}

}  // namespace
}  // namespace velum::tests
