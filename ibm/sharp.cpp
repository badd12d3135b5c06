#include "ibm/sharp.hpp"

#include <algorithm>

#include "core/check.hpp"
#include "ibm/refill.hpp"
#include "ibm/sharp_links.hpp"
#include "lbm/bounce_back.hpp"
#include "lbm/moments.hpp"
#include "lbm/stream_and_collide.hpp"

namespace velum::ibm {

namespace {

using lbm::D2Q9;

/// Hands a link's force, block, area and pressure to one node with the given share.
/// @param sum     of the populations were the face at rest
/// @param stress  the same of the face as it moved a step ago: were the pressure of a face taken at
///                rest, rho c_s u would be part of it
/// @param excess  of c.u at the node over c.u at the hit, a step ago
void add(Exchange& e, int node, double share, int side, core::Vec2 c, double w, double ring,
         double sum, double stress, double kappa, double excess)
{
  auto const a = static_cast<std::size_t>(node);
  double const m = share * ring;
  // the block falls with the node's own velocity, the force with that at the hit
  e.force[2 * node] += m * (sum + kappa * excess) * c[0];
  e.force[2 * node + 1] += m * (sum + kappa * excess) * c[1];
  Eigen::Vector2d const cc(c[0], c[1]);
  e.block[a] += m * kappa * cc * cc.transpose();
  e.link_area[side][a] += m * 6 * w * c;
  e.pressure[side][a] += m * w * stress / (6 * w);
  e.samples[side][a] += m * w;
}

/// c.u at the place where a link meets the face: of the nodes' velocity, and of the thickening.
double along(lbm::Link const& l, Hit const& hit, Eigen::VectorXd const& velocity)
{
  auto const at = [&](int a) {
    return D2Q9::cx(l.dir) * velocity[2 * a] + D2Q9::cy(l.dir) * velocity[2 * a + 1];
  };
  return (1 - hit.share) * at(hit.first) + hit.share * at(hit.second);
}

double thickening_along(lbm::Link const& l, CutLink const& m, Surface const& surface)
{
  double const sign = m.side == plus_side ? 1 : -1;
  auto const at = [&](int node) {
    auto const a = static_cast<std::size_t>(node);
    core::Vec2 const& n = surface.faces.normal[a];
    return sign * surface.thickening[a] * (D2Q9::cx(l.dir) * n[0] + D2Q9::cy(l.dir) * n[1]);
  };
  return (1 - m.hit.share) * at(m.hit.first) + m.hit.share * at(m.hit.second);
}

}  // namespace

template <class Real>
Sharp<Real> make_sharp(lbm::Fluid<Real>& fluid, lbm::Walls const& walls,
                       std::vector<lbm::WallHit> const& wall_hits,
                       structure::Membrane const& membrane, double divide, bool dry_plus,
                       SeatGapCells const& gap)
{
  Sharp<Real> body;
  body.walls = walls;
  body.wall_hits = wall_hits;
  body.divide = divide;
  body.cells = make_cells(walls, fluid.origin, dry_plus, gap);
  locate(body.surface, membrane);
  update(body.cells, body.surface, walls);
  rebuild_links(body, fluid);
  return body;
}

template <class Real>
void reflect_at_walls(Sharp<Real>& body, lbm::Fluid<Real>& fluid)
{
  lbm::bounce_back(fluid, body.resting, {});
  add_gain(body.mass, fluid, body.resting);
}

template <class Real>
void feel(Sharp<Real>& body, lbm::Fluid<Real>& fluid, structure::Membrane const& membrane)
{
  lbm::Fluid<Real> const from = fluid;
  auto const links = body.cut_links.links;
  auto const heard = body.heard;
  Kokkos::parallel_for(
      "velum::ibm::feel", body.cut_links.size, KOKKOS_LAMBDA(int k) {
        lbm::Link const l = links(k);
        int const cell = from.cell(l.i, l.j);
        auto const echo = lbm::echo(from, cell, l);
        Real rho = 0;
        for (int d = 0; d < 9; ++d) rho += from.f.outgoing(d, cell);
        heard(0, k) = double(echo.out);
        heard(1, k) = double(echo.back);
        heard(2, k) = 1 + double(rho);
      });
  auto const host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), heard);

  Exchange& e = body.exchange;
  reset(e, static_cast<std::size_t>(structure::node_count(membrane)));
  e.link_count = body.cut_links.size;
  for (std::size_t k = 0; k < body.cut.size(); ++k) {
    lbm::Link const& l = body.cut_host[k];
    CutLink const& m = body.cut[k];
    core::Vec2 const c = {double(D2Q9::cx(l.dir)), double(D2Q9::cy(l.dir))};
    double const kappa = lbm::wall_coefficient(l, host(2, k), fluid.model.viscosity),
                 w = D2Q9::w(l.dir);
    double const sum = host(0, k) + host(1, k) - kappa * thickening_along(l, m, body.surface);
    int const side = m.side == plus_side ? 0 : 1;
    double const cu = along(l, m.hit, membrane.velocity);
    auto const excess = [&](int node) {
      return c[0] * membrane.velocity[2 * node] + c[1] * membrane.velocity[2 * node + 1] - cu;
    };
    add(e, m.hit.first, 1 - m.hit.share, side, c, w, m.ring, sum, sum - kappa * cu, kappa,
        excess(m.hit.first));
    add(e, m.hit.second, m.hit.share, side, c, w, m.ring, sum, sum - kappa * cu, kappa,
        excess(m.hit.second));
  }
  for (int side : {0, 1})
    for (std::size_t a = 0; a < e.samples[side].size(); ++a)
      if (e.samples[side][a] > 0) e.pressure[side][a] /= e.samples[side][a];
}

