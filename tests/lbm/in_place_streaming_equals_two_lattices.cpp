// problem:   a periodic box with a solid block in it, random start, marched in place, spans and all
// reference: the same collision with two whole copies of the populations, pulled cell by cell, the
//            block reflecting half-way, written down here in a few lines
// measure:   largest difference of an outgoing population after 1, 2 and 7 steps
// tolerance: 1e-15 of populations of 0.1
// why:       both do the same sums; the compiler may fuse multiplications and additions differently
#include <gtest/gtest.h>

#include <random>

#include "lbm/bounce_back.hpp"
#include "lbm/central_moment.hpp"
#include "lbm/collide.hpp"
#include "lbm/walls.hpp"
#include "tests/support/lattices.hpp"

namespace velum {
namespace {

constexpr double nu = 0.01;

template <class L>
struct TwoLattices {
  int n;
  std::vector<std::array<double, L::Q>> f;

  int cell(int i, int j, int k) const
  {
    auto const wrap = [&](int a) { return (a + n) % n; };
    return L::D == 3 ? (wrap(k) * n + wrap(j)) * n + wrap(i) : wrap(j) * n + wrap(i);
  }
  void step(std::function<bool(int, int, int)> const& solid)
  {
    auto next = f;
    for (int k = 0; k < (L::D == 3 ? n : 1); ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
          if (solid(i, j, k)) continue;
          double site[L::Q];
          for (int d = 0; d < L::Q; ++d) {
            int const x = i - L::c(d, 0), y = j - L::c(d, 1),
                      z = L::D == 3 ? k - L::c(d, L::D - 1) : 0;
            auto const c = static_cast<std::size_t>(cell(i, j, k));
            auto const from = static_cast<std::size_t>(cell(x, y, z));
            site[d] =
                solid((x + n) % n, (y + n) % n, (z + n) % n) ? f[c][L::opposite(d)] : f[from][d];
          }
          lbm::collide<L, false, false>(site, lbm::CentralMoment<double>{1 / (3 * nu + 0.5)}, {});
          for (int d = 0; d < L::Q; ++d) next[static_cast<std::size_t>(cell(i, j, k))][d] = site[d];
        }
    f = next;
  }
};

template <class L>
void equals_two_lattices()
{
  int const n = 20;
  auto const solid = [](int i, int j, int k) {
    return i >= 5 && i < 9 && j >= 7 && j < 12 && (L::D == 2 || (k >= 3 && k < 8));
  };
  lbm::Model model{lbm::Collision::central_moments, nu};
  model.periodic_x = model.periodic_y = model.periodic_z = true;
  auto fluid = lbm::make_fluid<double, L>(n, n, {}, core::Symmetry::planar, model, n);
  auto const walls = lbm::find_walls(fluid, [&](core::Vec<double, L::D> const& p) {
    int const i = int(std::floor(p[0] + n)) % n, j = int(std::floor(p[1] + n)) % n,
              k = L::D == 3 ? int(std::floor(p[L::D - 1] + n)) % n : 0;
    return solid(i, j, k) ? -1.0 : 1.0;
  });
  lbm::deactivate_solids(fluid, walls);
  std::vector<lbm::Link> links;
  for (lbm::WallHit const& h : walls.hits) {
    links.push_back(lbm::link_at(fluid, walls, h));
    links.back().q = 0.5;
    links.back().stencil = lbm::Stencil::half_way;
  }
  lbm::LinkList list;
  lbm::upload(list, links);

  TwoLattices<L> other{
      n, std::vector<std::array<double, L::Q>>(static_cast<std::size_t>(fluid.cells()))};
  std::mt19937 engine{1};
  std::uniform_real_distribution<double> noise(-0.05, 0.05);
  auto const each_cell = [&](auto const& visit) {
    for (int k = 0; k < fluid.nz; ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
          if (!solid(i, j, k))
            visit(fluid.cell(i, j, k), static_cast<std::size_t>(other.cell(i, j, k)));
  };
  each_cell([&](int cell, std::size_t c) {
    for (int d = 0; d < L::Q; ++d) {
      other.f[c][d] = L::w(d) * noise(engine);
      fluid.f.set_outgoing(d, cell, other.f[c][d]);
    }
  });
  for (int t = 1; t <= 7; ++t) {
    lbm::fill_ghosts(fluid);
    lbm::bounce_back(fluid, list, {});
    lbm::stream_and_collide(fluid);
    other.step(solid);
    double worst = 0;
    each_cell([&](int cell, std::size_t c) {
      for (int d = 0; d < L::Q; ++d)
        worst = std::max(worst, std::abs(fluid.f.outgoing(d, cell) - other.f[c][d]));
    });
    EXPECT_LT(worst, 1e-16) << "D" << L::D << "Q" << L::Q << ", step " << t;
  }
}

TEST(InPlaceStreaming, EqualsTwoLattices)
{
  equals_two_lattices<lbm::D2Q9>();
  equals_two_lattices<lbm::D3Q19>();
  equals_two_lattices<lbm::D3Q27>();
}

}  // namespace
}  // namespace velum
