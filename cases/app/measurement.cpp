#include "cases/app/measurement.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "cases/app/fluid_guard.hpp"
#include "cases/app/network_columns.hpp"
#include "core/check.hpp"

namespace velum::cases {

namespace {

/// Volume between x = 0 and the minus face, within the radius `divide`.
double volume_under(std::vector<core::Vec2> const& face, core::Symmetry symmetry, double divide)
{
  double volume = 0;
  for (std::size_t a = 0; a + 1 < face.size() && face[a][1] < divide; ++a) {
    core::Vec2 const p = face[a];
    core::Vec2 q = face[a + 1];
    if (q[1] > divide) q = p + ((divide - p[1]) / (q[1] - p[1])) * (q - p);
    double const dy = q[1] - p[1];
    volume +=
        symmetry == core::Symmetry::planar
            ? dy * (p[0] + q[0]) / 2
            : std::numbers::pi * dy * (p[0] * (2 * p[1] + q[1]) + q[0] * (p[1] + 2 * q[1])) / 3;
  }
  return volume;
}

/// The constant part of the volume: from the lattice's lower end to x = 0, solids left out.
template <class Real>
double cells_below_zero(lbm::Fluid<Real> const& fluid, core::Obstacle const& solids, double divide)
{
  double volume = 0;
  for (int j = 0; j < fluid.ny && fluid.origin[1] + j + 0.5 < divide; ++j) {
    double const y = fluid.origin[1] + j + 0.5;
    for (int i = 0; i < fluid.nx; ++i) {
      double const x = fluid.origin[0] + i + 0.5;
      if (x < 0 && core::distance(solids, {x, y}) > 0) volume += core::ring(fluid.symmetry, y);
    }
  }
  return volume;
}

}  // namespace

template <class Real, template <class> class Body>
void add_flows(Flows& flows, CoupledScene<Real, Body> const& s)
{
  for (std::size_t k = 0; k < s.state.openings.size(); ++k) {
    // mass over the density that the lattice has at that pressure: water would have the same volume
    lbm::Opening const& o = s.state.openings[k];
    double const in = o.mass_flow / (1 + 3 * o.traction);
    if (s.boundary[k] == "inlet") flows.in += in;
    if (s.boundary[k] != "outlet") continue;
    flows.out -= in;
    flows.recent -= in;
  }
  if (auto const& chambers = s.state.chambers) {
    if (s.key.outlet >= 0)
      flows.recent += chambers->network.ports[static_cast<std::size_t>(s.key.outlet)].flow;
    if (ibm::passes(*chambers)) flows.by_law += 1;
  }
  flows.steps += 1;
}

template <class Real, template <class> class Body>
Measurement measure(CoupledScene<Real, Body> const& s, Scene const& scene, Flows& flows,
                    double time)
{
  auto const& units = s.derived.units;
  auto const& fluid = s.state.fluid;
  auto const symmetry = fluid.symmetry;
  auto const pressure = [&](Zone z) { return core::to_si_pressure(units, mean_pressure(s, z)); };
  auto const volume = [&](double v) { return core::to_si_volume(units, symmetry, v); };
  Measurement m;
  m.time = time;
  auto const& chambers = s.state.chambers;
  bool const lumped_above = chambers && chambers->above >= 0;
  m.pressure_above =
      lumped_above ? core::to_si_pressure(units, ibm::pressure(chambers->network, chambers->above))
                   : pressure(Zone::above);
  m.pressure_outside = pressure(Zone::outside);
  m.pressure_inside = pressure(Zone::inside);
  double const inside = cells_below_zero(fluid, s.state.walls, s.divide) +
                        volume_under(s.state.body.surface.faces.minus, symmetry, s.divide);
  m.volume_inside = volume(inside);
  m.mass_inside = volume(inside * (1 + 3 * mean_pressure(s, Zone::inside)));
  m.centre = core::to_si_length(
      units, s.state.membrane.position[2 * structure::middle_node(s.state.membrane)]);
  if (s.state.seat) {
    auto const patch = contact::contact_patch(s.state.seat->contact, s.state.seat->markers);
    m.penetration = core::to_si_length(units, patch.penetration);
    m.seat_force = core::to_si_force(units, symmetry, patch.force);
    m.gap = core::to_si_length(units, ibm::narrowest_gap(*s.state.seat));
  }
  lbm::Observation const seen = lbm::observe(fluid);
  m.speed_max = core::to_si_velocity(units, seen.speed_max);
  m.pressure_least = core::to_si_pressure(units, seen.rho_min / 3);
  m.density_error = std::max(std::abs(seen.rho_min), std::abs(seen.rho_max));
  m.outflow = volume(flows.out);
  m.inflow = volume(flows.in);
  m.through_seat = volume(s.state.ledger.seat);
  m.through_membrane = volume(s.state.ledger.membrane_down);
  m.sealed = is_sealed(s);
  m.flow = flows.steps > 0 ? core::to_si_flow_rate(units, symmetry, flows.recent / flows.steps) : 0;
  m.gap_by_law = flows.steps > 0 ? flows.by_law / flows.steps : 0;
  flows.recent = flows.steps = flows.by_law = 0;
  if (chambers) m.network = network_row(chambers->network, s.key, scene, s.derived, time);
  add_stop(m.network, s.stop, s.state.membrane, s.derived);
  return m;
}

template <class Real, template <class> class Body>
std::string likely_cause(CoupledScene<Real, Body> const& s)
{
  if (s.state.scheme == ibm::Scheme::explicit_)
    return "coupling.scheme = \"explicit\" is unstable at this mass ratio; use \"implicit\"";
  if (s.state.fluid.model.collision != lbm::Collision::central_moments)
    return "this collision loses stability at tau - 1/2 below about 1e-3; use "
           "lattice.collision = \"central_moments\"";
  return "the time step is too long for what happens here; use a smaller lattice.mach";
}

template <class Real, template <class> class Body>
void guard(CoupledScene<Real, Body> const& s, lbm::Observation const& seen, long step)
{
  std::string const what = fault(seen);
  if (what.empty()) return;
  auto const& f = s.state.fluid;
  auto const worst = lbm::worst_cell(f);
  core::Vec2 const at = s.derived.units.dx * (f.origin + core::Vec2{worst.i + 0.5, worst.j + 0.5});
  throw core::Divergence(fmt::format(
      "Diverged at step {} (t = {:.4g} s): {}, worst in cell ({}, {}) at axial {:.3g} mm, radial "
      "{:.3g} mm. Likely cause: {}.",
      step, core::to_si_time(s.derived.units, double(step)), what, worst.i, worst.j, 1e3 * at[0],
      1e3 * at[1], likely_cause(s)));
}

template void add_flows(Flows&, CoupledScene<float, ibm::Sharp> const&);
template Measurement measure(CoupledScene<float, ibm::Sharp> const&, Scene const&, Flows&, double);
template void guard(CoupledScene<float, ibm::Sharp> const&, lbm::Observation const&, long);
template void add_flows(Flows&, CoupledScene<float, ibm::Diffuse> const&);
template Measurement measure(CoupledScene<float, ibm::Diffuse> const&, Scene const&, Flows&,
                             double);
template void guard(CoupledScene<float, ibm::Diffuse> const&, lbm::Observation const&, long);
template void add_flows(Flows&, CoupledScene<double, ibm::Sharp> const&);
template Measurement measure(CoupledScene<double, ibm::Sharp> const&, Scene const&, Flows&, double);
template void guard(CoupledScene<double, ibm::Sharp> const&, lbm::Observation const&, long);
template void add_flows(Flows&, CoupledScene<double, ibm::Diffuse> const&);
template Measurement measure(CoupledScene<double, ibm::Diffuse> const&, Scene const&, Flows&,
                             double);
template void guard(CoupledScene<double, ibm::Diffuse> const&, lbm::Observation const&, long);
template std::string likely_cause(CoupledScene<float, ibm::Sharp> const&);
template std::string likely_cause(CoupledScene<float, ibm::Diffuse> const&);
template std::string likely_cause(CoupledScene<double, ibm::Sharp> const&);
template std::string likely_cause(CoupledScene<double, ibm::Diffuse> const&);

}  // namespace velum::cases
