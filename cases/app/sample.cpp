#include "cases/app/sample.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <vector>

namespace velum::cases {
namespace {

/// The cell's state, or nullptr outside the fluid; periodic sides are seen through.
lbm::CellState const* cell(Sampled const& flow, int i, int j)
{
  int const nx = flow.grid.nx, ny = flow.grid.ny;
  if (flow.periodic_x) i = (i % nx + nx) % nx;
  if (flow.periodic_y) j = (j % ny + ny) % ny;
  if (i < 0 || i >= nx || j < 0 || j >= ny || flow.walls.is_solid(i, j)) return nullptr;
  return &flow.cells(j, i);
}

struct Neighbourhood {
  std::vector<core::Vec2> at;  // from the place, cells
  std::vector<lbm::CellState> state;
};

/// Weights of the parabolas through the cells -1, 0, 1 at the offset t.
struct Lagrange {
  double w[3];
  explicit Lagrange(double t) : w{t * (t - 1) / 2, 1 - t * t, t * (t + 1) / 2} {}
};

/// Value at the place of the best parabola; the weights fall with the distance, so that the nearest
/// cells decide where there are many.
lbm::CellState fitted(Neighbourhood const& near)
{
  auto const n = static_cast<Eigen::Index>(near.at.size());
  Eigen::MatrixXd terms(n, 6), values(n, 3);
  for (Eigen::Index k = 0; k < n; ++k) {
    auto const& [x, y] = near.at[static_cast<std::size_t>(k)].c;
    auto const& s = near.state[static_cast<std::size_t>(k)];
    double const w = std::exp(-(x * x + y * y) / 4);
    terms.row(k) << w, w * x, w * y, w * x * x, w * x * y, w * y * y;
    values.row(k) << w * s.rho, w * s.ux, w * s.uy;
  }
  Eigen::MatrixXd const fit = terms.completeOrthogonalDecomposition().solve(values);
  return {fit(0, 0), fit(0, 1), fit(0, 2)};
}

}  // namespace

lbm::CellState state_at(Sampled const& flow, core::Vec2 const& p)
{
  core::Vec2 const c = core::cell_coordinates(flow.grid, p);
  int const i = static_cast<int>(std::lround(c[0])), j = static_cast<int>(std::lround(c[1]));
  Lagrange const wx(c[0] - i), wy(c[1] - j);
  lbm::CellState sum{0, 0, 0};
  bool whole = true;
  for (int dj = -1; dj <= 1; ++dj)
    for (int di = -1; di <= 1; ++di) {
      auto const* s = cell(flow, i + di, j + dj);
      whole = whole && s;
      if (!s) continue;
      double const w = wx.w[di + 1] * wy.w[dj + 1];
      sum.rho += w * s->rho;
      sum.ux += w * s->ux;
      sum.uy += w * s->uy;
    }
  if (whole) return sum;

  Neighbourhood near;
  for (int dj = -4; dj <= 4; ++dj)
    for (int di = -4; di <= 4; ++di) {
      core::Vec2 const at = {i + di - c[0], j + dj - c[1]};
      auto const* s = cell(flow, i + di, j + dj);
      if (!s || core::norm(at) > 3) continue;
      near.at.push_back(at);
      near.state.push_back(*s);
    }
  return near.at.empty() ? lbm::CellState{0, 0, 0} : fitted(near);
}

}  // namespace velum::cases
