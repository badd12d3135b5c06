#include "ibm/sheet_contact.hpp"

#include "structure/sheet_force.hpp"

namespace velum::ibm {

contact::PointContact make_sheet_contact(structure::Sheet const& sheet,
                                         core::SignedDistance<3> solid, double stiffness)
{
  Eigen::VectorXd const area = structure::nodal_area(sheet);
  double const thickness = sheet.thickness.mean();
  auto const nodes = static_cast<std::size_t>(area.size());
  return {std::move(solid),
          stiffness,
          1e-3 * thickness,
          {area.data(), area.data() + area.size()},
          std::vector<double>(nodes, thickness / 2),
          {}};
}

structure::Load contact_load(std::shared_ptr<contact::PointContact> const& contact)
{
  return [contact](Eigen::VectorXd const& x, Eigen::VectorXd& force, structure::Triplets* tangent) {
    auto const places = node_places(x);
    for (std::size_t a = 0; a < places.size(); ++a) {
      auto const at = contact::touch(*contact, a, places[a]);
      if (at.traction <= 0) continue;
      int const first = static_cast<int>(3 * a);
      for (int i = 0; i < 3; ++i) force[first + i] += contact->area[a] * at.traction * at.normal[i];
      if (!tangent) continue;
      auto const K = contact::tangent(*contact, a, places[a]);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          tangent->emplace_back(first + i, first + j,
                                K[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
    }
  };
}

void follow_thickness(contact::PointContact& contact, structure::Sheet const& sheet, double share)
{
  Eigen::VectorXd const thickness = structure::nodal_thickness(sheet, sheet.position);
  for (std::size_t a = 0; a < contact.offset.size(); ++a)
    contact.offset[a] += share * (thickness[static_cast<Eigen::Index>(a)] / 2 - contact.offset[a]);
}

std::vector<core::Vec3> node_places(Eigen::VectorXd const& x)
{
  std::vector<core::Vec3> places;
  for (Eigen::Index i = 0; i < x.size(); i += 3) places.push_back({x[i], x[i + 1], x[i + 2]});
  return places;
}

}  // namespace velum::ibm
