#include "ibm/network.hpp"

#include <cmath>

namespace velum::ibm {
namespace {

/// The chamber of a node, or -1.
int chamber(Network const& network, int node)
{
  return node < static_cast<int>(network.chambers.size()) ? node : -1;
}

Port const* port(Network const& network, int node)
{
  auto const k = static_cast<std::size_t>(node);
  return k < network.chambers.size() ? nullptr : &network.ports[k - network.chambers.size()];
}

/// Pressure at the end of a passage where nothing flowed, and what a flow towards it adds.
struct End {
  double pressure, impedance;
};

End end_of(Network const& network, int node)
{
  if (Port const* const p = port(network, node))
    return {p->pressure - p->impedance * p->at_flow, p->impedance};
  return {0, 0};
}

/// The part of a node's pressure that the step finds; a port's is given.
double found(Network const& network, Eigen::VectorXd const& p, int node)
{
  int const k = chamber(network, node);
  return k < 0 ? 0 : p[k];
}

}  // namespace

double pressure(Network const& network, int node)
{
  Port const* const p = port(network, node);
  return p ? p->pressure : network.chambers[static_cast<std::size_t>(node)].pressure;
}

std::vector<LinearFlow> linearised(Network const& network, double h)
{
  std::vector<LinearFlow> flows;
  for (Passage const& passage : network.passages) {
    LinearFlow linear;
    if (passage.loss) {
      Loss const& loss = *passage.loss;
      double const dp = pressure(network, passage.from) - pressure(network, passage.to);
      double const q = passage.inertance > 0 ? passage.flow : flow(loss, dp);
      End const from = end_of(network, passage.from), to = end_of(network, passage.to);
      double const resistance = passage.inertance / h + loss.viscous +
                                2 * loss.inertial * std::abs(q) + from.impedance + to.impedance;
      linear.conductance = 1 / resistance;
      linear.constant = (passage.inertance / h * passage.flow + loss.inertial * std::abs(q) * q +
                         from.pressure - to.pressure) /
                        resistance;
    }
    flows.push_back(linear);
  }
  return flows;
}

structure::Enclosures enclosures(Network const& network, std::vector<LinearFlow> const& flows,
                                 Eigen::MatrixXd area)
{
  auto const m = static_cast<Eigen::Index>(network.chambers.size());
  structure::Enclosures e{std::move(area),          Eigen::VectorXd(m), Eigen::MatrixXd::Zero(m, m),
                          Eigen::VectorXd::Zero(m), Eigen::VectorXd(m), Eigen::VectorXd::Zero(m)};
  for (Eigen::Index k = 0; k < m; ++k) {
    e.compliance[k] = network.chambers[static_cast<std::size_t>(k)].compliance;
    e.pressure[k] = network.chambers[static_cast<std::size_t>(k)].pressure;
  }
  for (std::size_t n = 0; n < flows.size(); ++n) {
    auto const [g, constant] = flows[n];
    int const a = chamber(network, network.passages[n].from);
    int const b = chamber(network, network.passages[n].to);
    if (a >= 0) e.conductance(a, a) += g, e.inflow[a] -= constant;
    if (b >= 0) e.conductance(b, b) += g, e.inflow[b] += constant;
    if (a >= 0 && b >= 0) e.conductance(a, b) -= g, e.conductance(b, a) -= g;
  }
  return e;
}

void take_over(Network& network, std::vector<LinearFlow> const& flows,
               structure::Enclosures const& after, Eigen::VectorXd const& velocity, double h)
{
  for (Port& p : network.ports) p.flow = 0;
  auto const into = [&](int node, double q) {
    auto const k = static_cast<std::size_t>(node);
    if (int const c = chamber(network, node); c >= 0)
      network.chambers[k].content += h * q;
    else
      network.ports[k - network.chambers.size()].flow += q;
  };
  for (std::size_t n = 0; n < flows.size(); ++n) {
    Passage& passage = network.passages[n];
    passage.flow = flows[n].conductance * (found(network, after.mean, passage.from) -
                                           found(network, after.mean, passage.to)) +
                   flows[n].constant;
    into(passage.from, -passage.flow);
    into(passage.to, passage.flow);
  }
  Eigen::VectorXd const swept = h * (after.area.transpose() * velocity);
  for (std::size_t k = 0; k < network.chambers.size(); ++k) {
    Chamber& c = network.chambers[k];
    auto const row = static_cast<Eigen::Index>(k);
    c.swept += swept[row];
    c.pressure = c.compliance > 0 ? (c.content - c.swept) / c.compliance : after.pressure[row];
  }
}

void fill(Network& network)
{
  for (Chamber& c : network.chambers) c.content = c.swept + c.compliance * c.pressure;
}

}  // namespace velum::ibm
