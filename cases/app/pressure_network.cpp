#include "cases/app/pressure_network.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/app/hydrostatic_scene.hpp"
#include "cases/app/pilot_lift.hpp"

namespace velum::cases {
namespace {

constexpr double shut_below = 1e-6;  // m: a lift that roughness bridges

/// Index of a port by the name of its boundary, or -1.
int find_port(NetworkKey const& key, std::string const& boundary)
{
  auto const found = std::find(key.port.begin(), key.port.end(), boundary);
  return found == key.port.end() ? -1 : static_cast<int>(found - key.port.begin());
}

int node_of(PressureNetwork const& n, Scene const& scene, std::string const& name)
{
  for (std::size_t k = 0; k < scene.chambers.size(); ++k)
    if (scene.chambers[k].name == name) return static_cast<int>(k);
  return static_cast<int>(n.network.chambers.size()) + find_port(n.key, name);
}

/// Loss of an orifice whose seat is open by a lift, lattice units; none when it is shut.
std::optional<ibm::Loss> loss_of(OrificeSection const& o, Derived const& d, double lift)
{
  double const dx = d.units.dx;
  ibm::Liquid const liquid{1, d.viscosity};
  double const diameter = std::sqrt(4 * o.area / std::numbers::pi);
  ibm::Loss loss =
      ibm::orifice_loss(liquid, o.area / (dx * dx), diameter / dx, o.discharge, o.transition);
  if (!o.seat) return loss;
  if (lift < shut_below) return {};
  loss += ibm::slit_loss(liquid, std::numbers::pi * o.seat->diameter / dx, lift / dx,
                         o.seat->land / dx, o.seat->discharge);
  return loss;
}

}  // namespace

double lift_at(OrificeSection const& o, Curve const& lift, double time)
{
  if (!o.seat) return 0;
  double const moved = value_at(o.seat->lift, time);
  return lift.at.empty() ? moved : value_at(lift, moved);
}

PressureNetwork make_network(Scene const& scene, Derived const& d, int regions)
{
  PressureNetwork n;
  auto const symmetry = velum::cases::symmetry(scene);
  for (auto const& c : scene.chambers) {
    if (c.side == ChamberSide::above) n.key.above = static_cast<int>(n.network.chambers.size());
    double const modulus = core::to_lattice_pressure(d.units, c.bulk_modulus);
    n.network.chambers.push_back(
        {core::to_lattice_volume(d.units, symmetry, c.volume) / modulus,
         core::to_lattice_pressure(d.units, c.initial.value_or(inlet_pressure(scene, 0)))});
  }
  for (int k = 0; k < regions; ++k) n.network.chambers.push_back({});
  for (auto const& b : scene.boundaries) {
    n.key.port.push_back(b.name);
    n.network.ports.push_back({});
  }
  n.key.inlet = find_port(n.key, "inlet");
  n.key.outlet = find_port(n.key, "outlet");
  for (auto const& o : scene.orifices) {
    n.network.passages.push_back({node_of(n, scene, o.from), node_of(n, scene, o.to), std::nullopt,
                                  o.length * d.units.dx / o.area});
    n.key.lift.push_back({});
    if (o.member)
      n.key.lift.back() = pilot_lift(*o.member, scene.materials.at(o.member->material),
                                     o.seat->diameter / 2, largest_magnitude(o.seat->lift));
  }
  set_network(n.network, n.key, scene, d, 0, false);
  return n;
}

void set_network(ibm::Network& network, NetworkKey const& key, Scene const& scene, Derived const& d,
                 double time, bool shut)
{
  for (std::size_t k = 0; k < key.port.size(); ++k) {
    auto const& boundary = scene.boundaries[k];
    if (boundary.kind != BoundaryKind::port)
      network.ports[k].pressure =
          core::to_lattice_pressure(d.units, value_at(boundary.value, time));
  }
  for (std::size_t k = 0; k < key.lift.size(); ++k)
    network.passages[k].loss =
        loss_of(scene.orifices[k], d, lift_at(scene.orifices[k], key.lift[k], time));
  if (!shut || key.inlet < 0) return;
  int const inlet = static_cast<int>(network.chambers.size()) + key.inlet;
  for (auto& p : network.passages)
    if (p.from == inlet || p.to == inlet) p.loss.reset();
}

}  // namespace velum::cases
