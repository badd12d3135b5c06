#include "structure/lift_stop.hpp"

#include "structure/mass.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace velum::structure {
namespace {

/// What a node that can meet the stop is.
struct Meeting {
  int dof;
  double limit;  // of its axial position
  double area;
};

std::vector<Meeting> meetings(Membrane const& m, LiftStop const& stop)
{
  std::vector<Meeting> all;
  Eigen::VectorXd const area = nodal_area(m);
  for (int a : nodes_within(m, stop.radius)) {
    double const H =
        (m.thickness[std::max(a - 1, 0)] + m.thickness[std::min(a, element_count(m) - 1)]) / 2;
    all.push_back({2 * a, stop.position - H / 2, area[a]});
  }
  return all;
}

}  // namespace

double stop_force(Membrane const& m, LiftStop const& stop, Eigen::VectorXd const& x)
{
  double force = 0;
  for (auto const& node : meetings(m, stop))
    force += *stop.stiffness * node.area * std::max(0.0, x[node.dof] - node.limit);
  return force;
}

double highest_face(Membrane const& m, LiftStop const& stop)
{
  double highest = -std::numeric_limits<double>::infinity();
  for (auto const& node : meetings(m, stop))
    highest = std::max(highest, m.position[node.dof] + stop.position - node.limit);
  return highest;
}

Load stop_load(Membrane const& m, LiftStop const& stop)
{
  return [all = meetings(m, stop), k = stop.stiffness](Eigen::VectorXd const& x,
                                                       Eigen::VectorXd& force, Triplets* tangent) {
    for (auto const& node : all) {
      double const depth = x[node.dof] - node.limit;
      if (depth <= 0) continue;
      force[node.dof] -= *k * node.area * depth;
      if (tangent) tangent->emplace_back(node.dof, node.dof, -*k * node.area);
    }
  };
}

}  // namespace velum::structure
