#include "ibm/chambers.hpp"

#include "structure/pressure_load.hpp"

namespace velum::ibm {
namespace {

constexpr double sound = 0.57735026918962576;  // 1/sqrt(3)

double area_of(LatticePort const& p, std::vector<lbm::Opening> const& openings)
{
  double area = 0;
  for (std::size_t k : p.openings) area += openings[k].area;
  return area;
}

}  // namespace

void begin_step(Chambers& c, std::vector<lbm::Opening> const& openings,
                structure::Membrane const& membrane)
{
  for (LatticePort const& p : c.ports) {
    Port& port = c.network.ports[static_cast<std::size_t>(p.port)];
    double const area = area_of(p, openings);
    port.pressure = 0;
    for (std::size_t k : p.openings)
      port.pressure += openings[k].traction * openings[k].area / area;
    port.impedance = sound / area;
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
  add_swept(c.volume, c.enclosed, velocity, 1);
  take_over(c.network, c.flows, c.enclosed, c.volume, 1);
  for (LatticePort const& p : c.ports) {
    double const area = area_of(p, openings);
    double const flow = c.network.ports[static_cast<std::size_t>(p.port)].flow;
    for (std::size_t k : p.openings) targets[k] = flow * openings[k].area / area;
  }
}

}  // namespace velum::ibm
