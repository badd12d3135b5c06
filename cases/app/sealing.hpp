#pragma once
#include "cases/app/coupled_scene.hpp"

namespace velum::cases {

/// Whether no population can travel from an inlet to an outlet. Of a diffuse membrane, which stops
/// fluid by force and not by topology, never.
template <class Real>
bool is_sealed(CoupledScene<Real, ibm::Sharp> const& s)
{
  if (s.state.chambers && ibm::passes(*s.state.chambers)) return false;
  auto const& fluid = s.state.fluid;
  auto const& regions = s.state.body.mass.regions;
  std::vector<int> inlets, outlets;
  for (std::size_t k = 0; k < s.state.openings.size(); ++k) {
    auto const& list = s.state.openings[k].links;
    auto const links = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), list.links);
    if (s.boundary[k] != "inlet" && s.boundary[k] != "outlet") continue;
    for (int l = 0; l < list.size; ++l)
      (s.boundary[k] == "inlet" ? inlets : outlets)
          .push_back(regions.of[static_cast<std::size_t>(links(l).j * fluid.nx + links(l).i)]);
  }
  for (int a : inlets)
    for (int b : outlets)
      if (a == b && a >= 0) return false;
  return true;
}

template <class Real>
bool is_sealed(CoupledScene<Real, ibm::Diffuse> const&)
{
  return false;
}

}  // namespace velum::cases
