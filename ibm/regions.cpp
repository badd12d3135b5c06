#include "ibm/regions.hpp"

#include <algorithm>
#include <numeric>

namespace velum::ibm {

namespace {

/// Cells of one state along a row, one after the other.
struct Run {
  int first, last;
  std::uint8_t state;
};

/// Runs that belong together, as a forest: each points towards the first of its region.
struct Forest {
  std::vector<int> up;

  int root(int k)
  {
    while (up[std::size_t(k)] != k) k = up[std::size_t(k)] = up[std::size_t(up[std::size_t(k)])];
    return k;
  }
  void join(int a, int b)
  {
    a = root(a);
    b = root(b);
    up[std::size_t(std::max(a, b))] = std::min(a, b);
  }
};

std::vector<Run> runs_of(Cells const& cells, int j, int nx)
{
  std::vector<Run> runs;
  for (int i = 0; i < nx; ++i) {
    std::uint8_t const state = cells.at(i, j);
    if (!is_fluid(state)) continue;
    if (!runs.empty() && runs.back().last == i - 1 && runs.back().state == state)
      runs.back().last = i;
    else
      runs.push_back({i, i, state});
  }
  return runs;
}

}  // namespace

template <class Real>
Regions connected_regions(lbm::Fluid<Real> const& fluid, Cells const& cells)
{
  int const nx = fluid.nx, ny = fluid.ny;
  std::vector<std::vector<Run>> rows;
  std::vector<int> first;  // number of a row's first run
  int count = 0;
  for (int j = 0; j < ny; ++j) {
    rows.push_back(runs_of(cells, j, nx));
    first.push_back(count);
    count += static_cast<int>(rows.back().size());
  }
  Forest forest;
  forest.up.resize(static_cast<std::size_t>(count));
  std::iota(forest.up.begin(), forest.up.end(), 0);
  // populations travel to the next cell and, along diagonals, one beside it; through the axis and
  // planes of symmetry into the same row or column, which joins nothing new
  auto const join = [&](int j, int k, int shift) {
    auto const& a = rows[std::size_t(j)];
    auto const& b = rows[std::size_t(k)];
    for (std::size_t m = 0; m < a.size(); ++m)
      for (std::size_t n = 0; n < b.size(); ++n)
        if (a[m].state == b[n].state && a[m].first <= b[n].last + shift + 1 &&
            b[n].first + shift <= a[m].last + 1)
          forest.join(first[std::size_t(j)] + int(m), first[std::size_t(k)] + int(n));
  };
  for (int j = 0; j < ny; ++j) {
    int const next = j + 1 < ny ? j + 1 : fluid.model.periodic(1) ? 0 : -1;
    if (next >= 0) join(j, next, 0);
    if (!fluid.model.periodic(0)) continue;
    for (int k : {j, next})
      for (int shift : {-nx, nx})
        if (k >= 0) join(j, k, shift);
  }

  Regions regions;
  regions.of.assign(cells.state.size(), -1);
  std::vector<int> name(static_cast<std::size_t>(count), -1);
  for (int j = 0; j < ny; ++j)
    for (std::size_t m = 0; m < rows[std::size_t(j)].size(); ++m) {
      int& region = name[std::size_t(forest.root(first[std::size_t(j)] + int(m)))];
      if (region < 0) region = regions.count++;
      Run const& run = rows[std::size_t(j)][m];
      auto const row = regions.of.begin() + std::ptrdiff_t(j) * nx;
      std::fill(row + run.first, row + run.last + 1, region);
      regions.runs.push_back({j, run.first, run.last, region});
    }
  return regions;
}

template Regions connected_regions(lbm::Fluid<float> const&, Cells const&);
template Regions connected_regions(lbm::Fluid<double> const&, Cells const&);

}  // namespace velum::ibm
