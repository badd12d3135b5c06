#include "structure/sheet_mesh.hpp"

#include "core/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace velum::structure {
namespace {

constexpr double turn = 2 * std::numbers::pi;

void put(TriangleMesh& mesh, int at, double x, double y, double z)
{
  mesh.points.segment<3>(3 * at) = Eigen::Vector3d(x, y, z);
}

void require_ascending(std::vector<double> const& places, char const* what)
{
  core::require(places.size() >= 2 && std::ranges::is_sorted(places, std::less_equal<>()),
                fmt::format("The {} of a mesh must ascend, two of them at least.", what));
}

/// Squares of rows and columns of points, each cut in two, the diagonals of neighbours mirrored so
/// that no direction is preferred. The first points of a closed row follow its last.
std::vector<Triangle> cut_squares(int rows, int columns, bool closed)
{
  std::vector<Triangle> triangles;
  for (int r = 0; r + 1 < rows; ++r)
    for (int c = 0; c + (closed ? 0 : 1) < columns; ++c) {
      int const next = (c + 1) % columns;
      int const a = r * columns + c, b = (r + 1) * columns + c;
      int const d = r * columns + next, e = (r + 1) * columns + next;
      if ((r + c) % 2 == 0) {
        triangles.push_back({a, b, e});
        triangles.push_back({a, e, d});
      } else {
        triangles.push_back({a, b, d});
        triangles.push_back({b, e, d});
      }
    }
  return triangles;
}

}  // namespace

std::vector<double> graded(double a, double b, int n, double grading)
{
  core::require(n > 0 && grading > 0, "A grading needs a positive number of steps and factor.");
  double const q = n > 1 ? std::pow(grading, 1.0 / (n - 1)) : 1;
  std::vector<double> places{a};
  double step = 1, sum = 0;
  for (int i = 0; i < n; ++i, step *= q) places.push_back(sum += step);
  for (int i = 1; i <= n; ++i)
    places[static_cast<std::size_t>(i)] = a + (b - a) * places[static_cast<std::size_t>(i)] / sum;
  return places;
}

TriangleMesh disc_mesh(std::vector<double> const& radii)
{
  std::vector<double> rings = radii;
  if (!rings.empty() && rings.front() == 0) rings.erase(rings.begin());
  core::require(
      !rings.empty() && rings.front() > 0 && std::ranges::is_sorted(rings, std::less_equal<>()),
      "The radii of a disc must ascend from above 0.");
  int const n = static_cast<int>(rings.size());
  auto const first = [](int ring) { return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1); };
  TriangleMesh mesh;
  mesh.points = Eigen::VectorXd::Zero(3 * first(n + 1));
  for (int r = 1; r <= n; ++r)
    for (int k = 0; k < 6 * r; ++k) {
      double const angle = turn * k / (6 * r), radius = rings[static_cast<std::size_t>(r - 1)];
      put(mesh, first(r) + k, 0, radius * std::cos(angle), radius * std::sin(angle));
    }
  for (int r = 0; r < n; ++r)
    for (int sector = 0; sector < 6; ++sector)
      for (int k = 0; k <= r; ++k) {
        auto const inner = [&](int i) {
          return r == 0 ? 0 : first(r) + (sector * r + i) % (6 * r);
        };
        auto const outer = [&](int i) {
          return first(r + 1) + (sector * (r + 1) + i) % (6 * (r + 1));
        };
        mesh.triangles.push_back({inner(k), outer(k), outer(k + 1)});
        if (k < r) mesh.triangles.push_back({inner(k), outer(k + 1), inner(k + 1)});
      }
  return mesh;
}

TriangleMesh annulus_mesh(std::vector<double> const& radii, int sectors)
{
  require_ascending(radii, "radii");
  core::require(radii.front() > 0 && sectors >= 3,
                "An annulus needs an inner radius above 0 and three sectors at least.");
  int const rows = static_cast<int>(radii.size());
  TriangleMesh mesh{Eigen::VectorXd(3 * rows * sectors), cut_squares(rows, sectors, true)};
  for (int r = 0; r < rows; ++r)
    for (int k = 0; k < sectors; ++k) {
      double const angle = turn * k / sectors, radius = radii[static_cast<std::size_t>(r)];
      put(mesh, r * sectors + k, 0, radius * std::cos(angle), radius * std::sin(angle));
    }
  return mesh;
}

TriangleMesh strip_mesh(std::vector<double> const& y, std::vector<double> const& z)
{
  require_ascending(y, "places along y");
  require_ascending(z, "places along z");
  int const rows = static_cast<int>(y.size()), columns = static_cast<int>(z.size());
  TriangleMesh mesh{Eigen::VectorXd(3 * rows * columns), cut_squares(rows, columns, false)};
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      put(mesh, r * columns + c, 0, y[static_cast<std::size_t>(r)], z[static_cast<std::size_t>(c)]);
  return mesh;
}

TriangleMesh tube_mesh(double radius, std::vector<double> const& x, int sectors)
{
  require_ascending(x, "places along x");
  core::require(radius > 0 && sectors >= 3,
                "A tube needs a radius above 0 and three sectors at least.");
  int const rows = static_cast<int>(x.size());
  TriangleMesh mesh{Eigen::VectorXd(3 * rows * sectors), cut_squares(rows, sectors, true)};
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);  // outwards
  for (int r = 0; r < rows; ++r)
    for (int k = 0; k < sectors; ++k) {
      double const angle = turn * k / sectors;
      put(mesh, r * sectors + k, x[static_cast<std::size_t>(r)], radius * std::cos(angle),
          radius * std::sin(angle));
    }
  return mesh;
}

std::vector<int> rim_points(TriangleMesh const& mesh)
{
  std::map<std::pair<int, int>, int> uses;
  for (auto const& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) ++uses[std::pair<int, int>(std::minmax(t[i], t[(i + 1) % 3]))];
  std::set<int> rim;
  for (auto const& [edge, count] : uses)
    if (count == 1) rim.insert({edge.first, edge.second});
  return {rim.begin(), rim.end()};
}

}  // namespace velum::structure
