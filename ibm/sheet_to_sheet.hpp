#pragma once
#include <memory>

#include "contact/surface_contact.hpp"
#include "structure/load.hpp"
#include "structure/sheet.hpp"

namespace velum::ibm {

/// Contact of a sheet with itself, and of the sheets that merge_sheets() made one of: areas and
/// thicknesses those of the undeformed sheet, so that the force is the derivative of an energy.
/// Two bodies are self-contact of one whose parts do not hang together.
/// @param stiffness  pressure per length
contact::SurfaceContact make_sheet_to_sheet(structure::Sheet const& sheet, double stiffness,
                                            contact::PointLayout const& layout = {});

/// The contact as a load with its tangent, exact while no point's nearest triangle changes. It
/// covers by itself what Newton's method or the sub-steps of an explicit scheme reach; the sides
/// and the multipliers change by contact::follow() and contact::update_multipliers() alone.
structure::Load contact_load(std::shared_ptr<contact::SurfaceContact> const& contact);

}  // namespace velum::ibm
