#include "cases/app/fall_back.hpp"

#include <cmath>

#include "ibm/sharp_links.hpp"

namespace velum::cases {
namespace {

std::vector<double> times(std::vector<double> values, double factor)
{
  for (double& v : values) v *= factor;
  return values;
}

/// What a fluid's populations are beside their equilibrium, on the time scale of another one.
double strain_factor(lbm::Model const& from, lbm::Model const& to, double r)
{
  double const tau = 1 / from.omega(), other = 1 / to.omega();
  // at tau = 1 a collision leaves nothing of it
  return std::abs(tau - 1) > 1e-6 ? r * (other - 1) / (tau - 1) : 0;
}

template <class Real>
void carry_fluid(lbm::Fluid<Real> const& from, lbm::Fluid<Real>& to, double r)
{
  auto const states = lbm::cell_states(from);
  lbm::CellStates scaled("scaled", states.extent(0), states.extent(1));
  for (std::size_t j = 0; j < states.extent(0); ++j)
    for (std::size_t i = 0; i < states.extent(1); ++i) {
      auto const& s = states(j, i);
      scaled(j, i) = {r * r * s.rho, r * s.ux, r * s.uy};
    }
  lbm::Fluid<Real> rest = from;
  rest.f.slots =
      decltype(rest.f.slots)("equilibrium", from.f.slots.extent(0), from.f.slots.extent(1));
  lbm::set_equilibrium(rest, states);
  lbm::set_equilibrium(to, scaled);
  auto const factor = Real(strain_factor(from.model, to.model, r));
  lbm::Fluid<Real> const old = from, equal = rest, now = to;
  Kokkos::parallel_for(
      "velum::cases::carry_fluid", Kokkos::RangePolicy<>(0, from.cells()), KOKKOS_LAMBDA(long c) {
        int const cell = old.cell_of(c);
        if (!old.active(cell)) return;
        for (int d = 0; d < lbm::D2Q9::Q; ++d)
          now.f.set_outgoing(d, cell,
                             now.f.outgoing(d, cell) +
                                 factor * (old.f.outgoing(d, cell) - equal.f.outgoing(d, cell)));
      });
}

template <class Real>
void carry_membrane(ibm::Coupled<Real, ibm::Sharp> const& from, ibm::Coupled<Real, ibm::Sharp>& to,
                    double r)
{
  to.membrane.position = from.membrane.position;
  to.membrane.velocity = r * from.membrane.velocity;
  if (from.seat) {
    to.seat->contact.stiffness = r * r * from.seat->contact.stiffness;
    to.seat->contact.multiplier = times(from.seat->contact.multiplier, r * r);
    to.seat->markers.offset = from.seat->markers.offset;
    to.seat->markers.X = from.seat->markers.X;
  }
  auto const* old = std::get_if<structure::ImplicitStepper>(&from.stepper);
  if (auto* const now = std::get_if<structure::ImplicitStepper>(&to.stepper); now && old)
    now->acceleration = r * r * old->acceleration;
  to.pressure.started = from.pressure.started;
  for (int side : {0, 1}) to.pressure.p[side] = times(from.pressure.p[side], r * r);
  to.body.divide = from.body.divide;
  ibm::locate(to.body.surface, to.membrane);
  to.body.surface.thickening = times(from.body.surface.thickening, r);
  to.body.cells.state = from.body.cells.state;
  ibm::update(to.body.cells, to.body.surface, to.body.walls);
  ibm::rebuild_links(to.body, to.fluid);
}

void carry_opening(lbm::Opening const& from, lbm::Opening& to, double r)
{
  to.kind = from.kind;
  to.velocity = r * from.velocity;
  // the pressure's part of the velocity, against rho c_s, is r times as large now: what is left of
  // it goes on in the integral, or the inlet would jump
  to.integral = r * (from.integral + (1 - r) * (from.velocity - from.integral));
  to.slow_velocity = r * from.slow_velocity;
  to.mass_flow = r * from.mass_flow;
  to.pressure = r * r * from.pressure;
  to.traction = r * r * from.traction;
  to.last_traction = r * r * from.last_traction;
}

void carry_chambers(ibm::Chambers const& from, ibm::Chambers& to, double r)
{
  for (std::size_t k = 0; k < from.network.chambers.size(); ++k) {
    to.network.chambers[k].pressure = r * r * from.network.chambers[k].pressure;
    to.network.chambers[k].content = from.network.chambers[k].content;
    to.network.chambers[k].swept = from.network.chambers[k].swept;
  }
  for (std::size_t k = 0; k < from.network.passages.size(); ++k)
    to.network.passages[k].flow = r * from.network.passages[k].flow;
  for (std::size_t k = 0; k < from.network.ports.size(); ++k) {
    auto const& p = from.network.ports[k];
    to.network.ports[k] = {r * r * p.pressure, p.impedance, r * p.at_flow, r * p.flow};
  }
  if (!from.gap) return;
  to.gap->gap = from.gap->gap;
  if (to.gap->gap.loss) to.gap->gap.loss->viscous *= r;
}

}  // namespace

Scene slower(Scene scene, long times)
{
  for (; times > 0; --times) {  // one by one, as runs do: the time step keeps its last digit
    scene.lattice.mach *= fall_back_share;
    if (scene.lattice.time_step) *scene.lattice.time_step *= fall_back_share;
  }
  return scene;
}

template <class Real>
void carry_over(CoupledScene<Real, ibm::Sharp> const& from, CoupledScene<Real, ibm::Sharp>& to,
                Flows& flows)
{
  double const r = to.derived.units.dt / from.derived.units.dt;
  to.divide = from.divide;
  carry_membrane(from.state, to.state, r);
  carry_fluid(from.state.fluid, to.state.fluid, r);
  for (std::size_t k = 0; k < from.state.openings.size(); ++k)
    carry_opening(from.state.openings[k], to.state.openings[k], r);
  to.state.targets = times(from.state.targets, r);  // of ports; the others are set in every step
  if (from.state.chambers) carry_chambers(*from.state.chambers, *to.state.chambers, r);
  to.state.ledger = from.state.ledger;
  to.state.membrane_seconds = from.state.membrane_seconds;
  flows.steps /= r;
  flows.by_law /= r;
}

template void carry_over(CoupledScene<float, ibm::Sharp> const&, CoupledScene<float, ibm::Sharp>&,
                         Flows&);
template void carry_over(CoupledScene<double, ibm::Sharp> const&, CoupledScene<double, ibm::Sharp>&,
                         Flows&);

}  // namespace velum::cases
