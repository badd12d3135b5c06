#include "cases/app/speed.hpp"

#include "lbm/stream_and_collide.hpp"

#include <Kokkos_Core.hpp>

#include <algorithm>

namespace velum::cases {
namespace {

template <class Real>
double mlups(int nx, int ny, core::Symmetry symmetry, lbm::Model const& model)
{
  auto fluid = lbm::make_fluid<Real>(nx, ny, {0, 0}, symmetry, model);
  lbm::stream_and_collide(fluid);  // the first touch of the memory is not the speed of a run
  Kokkos::fence();
  Kokkos::Timer clock;
  int steps = 0;
  while (clock.seconds() < 0.3) {
    for (int k = 0; k < 4; ++k) lbm::stream_and_collide(fluid);
    Kokkos::fence();
    steps += 4;
  }
  return 1e-6 * steps * nx * ny / clock.seconds();
}

}  // namespace

double measured_mlups(Scene const& scene, Derived const& derived)
{
  int const nx = std::min(derived.grid.nx, 1000), ny = std::min(derived.grid.ny, 1000);
  lbm::Model const model{.collision = scene.lattice.collision,
                         .viscosity = derived.viscosity,
                         .magic = scene.lattice.magic};
  return scene.lattice.precision == Precision::single_
             ? mlups<float>(nx, ny, derived.grid.symmetry, model)
             : mlups<double>(nx, ny, derived.grid.symmetry, model);
}

}  // namespace velum::cases
