#include "cases/app/simulation.hpp"

#include "cases/app/coupled_run.hpp"
#include "cases/app/fluid_run.hpp"
#include "cases/app/hydrostatic_scene.hpp"
#include "cases/app/lumped_run.hpp"

namespace velum::cases {

void run(Scene const& scene, RunOptions const& options)
{
  if (scene.fidelity == Fidelity::hydrostatic) return run_hydrostatic(scene, options.out);
  if (scene.fidelity == Fidelity::lumped) return run_lumped(scene, options);
  if (scene.membrane) return run_coupled(scene, options);
  run_fluid(scene, options);
}

}  // namespace velum::cases
