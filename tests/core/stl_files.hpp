#pragma once
#include "core/geometry/triangle_mesh.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace velum::tests {

using Facets = std::vector<core::Facet>;

inline Facets operator+(Facets a, Facets const& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

inline core::Facet turned(core::Facet const& f) { return {f[0], f[2], f[1]}; }

/// The same surface with its normals on the other side.
inline Facets turned(Facets facets)
{
  for (auto& f : facets) f = turned(f);
  return facets;
}

/// Right prism over a polygon that runs counter-clockwise, from z = lo to z = hi. Its ends are fans
/// from `hub`, from which all corners must be seen.
inline Facets prism(std::vector<core::Vec2> const& corners, core::Vec2 hub, double lo, double hi)
{
  Facets facets;
  auto const up = [](core::Vec2 const& p, double z) { return core::Vec3{p[0], p[1], z}; };
  for (std::size_t k = 0; k < corners.size(); ++k) {
    auto const a = corners[k], b = corners[(k + 1) % corners.size()];
    facets.push_back({up(a, lo), up(b, lo), up(b, hi)});
    facets.push_back({up(a, lo), up(b, hi), up(a, hi)});
    facets.push_back({up(hub, hi), up(a, hi), up(b, hi)});
    facets.push_back({up(hub, lo), up(b, lo), up(a, lo)});
  }
  return facets;
}

/// Two triangles a side.
inline Facets cuboid(core::Vec3 lo, core::Vec3 hi)
{
  Facets facets;
  for (int axis = 0; axis < 3; ++axis)
    for (bool const upper : {false, true}) {
      auto const corner = [&](bool i, bool j) {
        core::Vec3 p;
        int const u = (axis + 1) % 3, v = (axis + 2) % 3;
        p[axis] = upper ? hi[axis] : lo[axis];
        p[u] = i ? hi[u] : lo[u];
        p[v] = j ? hi[v] : lo[v];
        return p;
      };
      core::Facet const a{corner(0, 0), corner(1, 0), corner(1, 1)};
      core::Facet const b{corner(0, 0), corner(1, 1), corner(0, 1)};
      for (auto const& f : {a, b}) facets.push_back(upper ? f : turned(f));
    }
  return facets;
}

/// Octahedron whose triangles are quartered `levels` times, corners on the sphere.
inline Facets ball(core::Vec3 centre, double radius, int levels)
{
  Facets facets;
  core::Vec3 const x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  for (double const i : {-1.0, 1.0})
    for (double const j : {-1.0, 1.0})
      for (double const k : {-1.0, 1.0}) {
        core::Facet const f{i * x, j * y, k * z};
        facets.push_back(i * j * k > 0 ? f : turned(f));
      }
  auto const middle = [](core::Vec3 a, core::Vec3 b) { return (1 / norm(a + b)) * (a + b); };
  for (int level = 0; level < levels; ++level) {
    Facets finer;
    for (auto const& [a, b, c] : facets) {
      auto const ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer = finer + Facets{{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}};
    }
    facets = finer;
  }
  for (auto& f : facets)
    for (auto& corner : f) corner = centre + radius * corner;
  return facets;
}

/// Bytes of a binary STL file; the header is filled up with zeros.
inline std::string binary_stl(Facets const& facets, std::string header = "velum")
{
  header.resize(80);
  auto const append = [&](auto value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    header.append(bytes, sizeof value);
  };
  append(static_cast<std::uint32_t>(facets.size()));
  for (auto const& f : facets) {
    for (int k = 0; k < 3; ++k) append(0.0f);
    for (auto const& corner : f)
      for (double const value : corner.c) append(static_cast<float>(value));
    append(std::uint16_t{0});
  }
  return header;
}

inline std::string ascii_stl(Facets const& facets)
{
  std::string text = "solid part of a test\n";
  for (auto const& f : facets) {
    text += "  facet normal 0 0 0\n    outer loop\n";
    for (auto const& corner : f) {
      auto const& [x, y, z] = corner.c;
      char line[100];
      std::snprintf(line, sizeof line, "      vertex %.9g %.9g %.9g\n", x, y, z);
      text += line;
    }
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid part of a test\n";
}

inline std::filesystem::path write(std::filesystem::path const& file, std::string const& bytes)
{
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

}  // namespace velum::tests
