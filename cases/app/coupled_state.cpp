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

/// What the film under the membrane takes over from the step before.
void exchange_gap(core::StateFile& file, ibm::SeatGap& gap)
{
  double values[] = {gap.least, gap.loss ? gap.loss->viscous : 0,
                     gap.loss ? gap.loss->inertial : 0};
  bool open = gap.loss.has_value();
  file.field("gap", values, std::size(values));
  file.number("gap open", open);
  file.number("gap narrowest", gap.narrowest);
  file.list("gap friction", gap.friction);
  file.list("gap narrowness", gap.narrowness);
  gap.least = values[0];
  gap.loss.reset();
  if (open) gap.loss = ibm::Loss{values[1], values[2]};
}

void exchange_chambers(core::StateFile& file, ibm::Chambers& c)
{
  std::string const other = "another set of chambers";
  file.same("chambers", double(c.network.chambers.size()), other);
  file.same("passages", double(c.network.passages.size()), other);
  file.same("ports", double(c.network.ports.size()), other);
  for (std::size_t k = 0; k < c.network.chambers.size(); ++k) {
    auto& chamber = c.network.chambers[k];
    double values[] = {chamber.pressure, chamber.content, chamber.swept};
    file.field(fmt::format("chamber {}", k), values, std::size(values));
    chamber.pressure = values[0];
    chamber.content = values[1];
    chamber.swept = values[2];
  }
  for (std::size_t k = 0; k < c.network.passages.size(); ++k)
    file.field(fmt::format("passage {}", k), c.network.passages[k].flow);
  for (std::size_t k = 0; k < c.network.ports.size(); ++k) {
    auto& p = c.network.ports[k];
    double values[] = {p.pressure, p.impedance, p.at_flow, p.flow};
    file.field(fmt::format("port {}", k), values, std::size(values));
    p = {values[0], values[1], values[2], values[3]};
  }
  if (c.gap) exchange_gap(file, c.gap->gap);
}

/// The acceleration, and the tangent that the coming steps may be taken with.
void exchange_stepper(core::StateFile& file, structure::ImplicitStepper& s)
{
  if (file.reading()) s.newton = std::make_unique<structure::NewtonMatrix>();
  auto& newton = *s.newton;
  std::vector<double> acceleration(s.acceleration.begin(), s.acceleration.end()), value;
  std::vector<std::int64_t> row, column;
  for (int k = 0; k < newton.K.outerSize(); ++k)
    for (Eigen::SparseMatrix<double>::InnerIterator it(newton.K, k); it; ++it) {
      row.push_back(it.row());
      column.push_back(it.col());
      value.push_back(it.value());
    }
  bool by_ldlt = newton.by_ldlt, fresh = newton.fresh;
  file.list("acceleration", acceleration);
  file.field("tangent step", s.tangent_step);
  file.list("tangent row", row);
  file.list("tangent column", column);
  file.list("tangent", value);
  file.number("tangent symmetric", by_ldlt);
  file.number("tangent fresh", fresh);
  if (!file.reading()) return;
  s.acceleration = Eigen::Map<Eigen::VectorXd const>(
      acceleration.data(), static_cast<Eigen::Index>(acceleration.size()));
  if (value.empty()) return;
  structure::Triplets entries;
  for (std::size_t k = 0; k < value.size(); ++k)
    entries.emplace_back(static_cast<int>(row[k]), static_cast<int>(column[k]), value[k]);
  // against no inertia every entry counts: what was left out is left out already
  structure::set_tangent<structure::Membrane>(newton, entries, s.K0, 1,
                                              Eigen::VectorXd::Zero(s.mass.size()));
  newton.by_ldlt = by_ldlt;
  newton.fresh = fresh;
}

void exchange_contact(core::StateFile& file, ibm::SeatContact& seat)
{
  file.field("contact offset", seat.markers.offset);
  file.list("contact multiplier", seat.contact.multiplier);
  // not where the membrane is but where its last forces were found: the film's edges lag
  auto& X = seat.markers.X;
  std::vector<double> places;
  for (auto const& x : X) places.insert(places.end(), {x[0], x[1]});
  file.field("contact place", places);
  for (std::size_t a = 0; a < X.size(); ++a) X[a] = {places[2 * a], places[2 * a + 1]};
}

void exchange_pressure(core::StateFile& file, ibm::FacePressure& pressure)
{
  file.number("face pressure known", pressure.started);
  file.list("pressure plus face", pressure.p[0]);
  file.list("pressure minus face", pressure.p[1]);
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
  if (state.seat) exchange_contact(file, *state.seat);
  if (auto* const implicit = std::get_if<structure::ImplicitStepper>(&state.stepper))
    exchange_stepper(file, *implicit);
  exchange_pressure(file, state.pressure);
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
  file.same("bytes of a population", sizeof(Real), "a run of another lattice.precision");
  file.same("time step", s.derived.units.dt,
            "another time step (it follows from lattice.mach and the largest pressure; "
            "lattice.time_step sets it)");
  file.same("implicit membrane", double(s.state.stepper.index()),
            "a run of another coupling.membrane");
  file.same("openings", double(s.state.openings.size()), "another set of openings");
  exchange_fluid(file, s.state.fluid);
  exchange_body(file, s);
  for (std::size_t k = 0; k < s.state.openings.size(); ++k)
    exchange_opening(file, fmt::format("opening {}", k), s.state.openings[k]);
  file.field("targets", s.state.targets);
  if (s.state.chambers) exchange_chambers(file, *s.state.chambers);
  file.list("water to take back", s.state.body.mass.surplus);
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
