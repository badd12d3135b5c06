#include "ibm/stencil.hpp"

#include <cmath>

#include "lbm/moments.hpp"

namespace velum::ibm {

namespace {

constexpr int width = Peskin4::width;

/// Cells and weights along one direction, for a marker at r in cell indices.
KOKKOS_INLINE_FUNCTION void reach(double r, int cells, bool periodic, bool axis, int (&cell)[width],
                                  double (&weight)[width], double (&mirror)[width])
{
  int const base = static_cast<int>(std::floor(r)) - 1;
  for (int a = 0; a < width; ++a) {
    int c = base + a;
    weight[a] = Peskin4::phi(r - c);
    mirror[a] = 1;
    if (periodic) c = (c % cells + cells) % cells;
    if (axis && c < 0) {
      c = -1 - c;
      mirror[a] = -1;
    }
    bool const outside = c < 0 || c >= cells;
    cell[a] = outside ? 0 : c;
    if (outside) weight[a] = 0;
  }
}

}  // namespace

template <class Real>
void locate(lbm::Fluid<Real> const& fluid, MarkerField const& X, Stencils const& stencils, int n)
{
  int const nx = fluid.nx, ny = fluid.ny;
  bool const periodic_x = fluid.model.periodic_x, periodic_y = fluid.model.periodic_y;
  bool const axis = fluid.has_axis();
  auto const active = fluid.active;
  auto const grid = fluid;
  auto const origin = fluid.origin;
  Kokkos::parallel_for(
      "velum::ibm::locate", n, KOKKOS_LAMBDA(int k) {
        Stencil s;
        double along[width];
        reach(X(0, k) - origin[0] - 0.5, nx, periodic_x, false, s.i, s.x, along);
        reach(X(1, k) - origin[1] - 0.5, ny, periodic_y, axis, s.j, s.y, s.mirror);
        s.j_min = ny;
        s.j_max = -1;
        double share = 0;
        for (int b = 0; b < width; ++b) {
          s.j_min = s.j[b] < s.j_min ? s.j[b] : s.j_min;
          s.j_max = s.j[b] > s.j_max ? s.j[b] : s.j_max;
          for (int a = 0; a < width; ++a)
            if (active(grid.cell(s.i[a], s.j[b]))) share += s.x[a] * s.y[b];
        }
        s.scale = share < least_share ? 0 : 1 / share;
        stencils(k) = s;
      });
}

template <class Real>
void interpolate(lbm::Fluid<Real> const& fluid, Stencils const& stencils, MarkerField const& U,
                 int n)
{
  lbm::Fluid<Real> const from = fluid;
  auto const half = 0.5 * fluid.model.body_force;
  Kokkos::parallel_for(
      "velum::ibm::interpolate", n, KOKKOS_LAMBDA(int k) {
        Stencil const s = stencils(k);
        double ux = 0, uy = 0, density = 0;
        for (int b = 0; b < width; ++b)
          for (int a = 0; a < width; ++a) {
            double const weight = s.scale * s.x[a] * s.y[b];
            int const cell = from.cell(s.i[a], s.j[b]);
            if (weight == 0 || !from.active(cell)) continue;
            double site[9], rho;
            core::Vec2 m;
            for (int d = 0; d < 9; ++d) site[d] = double(from.f.arriving(d, cell));
            lbm::density_and_momentum<lbm::D2Q9>(site, rho, m);
            ux += weight * (m[0] + half[0]) / (1 + rho);
            uy += weight * s.mirror[b] * (m[1] + half[1]) / (1 + rho);
            density += weight * (1 + rho);
          }
        U(0, k) = ux;
        U(1, k) = uy;
        U(2, k) = density;
        U(3, k) = s.scale > 0 ? 1 : 0;
      });
}

template <class Real>
void spread(lbm::Fluid<Real> const& fluid, Stencils const& stencils, MarkerField const& F, int n)
{
  auto const force = fluid.force;
  auto const active = fluid.active;
  auto const grid = fluid;
  auto const symmetry = fluid.symmetry;
  double const y0 = fluid.origin[1];
  Kokkos::deep_copy(force, Real(0));
  Kokkos::parallel_for(
      "velum::ibm::spread", fluid.ny, KOKKOS_LAMBDA(int j) {
        double const per_volume = 1 / core::ring(symmetry, y0 + j + 0.5);
        for (int k = 0; k < n; ++k) {
          if (j < stencils(k).j_min || j > stencils(k).j_max) continue;
          Stencil const s = stencils(k);
          for (int b = 0; b < width; ++b) {
            if (s.j[b] != j) continue;
            for (int a = 0; a < width; ++a) {
              int const cell = grid.cell(s.i[a], j);
              if (!active(cell)) continue;
              double const weight = per_volume * s.scale * s.x[a] * s.y[b];
              force(0, cell) += Real(weight * F(0, k));
              force(1, cell) += Real(weight * s.mirror[b] * F(1, k));
            }
          }
        }
      });
}

template void locate(lbm::Fluid<float> const&, MarkerField const&, Stencils const&, int);
template void locate(lbm::Fluid<double> const&, MarkerField const&, Stencils const&, int);
template void interpolate(lbm::Fluid<float> const&, Stencils const&, MarkerField const&, int);
template void interpolate(lbm::Fluid<double> const&, Stencils const&, MarkerField const&, int);
template void spread(lbm::Fluid<float> const&, Stencils const&, MarkerField const&, int);
template void spread(lbm::Fluid<double> const&, Stencils const&, MarkerField const&, int);

}  // namespace velum::ibm
