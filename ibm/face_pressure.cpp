#include "ibm/face_pressure.hpp"

namespace velum::ibm {

namespace {

/// Pressure of the first node with links at or beyond a, going by step; false if there is none.
bool nearest_sample(Exchange const& e, std::vector<char> const& film, int side, int a, int step,
                    double& p)
{
  for (int n = static_cast<int>(film.size()); a >= 0 && a < n; a += step) {
    auto const k = static_cast<std::size_t>(a);
    if (!film[k] && e.samples[side][k] > 0) {
      p = e.pressure[side][k];
      return true;
    }
  }
  return false;
}

/// Pressure of node a at this instant: its own links', or between its neighbours', or the film's.
double instant_pressure(FacePressure const& pressure, Exchange const& e, int side, int a,
                        std::vector<double> const& outside_share, contact::Patch const& patch)
{
  auto const k = static_cast<std::size_t>(a);
  bool const film = pressure.film[side][k] != 0;
  if (!film && e.samples[side][k] > 0) return e.pressure[side][k];
  double before = 0, after = 0;
  bool const has_before = nearest_sample(e, pressure.film[side], side, a - 1, -1, before);
  bool const has_after = nearest_sample(e, pressure.film[side], side, a + 1, 1, after);
  if (!has_before && !has_after) return pressure.p[side][k];
  if (!has_after) return before;
  if (!has_before) return after;
  if (film && side == 1 && contact::touches(patch))
    return contact::face_pressure(pressure.lip, a, patch.begin, patch.end, before, after);
  if (film && side == 1 && !outside_share.empty())
    return before + outside_share[k] * (after - before);
  return (before + after) / 2;
}

}  // namespace

std::vector<core::Vec2> face_area(std::vector<core::Vec2> const& line, bool plus,
                                  core::Symmetry symmetry)
{
  std::vector<core::Vec2> area(line.size());
  double const sign = plus ? -1 : 1;
  for (std::size_t e = 0; e + 1 < line.size(); ++e) {
    core::Vec2 const d = line[e + 1] - line[e];
    core::Vec2 const normal = {sign * d[1], -sign * d[0]};
    double const a = core::ring(symmetry, line[e][1]), b = core::ring(symmetry, line[e + 1][1]);
    area[e] += (2 * a + b) / 6 * normal;
    area[e + 1] += (a + 2 * b) / 6 * normal;
  }
  return area;
}

void complete_load(FacePressure& pressure, Exchange& exchange, Surface const& surface,
                   Film const& film, core::Symmetry symmetry, contact::Patch const& patch)
{
  std::vector<core::Vec2> middle(surface.faces.plus.size());
  for (std::size_t a = 0; a < middle.size(); ++a)
    middle[a] = 0.5 * (surface.faces.plus[a] + surface.faces.minus[a]);
  for (int side : {0, 1}) {
    auto const& face = side == 0 ? surface.faces.plus : surface.faces.minus;
    std::size_t const n = face.size();
    pressure.film[side].resize(n);
    pressure.p[side].resize(n, 0);
    for (std::size_t a = 0; a < n; ++a)
      pressure.film[side][a] =
          core::distance(film.walls, face[a]) < film_closes ||
          (side == 1 && film.seat.shape && core::distance(film.seat, face[a]) < film.seat_width);
    auto const area = face_area(middle, side == 0, symmetry);
    double const blend = pressure.started ? 1 / pressure_memory : 1;
    for (std::size_t a = 0; a < n; ++a) {
      double& p = pressure.p[side][a];
      p += blend * (instant_pressure(pressure, exchange, side, static_cast<int>(a),
                                     film.outside_share, patch) -
                    p);
      core::Vec2 const missing = p * (area[a] - exchange.link_area[side][a]);
      for (int d : {0, 1}) exchange.force[static_cast<Eigen::Index>(2 * a) + d] += missing[d];
    }
  }
  pressure.started = true;
}

}  // namespace velum::ibm
