#include "core/geometry/stl_report.hpp"

#include "core/geometry/self_crossing.hpp"
#include "core/readable_length.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace velum::core {
namespace {

constexpr double least_cells = 2;  // a wall or gap of fewer may have no cell centre in it

std::string counted(int count, char const* one, char const* many)
{
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string in_unit(Vec3 const& p, LengthUnit const& unit, char const* separator)
{
  // A coordinate that is round-off beside the unit is written as zero.
  Vec3 q = (1 / unit.metres) * p;
  for (double& x : q.c) x = std::abs(x) < 1e-9 ? 0.0 : x;
  return fmt::format("{:.4g}{}{:.4g}{}{:.4g}", q[0], separator, q[1], separator, q[2]);
}

/// "not closed: 3 open edges, 1 flipped edge".
std::string closedness(MeshTopology const& t)
{
  if (is_closed(t)) return "closed";
  std::vector<std::string> faults;
  if (t.open_edges > 0) faults.push_back(counted(t.open_edges, "open edge", "open edges"));
  if (t.non_manifold_edges > 0)
    faults.push_back(counted(t.non_manifold_edges, "edge of more than two triangles",
                             "edges of more than two triangles"));
  if (t.flipped_edges > 0)
    faults.push_back(counted(t.flipped_edges, "flipped edge", "flipped edges"));
  return fmt::format("not closed: {}", fmt::join(faults, ", "));
}

char const* normals_in_words(Normals normals)
{
  switch (normals) {
    case Normals::outward:
      return "normals point outward";
    case Normals::inward:
      return "normals point inward";
    case Normals::mixed:
      return "normals point both ways";
    case Normals::unknown:
      break;
  }
  return "normals cannot be judged";
}

std::string span_in_words(std::optional<Span> const& span, StlReport const& r,
                          LengthUnit const& unit)
{
  if (!span) return "none found";
  return fmt::format("{} = {:.3g} cells, at ({}) {}", readable_length(span->length),
                     span->length / r.dx, in_unit(span->middle, unit, ", "), unit.name);
}

void warn_of_span(std::string& text, std::optional<Span> const& span, char const* what,
                  char const* fate, double dx)
{
  if (!span || span->length >= least_cells * dx) return;
  text += fmt::format(
      "warning: the {} has {:.2g} cells of {}; below {} {}, depending on how it lies on the "
      "lattice.{}\n",
      what, span->length / dx, readable_length(dx), least_cells, fate,
      span->length > 0 ? fmt::format(" It takes a dx of at most {}.",
                                     readable_length(span->length / least_cells))
                       : "");
}

std::string warnings(StlReport const& r)
{
  std::string text;
  if (r.topology.open_edges > 0)
    text +=
        "warning: the surface is not closed, so inside and outside are a majority vote of rays "
        "and a guess near the holes; close it in the program it comes from.\n";
  else if (!is_closed(r.topology) || r.normals != Normals::outward)
    text +=
        "warning: normals do not all point out of the solid, or some edges have more than two "
        "triangles; inside and outside are found by rays instead.\n";
  if (r.crossing_edges > 0)
    text += fmt::format(
        "warning: the surface crosses itself at {}; where parts overlap, inside and outside may be "
        "wrong. Unite the parts in the program it comes from.\n",
        counted(r.crossing_edges, "edge", "edges"));
  warn_of_span(text, r.thinnest.wall, "thinnest wall", "cells it may have holes or vanish", r.dx);
  warn_of_span(text, r.thinnest.gap, "narrowest gap", "cells it may close", r.dx);
  return text;
}

}  // namespace

StlReport report(TriangleMesh const& mesh, double dx)
{
  auto const joined = topology(mesh);
  auto const tree = make_tree(mesh);
  auto const sides = orientation(mesh, joined, tree);
  auto const box = bounds(mesh);
  return {static_cast<int>(mesh.triangles.size()),
          mesh.degenerate,
          static_cast<int>(mesh.vertices.size()),
          joined,
          sides.normals,
          box,
          area(mesh),
          sides.volume,
          crossing_edges(mesh, tree),
          thinnest(mesh, joined, tree, sides, diagonal(box)),
          sign_rule(mesh, joined, sides),
          dx};
}

std::string text(StlReport const& r)
{
  Vec3 const size = r.bounds.hi - r.bounds.lo;
  auto const unit = readable_unit(std::max({size[0], size[1], size[2]}));
  double const m = unit.metres;
  std::string text = fmt::format(
      "surface   {} on {} in {}{}\n", counted(r.triangles, "triangle", "triangles"),
      counted(r.vertices, "vertex", "vertices"), counted(r.topology.shells, "shell", "shells"),
      r.degenerate > 0 ? fmt::format("; {} without area left out", r.degenerate) : "");
  text += fmt::format("          {}, {}; inside and outside by {}\n", closedness(r.topology),
                      normals_in_words(r.normals),
                      r.sign_rule == SignRule::pseudo_normals ? "pseudo-normals" : "votes of rays");
  text +=
      fmt::format("size      {} {}, from ({}) to ({}) {}\n", in_unit(size, unit, " x "), unit.name,
                  in_unit(r.bounds.lo, unit, ", "), in_unit(r.bounds.hi, unit, ", "), unit.name);
  text += fmt::format(
      "          area {:.4g} {}2, volume {}\n", r.area / (m * m), unit.name,
      r.volume ? fmt::format("{:.4g} {}3", *r.volume / (m * m * m), unit.name) : "not defined");
  text += fmt::format("wall      thinnest {}\n", span_in_words(r.thinnest.wall, r, unit));
  text += fmt::format("gap       narrowest {}\n", span_in_words(r.thinnest.gap, r, unit));
  return text + warnings(r);
}

}  // namespace velum::core
