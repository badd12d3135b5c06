#include "ibm/contact_step.hpp"

#include <algorithm>
#include <cmath>

#include "ibm/sheet_contact.hpp"
#include "structure/stable_step.hpp"

namespace velum::ibm {
namespace {

constexpr double elastic_margin = 0.8;
constexpr double contact_phase = 0.5;  // largest omega dt on the contact, as of stable_stiffness()

/// @param contact  square of the largest frequency of a node on the contact alone
template <class Body>
double stable(Body const& m, Eigen::VectorXd const& mass, double contact,
              std::span<structure::Load const> loads)
{
  double const elastic = 1 / (elastic_margin * structure::stable_step(m, mass, m.position, loads));
  return 1 / std::sqrt(elastic * elastic + contact / (contact_phase * contact_phase));
}

/// Square of the largest frequency of a node on a contact of these areas.
double squared_frequency(double stiffness, std::vector<double> const& area,
                         Eigen::VectorXd const& mass)
{
  double largest = 0;
  for (Eigen::Index a = 0; a < mass.size(); ++a)
    largest = std::max(largest, stiffness * area[static_cast<std::size_t>(a)] / mass[a]);
  return largest;
}

}  // namespace

double safe_step(SeatContact const& c, Eigen::VectorXd const& x, Eigen::VectorXd const& v,
                 double share)
{
  core::Markers moving = c.markers;
  for (std::size_t a = 0; a < moving.X.size(); ++a) {
    moving.X[a] = structure::node(x, static_cast<int>(a));
    moving.V[a] = structure::node(v, static_cast<int>(a));
  }
  return largest_safe_step(c.contact, moving, share);
}

double safe_step(contact::PointContact const& c, Eigen::VectorXd const& x, Eigen::VectorXd const& v,
                 double share)
{
  return largest_safe_step(c, node_places(x), node_places(v), share);
}

double contact_step(structure::Membrane const& m, Eigen::VectorXd const& mass, SeatContact const& c,
                    std::span<structure::Load const> loads)
{
  double const touching = squared_frequency(c.contact.stiffness, c.markers.area, mass);
  return std::min(stable(m, mass, touching, loads), safe_step(c, m.position, m.velocity));
}

double contact_step(structure::Sheet const& s, Eigen::VectorXd const& mass,
                    contact::PointContact const& c, std::span<structure::Load const> loads)
{
  double const touching = squared_frequency(c.stiffness, c.area, mass);
  return std::min(stable(s, mass, touching, loads), safe_step(c, s.position, s.velocity));
}

double contact_step(structure::Sheet const& s, Eigen::VectorXd const& mass,
                    contact::SurfaceContact const& c, std::span<structure::Load const> loads)
{
  // Gershgorin: a node's own points count twice, and so do those upon the triangles around it,
  // which stand for as much together, or where they are coarse for as much as one of them.
  Eigen::VectorXd own = Eigen::VectorXd::Zero(mass.size());
  double widest = 0;
  for (auto const& p : c.points) {
    for (std::size_t i = 0; i < 3; ++i) own[p.nodes[i]] += p.share[i] * p.area;
    widest = std::max(widest, p.area);
  }
  double touching = 0;
  for (Eigen::Index a = 0; a < mass.size(); ++a)
    touching = std::max(touching, 2 * c.stiffness * (own[a] + std::max(own[a], widest)) / mass[a]);
  return std::min(stable(s, mass, touching, loads), largest_safe_step(c, node_places(s.velocity)));
}

}  // namespace velum::ibm
