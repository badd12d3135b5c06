#include "ibm/chambers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "structure/pressure_load.hpp"

namespace velum::ibm {
namespace {

double area_of(LatticePort const& p, std::vector<lbm::Opening> const& openings)
{
  double area = 0;
  for (std::size_t k : p.openings) area += openings[k].area;
  return area;
}

/// The law of the gap at this instant; none where one edge is not in the lattice.
void set_gap(Chambers& c, std::vector<lbm::Opening> const& openings, SeatContact const& seat,
             structure::Membrane const& membrane)
{
  GapFlow& g = *c.gap;
  g.gap = seat_gap(g.law, seat, membrane);
  bool const edges = openings[g.opening[0]].area > 0 && openings[g.opening[1]].area > 0;
  Passage& passage = c.network.passages[static_cast<std::size_t>(g.passage)];
  passage.loss = edges ? g.gap.loss : std::nullopt;
  if (passage.loss) {
    double const upstream = openings[g.opening[passage.flow >= 0 ? 0 : 1]].area;
    double const head = g.law.liquid.density / (2 * upstream * upstream);
    passage.loss->inertial = std::max(passage.loss->inertial - head, 0.0);
  }
  passage.inertance = g.gap.inertance;
}

}  // namespace

bool passes(Chambers const& c)
{
  return c.gap && c.network.passages[static_cast<std::size_t>(c.gap->passage)].loss.has_value();
}

double gap_flow(Chambers const& c)
{
  return c.network.passages[static_cast<std::size_t>(c.gap->passage)].flow;
}

void begin_step(Chambers& c, std::vector<lbm::Opening>& openings,
                structure::Membrane const& membrane, SeatContact const* seat)
{
  if (c.gap) set_gap(c, openings, *seat, membrane);
  for (LatticePort const& p : c.ports) {
    Port& port = c.network.ports[static_cast<std::size_t>(p.port)];
    double const area = area_of(p, openings);
    if (area <= 0) {  // when an edge comes back, nothing of what was there before counts
      for (std::size_t k : p.openings)
        openings[k].last_traction = std::numeric_limits<double>::quiet_NaN();
      continue;
    }
    port.pressure = 0;
    for (std::size_t k : p.openings) {
      lbm::Opening& o = openings[k];
      double const now = p.of_cells ? o.before : o.traction;
      double const last = std::isnan(o.last_traction) ? now : o.last_traction;
      port.pressure += (now + last) / 2 * o.area / area;
      o.last_traction = now;
    }
    port.impedance = lbm::sound / area;
    port.at_flow = port.flow;
  }
  Eigen::MatrixXd area = Eigen::MatrixXd::Zero(
      membrane.position.size(), static_cast<Eigen::Index>(c.network.chambers.size()));
  if (c.above >= 0)
    area.col(c.above) = structure::pressure_force(
        membrane, structure::uniform_pressure(membrane, structure::Side::plus, 1));
  c.flows = linearised(c.network, 1);
  c.enclosed = enclosures(c.network, c.flows, std::move(area));
}

void end_step(Chambers& c, std::vector<lbm::Opening> const& openings, std::vector<double>& targets,
              Eigen::VectorXd const& velocity)
{
  take_over(c.network, c.flows, c.enclosed, velocity, 1);
  for (LatticePort const& p : c.ports) {
    double const area = area_of(p, openings);
    double const flow = c.network.ports[static_cast<std::size_t>(p.port)].flow;
    for (std::size_t k : p.openings) targets[k] = area > 0 ? flow * openings[k].area / area : 0;
  }
}

}  // namespace velum::ibm
