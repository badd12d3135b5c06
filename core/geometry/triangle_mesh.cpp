#include "core/geometry/triangle_mesh.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>

namespace velum::core {
namespace {

using Cell = std::array<std::int64_t, 3>;

struct CellHash {
  std::size_t operator()(Cell const& cell) const
  {
    std::uint64_t hash = 0;
    for (auto const c : cell) hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15u;
    return static_cast<std::size_t>(hash ^ (hash >> 32));
  }
};

/// Two steps of single precision, in which STL files are written, at the largest coordinate.
double rounding(std::vector<Facet> const& facets)
{
  double largest = 0;
  for (auto const& facet : facets)
    for (auto const& corner : facet)
      for (double const x : corner.c) largest = std::max(largest, std::abs(x));
  return std::ldexp(largest, -22);
}

/// Vertices by the cell of a coarse grid in which they lie: a point's neighbours are in its own
/// cell, or in the next one where it lies by a border.
class VertexMerger {
 public:
  explicit VertexMerger(double tolerance)
      : tolerance_(tolerance), spacing_(tolerance > 0 ? 1000 * tolerance : 1)
  {
  }

  int vertex_at(Vec3 const& p)
  {
    Vec3 const reach{tolerance_, tolerance_, tolerance_};
    Cell const lo = cell(p - reach), hi = cell(p + reach);
    for (auto i = lo[0]; i <= hi[0]; ++i)
      for (auto j = lo[1]; j <= hi[1]; ++j)
        for (auto k = lo[2]; k <= hi[2]; ++k) {
          auto const [begin, end] = by_cell_.equal_range({i, j, k});
          for (auto at = begin; at != end; ++at)
            if (norm(vertices[static_cast<std::size_t>(at->second)] - p) <= tolerance_)
              return at->second;
        }
    auto const fresh = static_cast<int>(vertices.size());
    vertices.push_back(p);
    by_cell_.emplace(cell(p), fresh);
    return fresh;
  }

  std::vector<Vec3> vertices;

 private:
  Cell cell(Vec3 const& p) const
  {
    Cell at{};
    for (int k = 0; k < 3; ++k)
      at[static_cast<std::size_t>(k)] = static_cast<std::int64_t>(std::floor(p[k] / spacing_));
    return at;
  }

  double tolerance_, spacing_;
  std::unordered_multimap<Cell, int, CellHash> by_cell_;
};

double longest_edge(Facet const& f)
{
  return std::max({norm(f[1] - f[0]), norm(f[2] - f[1]), norm(f[0] - f[2])});
}

}  // namespace

TriangleMesh merge(std::vector<Facet> const& facets)
{
  double const tolerance = rounding(facets);
  VertexMerger merger(tolerance);
  TriangleMesh mesh;
  for (auto const& given : facets) {
    Triangle const t{merger.vertex_at(given[0]), merger.vertex_at(given[1]),
                     merger.vertex_at(given[2])};
    bool const collapsed = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    auto const corner = [&](std::size_t k) {
      return merger.vertices[static_cast<std::size_t>(t[k])];
    };
    Facet const f{corner(0), corner(1), corner(2)};
    bool const thin = 2 * norm(area_vector(f)) <= tolerance * longest_edge(f);
    if (!collapsed && !thin) mesh.triangles.push_back(t);
    if (!collapsed && thin) mesh.needles.push_back(t);
    if (collapsed || thin) ++mesh.degenerate;
  }
  mesh.vertices = std::move(merger.vertices);
  return mesh;
}

Facet facet(TriangleMesh const& mesh, int t)
{
  auto const& [a, b, c] = mesh.triangles[static_cast<std::size_t>(t)];
  auto const at = [&](int v) { return mesh.vertices[static_cast<std::size_t>(v)]; };
  return {at(a), at(b), at(c)};
}

Vec3 area_vector(Facet const& f) { return 0.5 * cross(f[1] - f[0], f[2] - f[0]); }

Bounds bounds(TriangleMesh const& mesh)
{
  Bounds all;
  for (auto const& triangle : mesh.triangles)
    for (int const v : triangle) extend(all, mesh.vertices[static_cast<std::size_t>(v)]);
  return all;
}

double area(TriangleMesh const& mesh)
{
  double sum = 0;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    sum += norm(area_vector(facet(mesh, t)));
  return sum;
}

}  // namespace velum::core
