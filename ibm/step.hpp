#pragma once
#include "ibm/coupled.hpp"
#include "ibm/gap_film.hpp"
#include "lbm/stream_and_collide.hpp"

namespace velum::ibm {

/// Walls at rest and openings write what they send back.
template <class Real, template <class> class Body>
void apply_boundaries(Coupled<Real, Body>& s)
{
  tie_gap(s);
  lbm::fill_ghosts(s.fluid);
  reflect_at_walls(s.body, s.fluid);
  for (std::size_t k = 0; k < s.openings.size(); ++k)
    if (s.openings[k].area > 0) lbm::apply(s.fluid, s.openings[k], s.targets[k]);
}

/// Adds the load of what the links of a sharp body do not feel: films, and faces between the links.
template <class Real>
void complete(Coupled<Real, Sharp>& s)
{
  complete_load(
      s.pressure, s.body.exchange, s.body.surface, film_of(s), s.fluid.symmetry,
      s.seat ? contact::contact_patch(s.seat->contact, s.seat->markers) : contact::Patch{});
}

/// Any other body feels its faces whole.
template <class Real, template <class> class Body>
void complete(Coupled<Real, Body>&)
{
}

/// Moves the membrane under the fluid's force F0 - Z v and returns its mean velocity.
template <class Real, template <class> class Body>
Eigen::VectorXd advance(Coupled<Real, Body>& s)
{
  Exchange& e = s.body.exchange;
  Kokkos::Timer const timer;
  bool const carries_block = s.scheme == Scheme::implicit && !s.one_way;
  Eigen::VectorXd velocity = s.membrane.velocity;
  if (s.one_way) {
    e.force.setZero();
  } else if (s.scheme == Scheme::explicit_) {
    for (std::size_t a = 0; a < e.block.size(); ++a) {
      auto const k = static_cast<Eigen::Index>(2 * a);
      e.force.segment<2>(k) -= e.block[a] * velocity.segment<2>(k);
    }
  }
  if (s.chambers) begin_step(*s.chambers, s.openings, s.membrane, s.seat.get());
  auto const block = carries_block ? std::span<Eigen::Matrix2d const>(e.block)
                                   : std::span<Eigen::Matrix2d const>();
  structure::Enclosures* const enclosed = s.chambers ? &s.chambers->enclosed : nullptr;
  auto const& mean =
      structure::advance(s.stepper, s.membrane, e.force, block, 1.0, s.substeps, s.loads, enclosed);
  if (s.chambers) {
    end_step(*s.chambers, s.openings, s.targets, mean);
    if (s.chambers->gap) s.ledger.seat += gap_flow(*s.chambers);
  }
  if (carries_block || s.one_way) velocity = mean;
  s.membrane_seconds += timer.seconds();
  return velocity;
}

/// One step of fluid, membrane and contact from t to t + dt. The velocity of the faces is the only
/// unknown they share, and it is found before the fluid moves: within the step the coupling is
/// converged, without iteration; the geometry lags by one step.
template <class Real, template <class> class Body>
void step(Coupled<Real, Body>& s)
{
  apply_boundaries(s);                // walls, inlets, outlets
  feel(s.body, s.fluid, s.membrane);  // F0 and Z on the nodes
  complete(s);                        // what links do not feel
  if (s.seat) follow_thickness(*s.seat, s.membrane, thickness_share);
  Eigen::VectorXd const velocity = advance(s);  // M dv/dt = F0 - Z v + loads(x)
  impose(s.body, s.fluid, velocity, s.ledger);  // the faces push the fluid; f -> f
  move(s.body, s.fluid, s.membrane);            // labels, uncovered sites, cut links
}

}  // namespace velum::ibm
