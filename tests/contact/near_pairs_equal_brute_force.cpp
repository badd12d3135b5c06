// problem:   boxes of random place and size, some of them ten times as large; two flat grids of n x
// n
//            boxes above each other, n = 50, 100, 200
// reference: all pairs one by one
// measure:   the pairs; time over the number of boxes
// tolerance: equal; 16 times the boxes take less than 64 times the time
// why:       comparisons alone decide; all pairs one by one would take 256 times the time, sorting
//            takes 16 times a logarithm's 1.4; the rest is for a machine that does other work
#include "contact/near_pairs.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <random>

namespace velum::contact {
namespace {

bool meet(core::Bounds const& a, core::Bounds const& b)
{
  bool both = true;
  for (int k = 0; k < 3; ++k) both = both && a.lo[k] <= b.hi[k] && b.lo[k] <= a.hi[k];
  return both;
}

std::vector<core::Bounds> random_boxes(int count, double size, std::mt19937& random)
{
  std::uniform_real_distribution<double> place(-1, 1), share(0, 1);
  std::vector<core::Bounds> boxes;
  for (int n = 0; n < count; ++n) {
    core::Vec3 const lo{place(random), place(random), 0.2 * place(random)};
    core::Vec3 hi = lo;
    for (int k = 0; k < 3; ++k) hi[k] += size * share(random) * (n % 20 == 0 ? 10 : 1);
    boxes.push_back({lo, hi});
  }
  return boxes;
}

TEST(NearPairs, are_those_found_one_by_one)
{
  std::mt19937 random(1);
  for (double const size : {0.0, 0.02, 0.3}) {
    auto const first = random_boxes(400, size, random), second = random_boxes(300, 0.05, random);
    std::vector<Pair> expected;
    for (int i = 0; i < 400; ++i)
      for (int j = 0; j < 300; ++j)
        if (meet(first[std::size_t(i)], second[std::size_t(j)])) expected.emplace_back(i, j);
    ASSERT_FALSE(expected.empty());
    EXPECT_EQ(near_pairs(first, second), expected) << size;
  }
}

TEST(NearPairs, of_nothing_are_none)
{
  EXPECT_TRUE(near_pairs({}, {}).empty());
  EXPECT_TRUE(near_pairs({core::Bounds{{0, 0, 0}, {1, 1, 1}}}, {}).empty());
}

double time_of(int n)
{
  std::vector<core::Bounds> first, second;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      core::Vec3 const lo{0, i + 0.3, j + 0.2};
      first.push_back({lo, lo});
      second.push_back({{-0.1, i - 0.1, j - 0.1}, {0.1, i + 1.1, j + 1.1}});
    }
  double least = 1e9;
  for (int again = 0; again < 3; ++again) {
    auto const start = std::chrono::steady_clock::now();
    auto const pairs = near_pairs(first, second);
    EXPECT_EQ(pairs.size(), std::size_t(n) * std::size_t(n));
    least = std::min(
        least, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return least;
}

TEST(NearPairs, are_found_in_nearly_linear_time) { EXPECT_LT(time_of(200) / time_of(50), 64); }

}  // namespace
}  // namespace velum::contact
