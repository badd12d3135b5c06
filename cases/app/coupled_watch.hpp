#pragma once
#include "cases/app/black_box.hpp"
#include "cases/app/coupled_scene.hpp"
#include "lbm/observe.hpp"

namespace velum::cases {

/// The black boxes of a march: the whole state at the last looks of the guard, and what costs
/// nothing to look at, at each of the last steps.
struct CoupledWatch {
  BlackBox looks, steps;
};

template <class Real, template <class> class Body>
CoupledWatch make_watch(CoupledScene<Real, Body> const& s, Scene const& scene);

/// @param time  of the drivers, s
template <class Real, template <class> class Body>
void note_step(CoupledWatch& watch, CoupledScene<Real, Body> const& s, Scene const& scene, long n,
               double time);
template <class Real, template <class> class Body>
void note_look(CoupledWatch& watch, CoupledScene<Real, Body> const& s, lbm::Observation const& seen,
               long n, double time);

/// Writes blackbox.csv and blackbox_steps.csv; the likely causes in their order, as a sentence.
std::string open_black_box(CoupledWatch const& watch, std::filesystem::path const& folder);

}  // namespace velum::cases
