#include "ibm/region_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "structure/triangle_part.hpp"

namespace velum::ibm {
namespace {

using structure::Triangle;
using Segment = std::pair<Eigen::Vector3d, Eigen::Vector3d>;

Eigen::Vector3d at_corners(Triangle const& t, std::vector<double> const& nodal)
{
  Eigen::Vector3d v;
  for (int a = 0; a < 3; ++a)
    v[a] = nodal[static_cast<std::size_t>(t[static_cast<std::size_t>(a)])];
  return v;
}

/// Whether the land ends in a triangle, and if so at which side.
struct Edge {
  bool here = false;
  Below side = Below::land;
};

Edge edge_in(SheetRegions const& r, Triangle const& t)
{
  bool land = false;
  Below side = Below::land;
  for (int a : t) {
    auto const below = r.node[static_cast<std::size_t>(a)];
    if (below == Below::land)
      land = true;
    else
      side = below;  // two corners without contact are joined by their edge: one side only
  }
  return {land && side != Below::land, side};
}

/// The straight cut at the edge of the land through a triangle, at the positions x.
Segment cut(Triangle const& t, Eigen::Vector3d const& level, Eigen::VectorXd const& x)
{
  Segment s;
  bool first = true;
  for (std::size_t a = 0; a < 3; ++a) {
    std::size_t const b = (a + 1) % 3;
    double const here = level[static_cast<int>(a)], next = level[static_cast<int>(b)];
    if ((here > 0) == (next > 0)) continue;
    (std::exchange(first, false) ? s.first : s.second) =
        (here * structure::node3(x, t[b]) - next * structure::node3(x, t[a])) / (here - next);
  }
  return s;
}

double distance(Eigen::Vector3d const& p, std::vector<Segment> const& line)
{
  double least = std::numeric_limits<double>::infinity();
  for (auto const& [a, b] : line) {
    Eigen::Vector3d const along = b - a;
    double const length = along.squaredNorm();
    double const s = length > 0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0;
    least = std::min(least, (p - a - s * along).squaredNorm());
  }
  return std::sqrt(least);
}

double of_side(Below side, HydrostaticLoad const& load)
{
  return side == Below::downstream ? load.inside : load.outside;
}

/// Pressure at the nodes below: of the region, on the land that of the lip.
std::vector<double> nodal_pressure(structure::Sheet const& sheet, Eigen::VectorXd const& x,
                                   SheetRegions const& r, HydrostaticLoad const& load)
{
  std::vector<Segment> up, down;
  for (auto const& t : sheet.triangles)
    if (auto const edge = edge_in(r, t); edge.here)
      (edge.side == Below::upstream ? up : down).push_back(cut(t, at_corners(t, r.pressing), x));
  std::vector<double> p(r.node.size());
  for (std::size_t a = 0; a < p.size(); ++a) {
    if (r.node[a] != Below::land) {
      p[a] = of_side(r.node[a], load);
    } else if (load.lip == contact::LipPressure::none) {
      p[a] = 0;
    } else if (down.empty() || up.empty()) {
      p[a] = down.empty() ? load.outside : load.inside;
    } else {
      auto const place = structure::node3(x, static_cast<int>(a));
      double const to_up = distance(place, up), to_down = distance(place, down);
      p[a] = load.inside + (load.outside - load.inside) * to_down / (to_up + to_down);
    }
  }
  return p;
}

/// Corners' shares of a part whose pressure is p at nodes and p_cut at the cut.
Eigen::Vector3d share(structure::TrianglePart const& part, Eigen::Vector3d const& p, double p_cut)
{
  Eigen::Vector4d q = Eigen::Vector4d::Zero();
  for (int k = 0; k < part.count; ++k) {
    auto const& corner = part.corner[static_cast<std::size_t>(k)];
    q[k] = corner.maxCoeff() == 1 ? corner.dot(p) : p_cut;
  }
  return structure::integral(part, q);
}

}  // namespace

structure::CornerPressure pressure_by_region(structure::Sheet const& sheet,
                                             Eigen::VectorXd const& x, SheetRegions const& regions,
                                             HydrostaticLoad const& load)
{
  auto const nodal = nodal_pressure(sheet, x, regions, load);
  structure::CornerPressure W(3, element_count(sheet));
  for (int e = 0; e < element_count(sheet); ++e) {
    auto const& t = sheet.triangles[static_cast<std::size_t>(e)];
    Eigen::Vector3d const p = at_corners(t, nodal), whole = Eigen::Vector3d::Zero();
    Eigen::Vector3d below = whole;
    if (auto const edge = edge_in(regions, t); edge.here) {
      Eigen::Vector3d const level = at_corners(t, regions.pressing);
      double const outer = of_side(edge.side, load);
      below = share(structure::part_above(level), p,
                    load.lip == contact::LipPressure::none ? 0 : outer) +
              share(structure::part_above(-level), Eigen::Vector3d::Constant(outer), outer);
    } else {
      below = share(structure::part_above(Eigen::Vector3d::Ones()), p, 0);
    }
    W.col(e) = Eigen::Vector3d::Constant(load.above / 3) - below;
  }
  return W;
}

}  // namespace velum::ibm
