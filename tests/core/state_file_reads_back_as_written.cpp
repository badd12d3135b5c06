#include <gtest/gtest.h>

#include "core/check.hpp"
#include "core/output/state_file.hpp"
#include "tests/core/scratch.hpp"

namespace velum::tests {
namespace {

using core::StateFile;

struct State {
  std::vector<double> numbers = {0.1, -3e300, 0};
  std::vector<float> small = {1.5f};
  std::vector<double> list = {};
  std::string text = "a \"text\"";
  long count = -7;
  double pi = 3.141592653589793;

  bool operator==(State const&) const = default;
};

void exchange(StateFile& file, State& s)
{
  file.field("numbers", s.numbers);
  file.field("small", s.small);
  file.list("list", s.list);
  file.text("text", s.text);
  file.number("count", s.count);
  file.field("pi", s.pi);
}

std::string refusal_of(std::filesystem::path const& path, State state)
{
  try {
    auto file = StateFile::open(path);
    exchange(file, state);
  } catch (core::InputError const& error) {
    return error.what();
  }
  return "";
}

struct AStateFile : testing::Test {
  Scratch const scratch{"state"};
  std::filesystem::path const path = scratch.folder / "state.h5";

  void write(State state) const
  {
    auto file = StateFile::create(path);
    exchange(file, state);
    file.commit();
  }
};

TEST_F(AStateFile, ReadsBackAsWritten)
{
  for (std::vector<double> const& list : {std::vector<double>(), {1.0, 2.0}}) {
    State state;
    state.list = list;
    write(state);
    State read{.numbers = {0, 0, 0}, .small = {0}, .list = {9}, .text = "", .count = 0, .pi = 0};
    auto file = StateFile::open(path);
    exchange(file, read);
    EXPECT_EQ(read, state);
  }
}

TEST_F(AStateFile, LeavesTheOldFileUntilItIsWhole)
{
  write({});
  State later;
  later.count = 8;
  {
    auto file = StateFile::create(path);
    exchange(file, later);  // and no commit: the run has ended here
  }
  EXPECT_EQ(refusal_of(path, {}), "");
  auto file = StateFile::open(path);
  long count = 0;
  file.number("count", count);
  EXPECT_EQ(count, -7);
}

TEST_F(AStateFile, OfAnotherSizeIsRefused)
{
  write({});
  State other;
  other.numbers.resize(4);
  EXPECT_NE(refusal_of(path, other).find("has 3 numbers in \"numbers\" where this scene has 4"),
            std::string::npos);
}

TEST_F(AStateFile, ThatIsDamagedOrMissingIsRefused)
{
  write({});
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  EXPECT_NE(refusal_of(path, {}).find("damaged"), std::string::npos) << refusal_of(path, {});
  std::filesystem::remove(path);
  EXPECT_NE(refusal_of(path, {}).find("does not exist"), std::string::npos);
}

TEST_F(AStateFile, RefusesANumberThatMustBeTheSame)
{
  auto file = StateFile::create(path);
  file.same("step", 1e-6, "another run");
  file.commit();
  auto read = StateFile::open(path);
  EXPECT_THROW(read.same("step", 2e-6, "another run"), core::InputError);
}

}  // namespace
}  // namespace velum::tests
