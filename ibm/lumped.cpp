#include "ibm/lumped.hpp"

#include "ibm/hydrostatic.hpp"

namespace velum::ibm {
namespace {

/// Pressures of the minus face, one region's being 1 and the other's 0.
structure::FacePressure below(Lumped const& s, contact::Patch const& patch, double outside,
                              double inside)
{
  if (contact::touches(patch))
    return pressure_by_region(s.membrane, patch,
                              {.above = 0, .inside = inside, .outside = outside, .lip = s.lip});
  auto const share =
      outside_share(s.gap, s.network.passages[static_cast<std::size_t>(s.gap_passage)].flow);
  auto const at = [&](std::size_t a) { return inside + (outside - inside) * share[a]; };
  structure::FacePressure pressure;
  for (int e = 0; e < structure::element_count(s.membrane); ++e) {
    auto const a = static_cast<std::size_t>(e);
    pressure.push_back({e, structure::Side::minus, 0, 1, at(a), at(a + 1)});
  }
  return pressure;
}

Eigen::MatrixXd areas(Lumped const& s)
{
  auto const patch = contact::contact_patch(s.seat->contact, s.seat->markers);
  Eigen::MatrixXd area = Eigen::MatrixXd::Zero(
      s.membrane.position.size(), static_cast<Eigen::Index>(s.network.chambers.size()));
  area.col(s.above) = structure::pressure_force(
      s.membrane, structure::uniform_pressure(s.membrane, structure::Side::plus, 1));
  area.col(s.outside) = structure::pressure_force(s.membrane, below(s, patch, 1, 0));
  area.col(s.inside) = structure::pressure_force(s.membrane, below(s, patch, 0, 1));
  return area;
}

}  // namespace

void locate(Lumped& s)
{
  press(*s.seat, s.membrane.position);
  s.gap = seat_gap(s.law, *s.seat, s.membrane);
  Passage& passage = s.network.passages[static_cast<std::size_t>(s.gap_passage)];
  passage.loss = s.gap.loss;
  passage.inertance = s.gap.inertance;
}

void step(Lumped& s, double h)
{
  locate(s);
  follow_thickness(*s.seat, s.membrane, thickness_share);
  auto const flows = linearised(s.network, h);
  auto enclosed = enclosures(s.network, flows, areas(s));
  Eigen::VectorXd const none = Eigen::VectorXd::Zero(s.membrane.position.size());
  auto const& velocity =
      structure::advance(s.stepper, s.membrane, none, {}, h, s.substeps, s.loads, &enclosed);
  take_over(s.network, flows, enclosed, velocity, h);
}

}  // namespace velum::ibm
