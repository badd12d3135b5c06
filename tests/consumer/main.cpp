#include <Kokkos_Core.hpp>

#include "core/vec.hpp"

/// Claim: a project outside this one compiles the installed headers, links the installed libraries
/// and runs.
int main(int argc, char** argv)
{
  Kokkos::ScopeGuard const kokkos(argc, argv);
  velum::core::Vec2 const a{3, 4};
  return velum::core::norm(a) == 5 ? 0 : 1;
}
