#pragma once
#include <memory>

#include "contact/contact.hpp"
#include "contact/patch.hpp"
#include "ibm/surface.hpp"
#include "structure/load.hpp"
#include "structure/membrane.hpp"

namespace velum::ibm {

/// Contact of a membrane with the seat as a structural load. Markers sit on the nodes; their areas
/// are those of the undeformed nodes and their offsets the half thickness that was last set, so
/// that within a solve or a step the contact force is the derivative of an energy.
struct SeatContact {
  contact::Contact contact;
  core::Markers markers;
  contact::Clearance clearance{};  // spares the markers that are far from the seat
};

/// @param stiffness  pressure per length
SeatContact make_seat_contact(core::Obstacle const& seat, double stiffness,
                              structure::Membrane const& membrane);

/// Moves the offsets towards the membrane's present half thickness, by the given share of the way.
void follow_thickness(SeatContact& seat, structure::Membrane const& membrane, double share = 1);

/// Share per step in a march. Stretching thins the membrane at once, and were the stiff contact to
/// follow at once, waves along the membrane would be pumped up by it within tens of steps: the
/// penalty's force would depend on a strain that it does no work on.
constexpr double thickness_share = 1.0 / 2000;

/// The least distance of a face from the seat, as the contact sees it; below 0 where it penetrates.
double narrowest_gap(SeatContact const& seat);

/// Places the markers at x and computes their contact forces.
void press(SeatContact& seat, Eigen::VectorXd const& x);

/// The contact as a load; the seat is shared, so that its markers can be looked at afterwards.
structure::Load contact_load(std::shared_ptr<SeatContact> const& seat);

}  // namespace velum::ibm
