#include "ibm/crossing.hpp"

#include "ibm/labels.hpp"
#include "lbm/link.hpp"

namespace velum::ibm {

namespace {

constexpr int downstream = 4;  // beside the sides of labels.hpp

KOKKOS_INLINE_FUNCTION int part(std::uint8_t side, double y, double divide)
{
  return side == minus_side && y < divide ? downstream : int(side);
}

/// Books mass that enters a part through a face.
KOKKOS_INLINE_FUNCTION void enter(int part, double mass, double& up, double& down)
{
  if (part == downstream) down += mass;
  if (part == plus_side || part == minus_side) up += mass;
}

}  // namespace

template <class Real>
Crossing crossing(lbm::Fluid<Real> const& fluid, double divide)
{
  int const nx = fluid.nx, ny = fluid.ny;
  lbm::Fluid<Real> const grid = fluid;
  auto const active = fluid.active;
  auto const symmetry = fluid.symmetry;
  double const y0 = fluid.origin[1];
  bool const periodic = fluid.model.periodic_y;  // across x a membrane parts no periodic box
  Crossing sum;
  Kokkos::parallel_reduce(
      "velum::ibm::crossing", nx * ny,
      KOKKOS_LAMBDA(int c, double& up, double& down, double& seat) {
        int const i = c % nx, j = c / nx;
        double const y = y0 + j + 0.5;
        int const from = part(active(grid.cell(i, j)), y, divide);
        if (from == 0) return;
        for (int d = 1; d < lbm::D2Q9::Q; d += 2) {  // one of each pair of directions
          int const x = i + lbm::D2Q9::cx(d);
          int row = j + lbm::D2Q9::cy(d);
          if (periodic) row = (row + ny) % ny;
          if (x < 0 || x >= nx || row < 0 || row >= ny) continue;
          int const to = part(active(grid.cell(x, row)), y0 + row + 0.5, divide);
          if (to == 0 || to == from) continue;
          double const mass = lbm::link_ring(symmetry, y, d) *
                              (double(grid.f.arriving(d, grid.cell(x, row))) -
                               double(grid.f.arriving(lbm::D2Q9::opposite(d), grid.cell(i, j))));
          if (from == minus_side && to == downstream) {
            seat += mass;
          } else if (from == downstream && to == minus_side) {
            seat -= mass;
          } else {
            enter(to, mass, up, down);
            enter(from, -mass, up, down);
          }
        }
      },
      sum.up, sum.down, sum.seat);
  return sum;
}

template Crossing crossing(lbm::Fluid<float> const&, double);
template Crossing crossing(lbm::Fluid<double> const&, double);

}  // namespace velum::ibm
