#include <fmt/core.h>
#include <gtest/gtest.h>

#include <Kokkos_Core.hpp>

/// Runs the tests with Kokkos up and says on how many threads; listing them starts nothing.
int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  if (testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
  Kokkos::ScopeGuard const kokkos(argc, argv);
  fmt::print("{}: {} threads\n", Kokkos::DefaultExecutionSpace::name(),
             Kokkos::DefaultHostExecutionSpace().concurrency());
  return RUN_ALL_TESTS();
}
