#pragma once
#include "cases/app/body_scene.hpp"
#include "contact/point_contact.hpp"
#include "ibm/contact_load.hpp"
#include "structure/line_bending.hpp"
#include "structure/pressure_load.hpp"
#include "structure/sheet_bending.hpp"

#include <cstddef>
#include <memory>
#include <type_traits>

namespace velum::cases {

/// The body of a scene ready to be solved, SI. Body is structure::Membrane or structure::Sheet. Its
/// loads refer to its members: it stays where it is made.
template <class Body>
struct BodyModel {
  static constexpr bool in_space = std::is_same_v<Body, structure::Sheet>;
  using BendingOf = std::conditional_t<in_space, structure::SheetBending, structure::LineBending>;
  using PressureOf = std::conditional_t<in_space, Eigen::VectorXd, structure::FacePressure>;
  using ContactOf = std::conditional_t<in_space, contact::PointContact, ibm::SeatContact>;

  explicit BodyModel(BodyScene const& scene);
  BodyModel(BodyModel const&) = delete;

  Body body;
  BendingOf bending;                   // empty: a membrane
  PressureOf pressure;                 // as it was set last
  std::shared_ptr<ContactOf> contact;  // empty without
  std::vector<structure::Load> loads;  // pressure, bending, contact
  double span = 0;

  void set_pressure(Side side, double pressure);
};

/// What the seat carries, SI; the force along the first axis.
struct SeatFigures {
  double force = 0, area = 0, penetration = 0, pressure_max = 0;
};
SeatFigures seat_figures(BodyModel<structure::Membrane> const& model);
SeatFigures seat_figures(BodyModel<structure::Sheet> const& model);

/// Uzawa's update of the contact's multipliers; the largest change, Pa.
double update_multipliers(BodyModel<structure::Membrane>& model);
double update_multipliers(BodyModel<structure::Sheet>& model);

/// Penalty stiffness, Pa/m: the scene's, or a hundred times as stiff as the rubber across its
/// thickness, 100 mu / H.
double penalty(BodyScene const& scene);

/// Components of the nodes that may move.
std::ptrdiff_t unknowns(BodyScene const& scene);

/// Places of the nodes before and after, m; of lines (axial, radial, 0).
std::vector<Vec3> places(structure::Membrane const& body, Eigen::VectorXd const& x);
std::vector<Vec3> places(structure::Sheet const& body, Eigen::VectorXd const& x);

}  // namespace velum::cases
