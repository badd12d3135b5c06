#include "cases/app/speed.hpp"

#include "cases/app/format.hpp"
#include "cases/app/time_steps.hpp"

#include <algorithm>

namespace velum::cases {
namespace {

constexpr int longest_side = 1000, longest_side_in_space = 100;

}  // namespace

double measured_mlups(Scene const& scene, Derived const& derived)
{
  auto const& grid = derived.grid;
  int const most = dimensions(scene) == 3 ? longest_side_in_space : longest_side;
  int const nx = std::min(grid.nx, most), ny = std::min(grid.ny, most),
            nz = std::min(grid.nz, most);
  lbm::Model const model{.collision = scene.lattice.collision,
                         .viscosity = derived.viscosity,
                         .magic = scene.lattice.magic};
  return with_format(scene.lattice, [&]<class Real, class L, class Stored>() {
    return time_steps(lbm::make_fluid<Real, L, Stored>(nx, ny, {}, grid.symmetry, model, nz));
  });
}

}  // namespace velum::cases
