#include "ibm/sheet_to_sheet.hpp"

#include "ibm/sheet_contact.hpp"

namespace velum::ibm {
namespace {

/// Adds the derivatives by the point and the corners to those by the nodes that move them.
void add_matrix(structure::Triplets& entries, contact::TouchForce const& f,
                contact::Matrix12 const& K)
{
  auto const block = [](std::size_t a) { return a < 3 ? 0 : 3 * (a - 2); };
  for (std::size_t a = 0; a < 6; ++a)
    for (std::size_t b = 0; b < 6; ++b) {
      double const share = f.share[a] * f.share[b];
      if (share == 0) continue;
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          entries.emplace_back(3 * f.node[a] + static_cast<int>(i),
                               3 * f.node[b] + static_cast<int>(j),
                               share * K[block(a) + i][block(b) + j]);
    }
}

}  // namespace

contact::SurfaceContact make_sheet_to_sheet(structure::Sheet const& sheet, double stiffness,
                                            contact::PointLayout const& layout)
{
  Eigen::VectorXd const half = sheet.thickness / 2;
  return contact::make_surface_contact(sheet.triangles, node_places(sheet.reference),
                                       node_places(sheet.position),
                                       {half.data(), half.data() + half.size()}, stiffness, layout);
}

structure::Load contact_load(std::shared_ptr<contact::SurfaceContact> const& contact)
{
  return [contact](Eigen::VectorXd const& x, Eigen::VectorXd& force, structure::Triplets* tangent) {
    auto const places = node_places(x);
    contact::cover(*contact, places);
    for (auto const& touch : contact::touches(*contact, places)) {
      auto const f = contact::force(*contact, touch);
      for (std::size_t a = 0; a < 6; ++a)
        for (int i = 0; i < 3; ++i) force[3 * f.node[a] + i] += f.force[a][i];
      if (tangent) add_matrix(*tangent, f, contact::tangent(*contact, touch, places));
    }
  };
}

}  // namespace velum::ibm