template <class Real>
void impose(Sharp<Real>& body, lbm::Fluid<Real>& fluid, Eigen::VectorXd const& velocity,
            Ledger& ledger)
{
  auto const heard = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), body.heard);
  auto const term_host = Kokkos::create_mirror_view(body.wall_term);
  for (std::size_t k = 0; k < body.cut.size(); ++k) {
    lbm::Link const& l = body.cut_host[k];
    CutLink const& m = body.cut[k];
    double const cu = along(l, m.hit, velocity) + thickening_along(l, m, body.surface);
    double const term = lbm::wall_coefficient(l, heard(2, k), fluid.model.viscosity) * cu;
    term_host(k) = term;
    // a face that moves by u sweeps 6 w rho c.u along a link
    (m.downstream ? ledger.swept_down : ledger.swept_up) -=
        m.ring * 6 * D2Q9::w(l.dir) * heard(2, k) * cu;
    body.mass.surplus[static_cast<std::size_t>(l.region)] +=
        m.ring * (heard(1, k) - term - heard(0, k));
  }
  Kokkos::deep_copy(body.wall_term, term_host);
  lbm::Fluid<Real> const to = fluid;
  auto const links = body.cut_links.links;
  auto const reflected = body.heard;
  auto const term = body.wall_term;
  Kokkos::parallel_for(
      "velum::ibm::impose", body.cut_links.size, KOKKOS_LAMBDA(int k) {
        lbm::Link const l = links(k);
        to.f.set_arriving(D2Q9::opposite(l.dir), to.cell(l.i, l.j),
                          Real(reflected(1, k) - term(k)));
      });
  ledger.seat += seat_crossing(body, fluid);
  lbm::stream_and_collide(fluid);
}

namespace {

/// Uncovered sites of the last update and the neighbours that can fill them.
template <class Real>
std::vector<Uncovered> uncovered(Sharp<Real>& body, lbm::Fluid<Real> const& fluid)
{
  Cells const& cells = body.cells;
  std::vector<Uncovered> sites;
  for (CellChange const& c : cells.changes) {
    if (!is_fluid(c.after)) continue;
    unsigned from = 0;
    for (int d = 1; d < D2Q9::Q; ++d) {
      int const i = c.i + D2Q9::cx(d), j = c.j + D2Q9::cy(d);
      if (i < 0 || i >= fluid.nx || j < 0 || j >= fluid.ny) continue;
      bool const fresh =
          std::any_of(cells.changes.begin(), cells.changes.end(),
                      [&](CellChange const& other) { return other.i == i && other.j == j; });
      if (!fresh && cells.at(i, j) == c.after) from |= 1u << d;
    }
    sites.push_back({c.i, c.j, from});
    body.refilled += 1;
    body.orphans += from == 0;
  }
  return sites;
}

/// Follows the membrane where cells have changed.
template <class Real>
void change_cells(Sharp<Real>& body, lbm::Fluid<Real>& fluid)
{
  add_changed_cells(body.mass, fluid, body.cells, -1);
  refill(fluid, uncovered(body, fluid));
  rebuild_links(body, fluid);
  add_changed_cells(body.mass, fluid, body.cells, 1);
}

}  // namespace

template <class Real>
void move(Sharp<Real>& body, lbm::Fluid<Real>& fluid, structure::Membrane const& membrane)
{
  body.before = {body.surface.plus, body.surface.minus};
  locate(body.surface, membrane);
  subtract_swept(body.mass, body.cells, fluid_plus, body.before[0], body.surface.plus,
                 fluid.symmetry);
  subtract_swept(body.mass, body.cells, fluid_minus, body.before[1], body.surface.minus,
                 fluid.symmetry);
  if (update(body.cells, body.surface, body.walls))
    change_cells(body, fluid);
  else
    recut(body, fluid);
  if (fluid.f.step % budget_period == 0) take_back(body.mass, fluid);
}

template Sharp<float> make_sharp(lbm::Fluid<float>&, lbm::Walls const&,
                                 std::vector<lbm::WallHit> const&, structure::Membrane const&,
                                 double, bool, SeatGapCells const&);
template Sharp<double> make_sharp(lbm::Fluid<double>&, lbm::Walls const&,
                                  std::vector<lbm::WallHit> const&, structure::Membrane const&,
                                  double, bool, SeatGapCells const&);
template void reflect_at_walls(Sharp<float>&, lbm::Fluid<float>&);
template void reflect_at_walls(Sharp<double>&, lbm::Fluid<double>&);
template void feel(Sharp<float>&, lbm::Fluid<float>&, structure::Membrane const&);
template void feel(Sharp<double>&, lbm::Fluid<double>&, structure::Membrane const&);
template void impose(Sharp<float>&, lbm::Fluid<float>&, Eigen::VectorXd const&, Ledger&);
template void impose(Sharp<double>&, lbm::Fluid<double>&, Eigen::VectorXd const&, Ledger&);
template void move(Sharp<float>&, lbm::Fluid<float>&, structure::Membrane const&);
template void move(Sharp<double>&, lbm::Fluid<double>&, structure::Membrane const&);

}  // namespace velum::ibm
