#include "cases/app/lumped_scene.hpp"

#include "cases/app/geometry.hpp"

namespace velum::cases {
namespace {

/// Replaces ports that lie in a region by it: within the seat or beyond.
void join_ports(LumpedScene& s, Scene const& scene)
{
  auto const chambers = static_cast<int>(s.state.network.chambers.size());
  auto const region = [&](int node) {
    if (node < chambers) return node;
    auto const& b = scene.boundaries[static_cast<std::size_t>(node - chambers)];
    if (b.kind != BoundaryKind::port) return node;
    double const y = (b.patches[0].from[0] + b.patches[0].to[0]) / 2 / s.derived.units.dx;
    return y < s.state.gap.at[1] ? s.state.inside : s.state.outside;
  };
  for (auto& p : s.state.network.passages) {
    p.from = region(p.from);
    p.to = region(p.to);
  }
}

/// Column of liquid between an opening and a region, in lattice units: the velocity head that goes
/// out with the flow is lost, and a little friction keeps the law smooth.
ibm::Passage column(Scene const& scene, Derived const& d, int from, int to,
                    std::string const& boundary, double length)
{
  double const dx = d.units.dx, area = opening_area(scene, boundary) / (dx * dx);
  constexpr double smooth_below = 100;  // Reynolds number
  auto const loss = ibm::orifice_loss({1, d.viscosity}, area, std::sqrt(area), 1, smooth_below);
  return {from, to, loss, length / dx / area};
}

}  // namespace

LumpedScene make_lumped_scene(Scene const& scene, Derived const& d, HydrostaticScene const& start)
{
  bool const has_above = find_chamber(scene, ChamberSide::above) != nullptr;
  auto made = make_network(scene, d, has_above ? 2 : 3);
  LumpedScene s{d, std::move(made.key), {}};
  s.stop = start.stop;
  auto& state = s.state;
  state.membrane = start.membrane;
  state.loads = start.loads;
  state.seat = start.seat;
  state.loads.push_back(ibm::contact_load(state.seat));
  state.lip = start.load.lip;
  state.law = {{1, d.viscosity}, scene.gap.discharge, scene.gap.seals_at / d.units.dx};
  state.stepper = membrane_stepper(scene, d, start);
  state.substeps = start.substeps;
  state.network = std::move(made.network);

  auto& network = state.network;
  auto const chambers = static_cast<int>(network.chambers.size());
  state.above = has_above ? s.key.above : chambers - 3;
  state.outside = chambers - 2;
  state.inside = chambers - 1;
  for (auto [k, p] : {std::pair{state.above, start.load.above},
                      {state.outside, start.load.outside},
                      {state.inside, start.load.inside}})
    network.chambers[static_cast<std::size_t>(k)].pressure = p;
  int const inlet = chambers + s.key.inlet, outlet = chambers + s.key.outlet;
  state.gap_passage = static_cast<int>(network.passages.size());
  network.passages.push_back({state.outside, state.inside, std::nullopt});
  network.passages.push_back(
      column(scene, d, inlet, state.outside, "inlet", scene.gap.inlet_length));
  network.passages.push_back(
      column(scene, d, state.inside, outlet, "outlet", scene.gap.outlet_length));
  if (!has_above) network.passages.push_back(column(scene, d, inlet, state.above, "inlet", 0));
  ibm::locate(state);
  join_ports(s, scene);
  fill(network);
  return s;
}

double outflow(LumpedScene const& s)
{
  return s.state.network.ports[static_cast<std::size_t>(s.key.outlet)].flow;
}

}  // namespace velum::cases
