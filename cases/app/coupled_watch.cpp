#include "cases/app/coupled_watch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ibm/contact_load.hpp"

namespace velum::cases {
namespace {

constexpr std::size_t looks = 60, steps = 400;  // kept

// A tenth of where a lattice is in trouble, that is usual everywhere: lattice units.
constexpr double usual_mach = 0.03;
constexpr double usual_speed = 0.01;
constexpr double usual_density = 0.02;
constexpr double usual_stretch = 0.1;
constexpr double usual_penetration = 0.05;
/// Pressure that drives a flow of usual speed, rho u^2 / 2 at Mach 0.1.
constexpr double usual_pressure = 0.1 * 0.1 / 6;

double largest_stretch(structure::Membrane const& m)
{
  double stretch = 0;
  for (int a = 0; a + 1 < structure::node_count(m); ++a) {
    auto const now = structure::node(m.position, a + 1) - structure::node(m.position, a);
    auto const before = structure::node(m.reference, a + 1) - structure::node(m.reference, a);
    double const s = core::norm(now) / core::norm(before) - 1;
    if (!(s <= stretch)) stretch = s;
  }
  return stretch;
}

/// Largest magnitude; a number that is none counts as largest.
template <class Range>
double largest(Range const& values)
{
  double most = 0;
  for (double const v : values)
    if (!(std::abs(v) <= most)) most = std::abs(v);
  return most;
}

double seat_force(ibm::SeatContact const& seat)
{
  double force = 0;
  for (auto const& f : seat.markers.F) force += core::norm(f);
  return force;
}

template <class Real, template <class> class Body>
double usual_force(CoupledScene<Real, Body> const& s)
{
  double area = 0;
  for (double const a : s.state.seat->markers.area) area += a;
  return usual_pressure * area;
}

/// What the scene imposes: names, and ranges that are usual, SI.
std::vector<Watched> inputs(Scene const& scene, Derived const& d)
{
  std::vector<Watched> all;
  for (auto const& b : scene.boundaries) {
    if (b.value.at.empty() || b.kind == BoundaryKind::port) continue;
    bool const pressure = imposes_pressure(b.kind);
    double const usual = pressure ? core::to_si_pressure(d.units, usual_pressure)
                                  : largest_magnitude(constant(value_at(b.value, 0)));
    char const* const unit = pressure ? "Pa" : b.kind == BoundaryKind::flow_rate ? "m3/s" : "m/s";
    all.push_back({"input_" + b.name, unit, Cause::input, usual});
  }
  return all;
}

std::vector<double> input_values(Scene const& scene, double time)
{
  std::vector<double> all;
  for (auto const& b : scene.boundaries)
    if (!b.value.at.empty() && b.kind != BoundaryKind::port) all.push_back(value_at(b.value, time));
  return all;
}

}  // namespace

template <class Real, template <class> class Body>
CoupledWatch make_watch(CoupledScene<Real, Body> const& s, Scene const& scene)
{
  CoupledWatch watch{{{{"mach", "1", Cause::fluid, usual_mach},
                       {"cell_x", "1", Cause::none},
                       {"cell_y", "1", Cause::none},
                       {"density_least", "1", Cause::fluid, usual_density},
                       {"density_largest", "1", Cause::fluid, usual_density},
                       {"fluid_mass", "1", Cause::none},
                       {"membrane_speed", "1", Cause::structure, usual_speed},
                       {"membrane_stretch", "1", Cause::structure, usual_stretch},
                       {"links", "1", Cause::none}},
                      looks},
                     {inputs(scene, s.derived), steps}};
  auto& steps = watch.steps.watched;
  steps.push_back({"face_pressure", "1", Cause::fluid, usual_pressure});
  steps.push_back({"opening_speed", "1", Cause::fluid, usual_speed});
  steps.push_back({"membrane_speed", "1", Cause::structure, usual_speed});
  if (s.state.seat) {
    auto& w = watch.looks.watched;
    w.push_back({"gap", "1", Cause::none});
    w.push_back({"penetration", "1", Cause::contact, usual_penetration});
    w.push_back({"seat_force", "1", Cause::contact, usual_force(s)});
    steps.push_back({"seat_force", "1", Cause::contact, usual_force(s)});
  }
  if (s.state.chambers)
    for (auto const& c : scene.chambers)
      watch.looks.watched.push_back({"pressure_" + c.name, "1", Cause::none});
  return watch;
}

template <class Real, template <class> class Body>
void note_step(CoupledWatch& watch, CoupledScene<Real, Body> const& s, Scene const& scene, long n,
               double time)
{
  auto values = input_values(scene, time);
  auto const& e = s.state.body.exchange;
  std::vector<double> openings;
  for (auto const& o : s.state.openings) openings.push_back(o.velocity);
  values.push_back(std::max(largest(e.pressure[0]), largest(e.pressure[1])));
  values.push_back(largest(openings));
  values.push_back(largest(s.state.membrane.velocity));
  if (s.state.seat) values.push_back(seat_force(*s.state.seat));
  note(watch.steps, n, core::to_si_time(s.derived.units, double(n)), std::move(values));
}

template <class Real, template <class> class Body>
void note_look(CoupledWatch& watch, CoupledScene<Real, Body> const& s, lbm::Observation const& seen,
               long n, double time)
{
  auto const worst = lbm::worst_cell(s.state.fluid);
  double const broken = seen.not_finite > 0 ? std::nan("") : 1;
  std::vector<double> values = {broken * seen.speed_max * std::numbers::sqrt3,
                                double(worst.i),
                                double(worst.j),
                                seen.rho_min,
                                seen.rho_max,
                                seen.mass,
                                largest(s.state.membrane.velocity),
                                largest_stretch(s.state.membrane),
                                double(s.state.body.exchange.link_count)};
  if (s.state.seat) {
    double const gap = ibm::narrowest_gap(*s.state.seat);
    values.insert(values.end(), {gap, std::max(0.0, -gap), seat_force(*s.state.seat)});
  }
  if (s.state.chambers)
    for (std::size_t k = 0; values.size() < watch.looks.watched.size(); ++k)
      values.push_back(s.state.chambers->network.chambers[k].pressure);
  note(watch.looks, n, time, std::move(values));
}

std::string open_black_box(CoupledWatch const& watch, std::filesystem::path const& folder)
{
  write(watch.looks, folder / "blackbox.csv");
  write(watch.steps, folder / "blackbox_steps.csv");
  return in_words(departures({&watch.looks, &watch.steps}));
}

template CoupledWatch make_watch(CoupledScene<float, ibm::Sharp> const&, Scene const&);
template void note_step(CoupledWatch&, CoupledScene<float, ibm::Sharp> const&, Scene const&, long,
                        double);
template void note_look(CoupledWatch&, CoupledScene<float, ibm::Sharp> const&,
                        lbm::Observation const&, long, double);
template CoupledWatch make_watch(CoupledScene<float, ibm::Diffuse> const&, Scene const&);
template void note_step(CoupledWatch&, CoupledScene<float, ibm::Diffuse> const&, Scene const&, long,
                        double);
template void note_look(CoupledWatch&, CoupledScene<float, ibm::Diffuse> const&,
                        lbm::Observation const&, long, double);
template CoupledWatch make_watch(CoupledScene<double, ibm::Sharp> const&, Scene const&);
template void note_step(CoupledWatch&, CoupledScene<double, ibm::Sharp> const&, Scene const&, long,
                        double);
template void note_look(CoupledWatch&, CoupledScene<double, ibm::Sharp> const&,
                        lbm::Observation const&, long, double);
template CoupledWatch make_watch(CoupledScene<double, ibm::Diffuse> const&, Scene const&);
template void note_step(CoupledWatch&, CoupledScene<double, ibm::Diffuse> const&, Scene const&,
                        long, double);
template void note_look(CoupledWatch&, CoupledScene<double, ibm::Diffuse> const&,
                        lbm::Observation const&, long, double);

}  // namespace velum::cases
