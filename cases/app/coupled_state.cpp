#include "cases/app/coupled_state.hpp"

#include <fmt/format.h>

#include "core/check.hpp"
#include "ibm/sharp_links.hpp"

namespace velum::cases {
namespace {

template <class Real>
void exchange_fluid(core::StateFile& file, lbm::Fluid<Real>& fluid)
{
  auto const host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), fluid.f.slots);
  for (std::size_t d = 0; d < host.extent(0); ++d)
    file.field(fmt::format("populations {}", d), &host(d, 0), host.extent(1));
  file.number("fluid step", fluid.f.step);
  if (file.reading()) Kokkos::deep_copy(fluid.f.slots, host);
}

void exchange_opening(core::StateFile& file, std::string const& name, lbm::Opening& o)
{
  double values[] = {o.velocity, o.integral,  o.last_traction, o.slow_velocity,
                     o.pressure, o.mass_flow, o.traction};
  file.field(name, values, std::size(values));
  file.number(name + " kind", o.kind);
  o.velocity = values[0];
  o.integral = values[1];
  o.last_traction = values[2];
  o.slow_velocity = values[3];
  o.pressure = values[4];
  o.mass_flow = values[5];
  o.traction = values[6];
}

void exchange_chambers(core::StateFile& file, ibm::Chambers& c)
{
  for (std::size_t k = 0; k < c.network.chambers.size(); ++k) {
    auto& chamber = c.network.chambers[k];
    double values[] = {chamber.pressure, chamber.content, c.volume[k]};
    file.field(fmt::format("chamber {}", k), values, std::size(values));
    chamber.pressure = values[0];
    chamber.content = values[1];
    c.volume[k] = values[2];
  }
  for (std::size_t k = 0; k < c.network.passages.size(); ++k)
    file.field(fmt::format("passage {}", k), c.network.passages[k].flow);
  for (std::size_t k = 0; k < c.network.ports.size(); ++k)
    file.field(fmt::format("port {}", k), c.network.ports[k].flow);
}

void exchange_sums(core::StateFile& file, ibm::Ledger& l, Flows& f)
{
  double values[] = {l.swept_up, l.swept_down, l.membrane_up, l.membrane_down, l.seat,
                     f.out,      f.in,         f.recent,      f.steps,         f.by_law};
  file.field("sums", values, std::size(values));
  l = {values[0], values[1], values[2], values[3], values[4]};
  f = {values[5], values[6], values[7], values[8], values[9]};
}

template <class Real>
void exchange_body(core::StateFile& file, CoupledScene<Real, ibm::Sharp>& s)
{
  auto& state = s.state;
  auto& m = state.membrane;
  file.field("position", m.position.data(), static_cast<std::size_t>(m.position.size()));
  file.field("velocity", m.velocity.data(), static_cast<std::size_t>(m.velocity.size()));
  if (state.seat) {
    file.field("contact offset", state.seat->markers.offset);
    file.field("contact multiplier", state.seat->contact.multiplier);
    if (file.reading()) ibm::press(*state.seat, m.position);
  }
  file.field("divide", s.divide);
  state.body.divide = s.divide;
  // the faces follow from the positions, but for the mean rate of their distance
  if (file.reading()) ibm::locate(state.body.surface, m);
  file.field("thickening", state.body.surface.thickening);
  // a film knows whether it was one before
  file.field("cells", state.body.cells.state);
  if (file.reading()) {
    ibm::update(state.body.cells, state.body.surface, state.body.walls);
    ibm::rebuild_links(state.body, state.fluid);
  }
}

}  // namespace

template <class Real>
void exchange_state(core::StateFile& file, CoupledScene<Real, ibm::Sharp>& s, Flows& flows)
{
  exchange_fluid(file, s.state.fluid);
  exchange_body(file, s);
  for (std::size_t k = 0; k < s.state.openings.size(); ++k)
    exchange_opening(file, fmt::format("opening {}", k), s.state.openings[k]);
  file.field("targets", s.state.targets);
  if (s.state.chambers) exchange_chambers(file, *s.state.chambers);
  exchange_sums(file, s.state.ledger, flows);
}

template <class Real>
void restart_sums(CoupledScene<Real, ibm::Sharp>& s, Flows& flows)
{
  s.state.ledger = {};
  flows = {};
}

template void exchange_state(core::StateFile&, CoupledScene<float, ibm::Sharp>&, Flows&);
template void exchange_state(core::StateFile&, CoupledScene<double, ibm::Sharp>&, Flows&);
template void restart_sums(CoupledScene<float, ibm::Sharp>&, Flows&);
template void restart_sums(CoupledScene<double, ibm::Sharp>&, Flows&);

}  // namespace velum::cases
