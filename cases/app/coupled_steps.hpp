#pragma once
#include <chrono>
#include <filesystem>
#include <type_traits>

#include "cases/app/coupled_march.hpp"
#include "cases/app/simulation.hpp"

namespace velum::cases {

/// A coupled run under way: what it is of, and what it has come to.
template <class Real, template <class> class Body>
struct CoupledRun {
  Scene scene;
  RunOptions const& options;
  CoupledScene<Real, Body>& s;
  Calendar when;
  March march{};
  std::filesystem::path kept{};  // last checkpoint
  bool stopped = false;          // by a signal
  std::chrono::steady_clock::time_point began = std::chrono::steady_clock::now();

  /// Wall time, with that of the runs that this one goes on from, s.
  double seconds() const
  {
    return march.seconds +
           std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  }
};

/// Whether checkpoints hold the state of such a run.
template <class Real, template <class> class Body>
constexpr bool keeps_state = std::is_same_v<Body<Real>, ibm::Sharp<Real>>;

/// Time between two checkpoints, s.
double checkpoint_every(Scene const& scene);

/// Takes over the checkpoint of the options: state of the scene, march, files.
template <class Real>
void resume(CoupledRun<Real, ibm::Sharp>& run, core::Assumptions const& said);

/// Takes the run back to its last checkpoint, on a shorter time step than it has now.
/// @param asked, initial  the scene, and what it begins as, with the step that the user asked for
/// @param start           made anew with the shorter one
/// @pre there is a checkpoint
template <class Real>
void fall_back(CoupledRun<Real, ibm::Sharp>& run, Scene const& asked, Scene const& initial,
               HydrostaticScene& start, double smagorinsky, core::Assumptions const& said);

/// Takes the steps that are left, or those until a signal; looks at the fluid now and then, and
/// writes a checkpoint after a look whenever one is due.
/// @throws core::Divergence  the black box is written then, and the sentence tells what left its
///                           usual range first and where the last good state is
template <class Real, template <class> class Body>
void take_steps(CoupledRun<Real, Body>& run);

}  // namespace velum::cases
