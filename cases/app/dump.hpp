#pragma once
#include "cases/app/coupled_scene.hpp"
#include "core/output/fields.hpp"

namespace velum::cases {

/// Fields of the fluid in SI: pressure, velocity, density, and side (0 wall or body, 1 above, 2
/// below the membrane).
template <class Real, class L, class Stored>
std::vector<core::Field> fluid_fields(lbm::Fluid<Real, L, Stored> const& fluid,
                                      core::Units const& units);

/// The membrane's mid-surface and wet faces in metres, with velocity, thickness and, of the faces,
/// the pressure that the fluid puts on them.
template <class Real, template <class> class Body>
std::vector<core::Curve> membrane_curves(CoupledScene<Real, Body> const& s);

}  // namespace velum::cases
