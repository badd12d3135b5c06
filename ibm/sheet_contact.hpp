#pragma once
#include <memory>

#include "contact/point_contact.hpp"
#include "structure/load.hpp"
#include "structure/sheet.hpp"

namespace velum::ibm {

/// Contact of a sheet's nodes with a rigid solid: areas those of the undeformed sheet, offsets half
/// its undeformed thickness until follow_thickness() sets others, so that within a solve or a step
/// the force is the derivative of an energy.
/// @param stiffness  pressure per length
contact::PointContact make_sheet_contact(structure::Sheet const& sheet,
                                         core::SignedDistance<3> solid, double stiffness);

/// The contact as a load with its tangent. It is shared, so that its multipliers may change.
structure::Load contact_load(std::shared_ptr<contact::PointContact> const& contact);

/// Moves the offsets towards the sheet's present half thickness, by the given share of the way.
void follow_thickness(contact::PointContact& contact, structure::Sheet const& sheet,
                      double share = 1);

/// Places of the nodes, as contact looks at them.
std::vector<core::Vec3> node_places(Eigen::VectorXd const& x);

}  // namespace velum::ibm
