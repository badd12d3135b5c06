#include "ibm/diffuse.hpp"

#include <utility>

#include "ibm/crossing.hpp"
#include "lbm/bounce_back.hpp"
#include "lbm/stream_and_collide.hpp"

namespace velum::ibm {

namespace {

/// What one marker found in the fluid.
struct Heard {
  core::Vec2 U;
  double strength;  // 2 rho A, zero for a marker inside a wall
};

template <class HostField>
Heard heard_by(FaceMarker const& marker, HostField const& heard, std::size_t k)
{
  return {{heard(0, k), heard(1, k)}, 2 * heard(2, k) * marker.area * heard(3, k)};
}

core::Vec2 velocity_at(FaceMarker const& m, Eigen::VectorXd const& velocity)
{
  return (1 - m.share) * structure::node(velocity, m.first) +
         m.share * structure::node(velocity, m.second) + m.drift;
}

void add(Exchange& e, int node, double strength, core::Vec2 U)
{
  e.force[2 * node] += strength * U[0];
  e.force[2 * node + 1] += strength * U[1];
  e.block[static_cast<std::size_t>(node)].diagonal().array() += strength;
}

template <class Real>
void mark_active(Diffuse<Real> const& body, lbm::Fluid<Real>& fluid)
{
  std::vector<std::uint8_t> mask = body.labels.side;
  for (std::size_t c = 0; c < mask.size(); ++c)
    if (body.walls.solid[c]) mask[c] = 0;
  lbm::mark(fluid, mask);
}

template <class Real>
void place_markers(Diffuse<Real>& body, lbm::Fluid<Real> const& fluid)
{
  place(body.markers, body.surface, fluid.symmetry);
  auto const& list = body.markers.list;
  if (body.stencils.extent(0) < list.size()) {
    std::size_t const room = list.size() * 5 / 4 + 16;
    body.stencils = Stencils("stencils", room);
    body.X = MarkerField("X", 2, room);
    body.heard = MarkerField("heard", 4, room);
    body.F = MarkerField("F", 2, room);
  }
  auto const X_host = Kokkos::create_mirror_view(body.X);
  for (std::size_t k = 0; k < list.size(); ++k)
    for (int d : {0, 1}) X_host(d, k) = list[k].X[d];
  Kokkos::deep_copy(body.X, X_host);
  locate(fluid, body.X, body.stencils, static_cast<int>(list.size()));
}

}  // namespace

template <class Real>
Diffuse<Real> make_diffuse(lbm::Fluid<Real>& fluid, lbm::Walls const& walls,
                           std::vector<lbm::WallHit> const& wall_hits,
                           structure::Membrane const& membrane, double divide)
{
  Diffuse<Real> body;
  body.walls = walls;
  body.divide = divide;
  std::vector<lbm::Link> resting;
  for (lbm::WallHit const& h : wall_hits) resting.push_back(lbm::link_at(fluid, walls, h));
  lbm::upload(body.resting, resting);
  lbm::use_force_field(fluid);
  body.labels = make_labels(fluid.nx, fluid.ny, fluid.origin);
  locate(body.surface, membrane);
  classify(body.labels, body.surface);
  mark_active(body, fluid);
  place_markers(body, fluid);
  return body;
}

template <class Real>
void reflect_at_walls(Diffuse<Real>& body, lbm::Fluid<Real>& fluid)
{
  lbm::bounce_back(fluid, body.resting, {});
}

template <class Real>
void feel(Diffuse<Real>& body, lbm::Fluid<Real>& fluid, structure::Membrane const& membrane)
{
  auto const& list = body.markers.list;
  interpolate(fluid, body.stencils, body.heard, static_cast<int>(list.size()));
  auto const heard = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), body.heard);
  reset(body.exchange, static_cast<std::size_t>(structure::node_count(membrane)));
  for (std::size_t k = 0; k < list.size(); ++k) {
    FaceMarker const& m = list[k];
    auto const [U, strength] = heard_by(m, heard, k);
    // the block falls with the node's own velocity, the force with the marker's (ibm/sharp.hpp)
    core::Vec2 const at_marker = velocity_at(m, membrane.velocity);
    for (auto const& [node, share] : {std::pair{m.first, 1 - m.share}, {m.second, m.share}})
      add(body.exchange, node, share * strength,
          U + structure::node(membrane.velocity, node) - at_marker);
  }
}

template <class Real>
void impose(Diffuse<Real>& body, lbm::Fluid<Real>& fluid, Eigen::VectorXd const& velocity,
            Ledger& ledger)
{
  auto const& list = body.markers.list;
  auto const heard = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), body.heard);
  auto const F_host = Kokkos::create_mirror_view(body.F);
  double swept_up = 0, swept_down = 0;
  for (std::size_t k = 0; k < list.size(); ++k) {
    FaceMarker const& m = list[k];
    auto const [U, strength] = heard_by(m, heard, k);
    core::Vec2 const V = velocity_at(m, velocity);
    for (int d : {0, 1}) F_host(d, k) = strength * (V[d] - U[d]);
    bool const downstream = !m.plus && m.X[1] < body.divide;
    (downstream ? swept_down : swept_up) += strength / 2 * dot(V, m.outward);
  }
  Kokkos::deep_copy(body.F, F_host);
  spread(fluid, body.stencils, body.F, static_cast<int>(list.size()));

  Crossing const crossed = crossing(fluid, body.divide);
  ledger.swept_up += swept_up;
  ledger.swept_down += swept_down;
  ledger.membrane_up += crossed.up - swept_up;
  ledger.membrane_down += crossed.down - swept_down;
  ledger.seat += crossed.seat;
  lbm::stream_and_collide(fluid);
}

template <class Real>
void move(Diffuse<Real>& body, lbm::Fluid<Real>& fluid, structure::Membrane const& membrane)
{
  locate(body.surface, membrane);
  if (classify(body.labels, body.surface)) mark_active(body, fluid);
  place_markers(body, fluid);
}

template Diffuse<float> make_diffuse(lbm::Fluid<float>&, lbm::Walls const&,
                                     std::vector<lbm::WallHit> const&, structure::Membrane const&,
                                     double);
template Diffuse<double> make_diffuse(lbm::Fluid<double>&, lbm::Walls const&,
                                      std::vector<lbm::WallHit> const&, structure::Membrane const&,
                                      double);
template void reflect_at_walls(Diffuse<float>&, lbm::Fluid<float>&);
template void reflect_at_walls(Diffuse<double>&, lbm::Fluid<double>&);
template void feel(Diffuse<float>&, lbm::Fluid<float>&, structure::Membrane const&);
template void feel(Diffuse<double>&, lbm::Fluid<double>&, structure::Membrane const&);
template void impose(Diffuse<float>&, lbm::Fluid<float>&, Eigen::VectorXd const&, Ledger&);
template void impose(Diffuse<double>&, lbm::Fluid<double>&, Eigen::VectorXd const&, Ledger&);
template void move(Diffuse<float>&, lbm::Fluid<float>&, structure::Membrane const&);
template void move(Diffuse<double>&, lbm::Fluid<double>&, structure::Membrane const&);

}  // namespace velum::ibm
