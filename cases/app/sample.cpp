#include "cases/app/sample.hpp"

#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <vector>

namespace velum::cases {
namespace {

using Cell = std::array<int, 3>;

/// The cell's state, or nullptr outside the fluid; periodic sides are seen through.
lbm::CellState const* state_of(Sampled const& flow, Cell c)
{
  int const size[] = {flow.grid.nx, flow.grid.ny, flow.grid.nz};
  for (std::size_t a = 0; a < 3; ++a) {
    if (flow.periodic[a]) c[a] = (c[a] % size[a] + size[a]) % size[a];
    if (c[a] < 0 || c[a] >= size[a]) return nullptr;
  }
  if (flow.walls.is_solid(c[0], c[1], c[2])) return nullptr;
  return &flow.cells(c[2] * flow.grid.ny + c[1], c[0]);
}

/// Calls visit(cell, offset) for the cells up to `reach` from one, in a plane without its depth.
template <class Visit>
void each_near(Sampled const& flow, Cell const& middle, int reach, Visit const& visit)
{
  int const depth = core::dimensions(flow.grid.symmetry) == 3 ? reach : 0;
  for (int dk = -depth; dk <= depth; ++dk)
    for (int dj = -reach; dj <= reach; ++dj)
      for (int di = -reach; di <= reach; ++di)
        visit(Cell{middle[0] + di, middle[1] + dj, middle[2] + dk}, Cell{di, dj, dk});
}

struct Neighbourhood {
  std::vector<core::Vec3> at;  // from the place, cells
  std::vector<lbm::CellState> state;
};

/// Weights of the parabolas through the cells -1, 0, 1 at the offset t.
struct Lagrange {
  double w[3];
  explicit Lagrange(double t) : w{t * (t - 1) / 2, 1 - t * t, t * (t + 1) / 2} {}
};

/// Value at the place of the best parabola; the weights fall with the distance, so that the nearest
/// cells decide where there are many. In a gap of two cells or one the curvature or the slope is
/// not determined: of all fits the solver takes the one of least norm, in which they are counted so
/// dearly that it has none.
lbm::CellState fitted(Neighbourhood const& near, bool space)
{
  auto const n = static_cast<Eigen::Index>(near.at.size());
  Eigen::MatrixXd terms(n, space ? 10 : 6), values(n, 4);
  for (Eigen::Index k = 0; k < n; ++k) {
    auto const& [x, y, z] = near.at[static_cast<std::size_t>(k)].c;
    auto const& s = near.state[static_cast<std::size_t>(k)];
    double const w = std::exp(-(x * x + y * y + z * z) / 4);
    double const slope = 1e-3 * w, curvature = 1e-6 * w;
    terms.row(k).head(6) << w, slope * x, slope * y, curvature * x * x, curvature * x * y,
        curvature * y * y;
    if (space)
      terms.row(k).tail(4) << slope * z, curvature * x * z, curvature * y * z, curvature * z * z;
    values.row(k) << w * s.rho, w * s.ux, w * s.uy, w * s.uz;
  }
  Eigen::MatrixXd const fit = terms.completeOrthogonalDecomposition().solve(values);
  return {fit(0, 0), fit(0, 1), fit(0, 2), fit(0, 3)};
}

}  // namespace

lbm::CellState state_at(Sampled const& flow, core::Vec3 const& p)
{
  bool const space = core::dimensions(flow.grid.symmetry) == 3;
  core::Vec3 const c = core::cell_coordinates(flow.grid, p);
  Cell middle;
  for (int a = 0; a < 3; ++a) middle[static_cast<std::size_t>(a)] = int(std::lround(c[a]));
  Lagrange const weights[] = {Lagrange(c[0] - middle[0]), Lagrange(c[1] - middle[1]),
                              Lagrange(c[2] - middle[2])};
  lbm::CellState sum{0, 0, 0};
  bool whole = true;
  each_near(flow, middle, 1, [&](Cell const& cell, Cell const& offset) {
    auto const* s = state_of(flow, cell);
    whole = whole && s;
    if (!s) return;
    double w = 1;
    for (std::size_t a = 0; a < (space ? 3 : 2); ++a) w *= weights[a].w[offset[a] + 1];
    sum.rho += w * s->rho;
    sum.ux += w * s->ux;
    sum.uy += w * s->uy;
    sum.uz += w * s->uz;
  });
  if (whole) return sum;

  Neighbourhood near;
  each_near(flow, middle, 4, [&](Cell const& cell, Cell const&) {
    core::Vec3 const at = {cell[0] - c[0], cell[1] - c[1], cell[2] - c[2]};
    auto const* s = state_of(flow, cell);
    if (!s || core::norm(at) > 3) return;
    near.at.push_back(at);
    near.state.push_back(*s);
  });
  return near.at.empty() ? lbm::CellState{0, 0, 0} : fitted(near, space);
}

}  // namespace velum::cases
