#pragma once
#include <Kokkos_Core.hpp>

namespace velum::core {

/// Whether the host reads and writes what Kokkos computes on: false where that is a GPU.
constexpr bool on_host =
    Kokkos::SpaceAccessibility<Kokkos::HostSpace,
                               Kokkos::DefaultExecutionSpace::memory_space>::accessible;

}  // namespace velum::core
