#include "ibm/seat_gap.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "structure/faces.hpp"

namespace velum::ibm {
namespace {

/// Distance of the points of the minus face from the seat, and that of the contact at its least.
struct Distances {
  std::vector<core::Vec2> face;
  std::vector<double> gap;
  double least;  // of the contact
};

Distances distances(SeatContact const& seat, structure::Membrane const& membrane)
{
  structure::Faces faces;
  structure::locate_faces(membrane, membrane.position, 1, faces);
  Distances d{std::move(faces.minus), {}, narrowest_gap(seat)};
  for (auto const& point : d.face) d.gap.push_back(core::distance(seat.contact.obstacle, point));
  return d;
}

}  // namespace

SeatGap seat_gap(GapLaw const& law, SeatContact const& seat, structure::Membrane const& membrane)
{
  auto const symmetry = membrane.symmetry;
  auto const [face, distance, least] = distances(seat, membrane);
  std::size_t const n = face.size();
  auto const nearest = std::min_element(distance.begin(), distance.end());
  SeatGap gap;
  gap.least = least;
  gap.narrowest = static_cast<int>(nearest - distance.begin());
  gap.at = face[static_cast<std::size_t>(gap.narrowest)];
  gap.friction.assign(n, 0);
  gap.narrowness.assign(n, 0);
  double const shift = *nearest - least;
  std::vector<double> g(n);
  for (std::size_t a = 0; a < n; ++a) g[a] = std::max(distance[a] - shift, law.seals_at);
  auto const across = [&](std::size_t a) { return core::ring(symmetry, face[a][1]) * g[a]; };
  double const section = across(static_cast<std::size_t>(gap.narrowest));

  double viscous = 0;
  gap.inertance = 0;
  for (std::size_t a = 0; a < n; ++a) {
    if (a > 0) {
      double const length = norm(face[a] - face[a - 1]);
      double const ring = core::ring(symmetry, (face[a][1] + face[a - 1][1]) / 2);
      if (g[a - 1] + g[a] < 20 * g[static_cast<std::size_t>(gap.narrowest)])
        gap.inertance += 2 * law.liquid.density * length / (ring * (g[a - 1] + g[a]));
      // int ds / g^3 of a gap linear along the element
      viscous += 6 * law.liquid.density * law.liquid.viscosity * length / ring * (g[a - 1] + g[a]) /
                 (g[a - 1] * g[a - 1] * g[a] * g[a]);
    }
    gap.friction[a] = viscous;
    double const share = across(a) > 0 ? section / across(a) : 1;
    gap.narrowness[a] = std::min(share * share, 1.0);
  }
  for (double& f : gap.friction) f /= viscous;
  if (gap.least > law.seals_at)
    gap.loss =
        Loss{viscous, law.liquid.density / (2 * law.discharge * law.discharge * section * section)};
  return gap;
}

std::vector<double> outside_share(SeatGap const& gap, double Q)
{
  std::vector<double> share = gap.friction;
  if (!gap.loss) return share;
  double const head = gap.loss->inertial * std::abs(Q);
  double const friction = gap.loss->viscous / (gap.loss->viscous + head);
  bool const inwards = Q >= 0;  // from outside
  for (std::size_t a = 0; a < share.size(); ++a) {
    bool const beyond = static_cast<int>(a) > gap.narrowest;
    // upstream of the narrowest place what is not yet lost, downstream none of it
    double const left = beyond == inwards ? 1 - gap.narrowness[a] : 0;
    share[a] = friction * share[a] + (1 - friction) * (inwards ? left : 1 - left);
  }
  return share;
}

}  // namespace velum::ibm
