#include "ibm/contact_load.hpp"

#include <algorithm>
#include <limits>

#include "structure/faces.hpp"
#include "structure/mass.hpp"

namespace velum::ibm {

SeatContact make_seat_contact(core::Obstacle const& seat, double stiffness,
                              structure::Membrane const& membrane)
{
  auto const n = static_cast<std::size_t>(structure::node_count(membrane));
  SeatContact c{{seat, stiffness, {}}, {}};
  c.markers.X.resize(n);
  c.markers.V.resize(n);
  c.markers.F.resize(n);
  c.markers.offset.resize(n);
  Eigen::VectorXd const area = structure::nodal_area(membrane);
  c.markers.area.assign(area.data(), area.data() + area.size());
  follow_thickness(c, membrane);
  return c;
}

void follow_thickness(SeatContact& seat, structure::Membrane const& membrane, double share)
{
  structure::Faces faces;
  structure::locate_faces(membrane, membrane.position, 1.0, faces);
  for (std::size_t a = 0; a < seat.markers.offset.size(); ++a)
    seat.markers.offset[a] += share * (faces.thickness[a] / 2 - seat.markers.offset[a]);
}

double narrowest_gap(SeatContact const& seat)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < seat.markers.X.size(); ++a)
    least = std::min(least, contact::gap(seat.contact, seat.markers, a));
  return least;
}

void press(SeatContact& seat, Eigen::VectorXd const& x)
{
  core::Markers& m = seat.markers;
  for (std::size_t a = 0; a < m.X.size(); ++a) {
    m.X[a] = structure::node(x, static_cast<int>(a));
    m.F[a] = {};
  }
  contact::add_forces(seat.contact, m, seat.clearance);
}

structure::Load contact_load(std::shared_ptr<SeatContact> const& seat)
{
  return [seat](Eigen::VectorXd const& x, Eigen::VectorXd& force, structure::Triplets* tangent) {
    press(*seat, x);
    for (std::size_t a = 0; a < seat->markers.F.size(); ++a)
      for (int d : {0, 1}) force[static_cast<Eigen::Index>(2 * a) + d] += seat->markers.F[a][d];
    if (!tangent) return;
    std::vector<contact::SymmetricBlock> blocks;
    double const probe = 1e-3 * seat->markers.offset[0];
    contact::tangents(seat->contact, seat->markers, probe, blocks);
    for (std::size_t a = 0; a < blocks.size(); ++a) {
      int const k = static_cast<int>(2 * a);
      tangent->emplace_back(k, k, blocks[a].xx);
      tangent->emplace_back(k, k + 1, blocks[a].xy);
      tangent->emplace_back(k + 1, k, blocks[a].xy);
      tangent->emplace_back(k + 1, k + 1, blocks[a].yy);
    }
  };
}

}  // namespace velum::ibm
