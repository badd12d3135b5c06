#include "core/geometry/thickness.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace velum::core {
namespace {

/// Hands the centroid of each piece of a facet to visit, halving the longest edge until no piece
/// has one longer than `longest`.
template <class Visit>
void visit_pieces(Facet const& f, double longest, Visit const& visit)
{
  double const length[3] = {norm(f[1] - f[0]), norm(f[2] - f[1]), norm(f[0] - f[2])};
  auto const k = static_cast<std::size_t>(std::max_element(length, length + 3) - length);
  if (length[k] <= longest) return visit((1.0 / 3) * (f[0] + f[1] + f[2]));
  Vec3 const from = f[k], to = f[(k + 1) % 3], apex = f[(k + 2) % 3], half = 0.5 * (from + to);
  visit_pieces({from, half, apex}, longest, visit);
  visit_pieces({half, to, apex}, longest, visit);
}

class Prober {
 public:
  Prober(TriangleMesh const& mesh, MeshTopology const& topology, TriangleTree const& tree,
         Orientation const& orientation)
      : tree_(tree), touching_(1e-9 * diagonal(bounds(mesh)))
  {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      Vec3 const along = area_vector(facet(mesh, static_cast<int>(t)));
      bool const inverted = orientation.inverted[static_cast<std::size_t>(topology.shell[t])];
      outward_.push_back(((inverted ? -1 : 1) / norm(along)) * along);
    }
  }

  Vec3 const& outward(int t) const { return outward_[static_cast<std::size_t>(t)]; }

  /// Shortens `least` to the ray from p on triangle t along or against its normal, where that is
  /// shorter.
  void probe(std::optional<Span>& least, double limit, int t, Vec3 const& p, Vec3 const& direction)
  {
    // From a little behind the face, so that one which touches it is met, at length zero.
    Vec3 const origin = p - touching_ * direction;
    double shortest = (least ? least->length : limit) + touching_;
    int met = -1;
    visit_crossings(tree_, origin, direction, shortest, [&](int other, Crossing const& hit) {
      if (other != t) shortest = hit.t, met = other;
      return shortest;
    });
    constexpr double opposite = -0.707;
    if (met < 0 || dot(outward(met), outward(t)) > opposite) return;
    double const length = std::max(0.0, shortest - touching_);
    // Of equal lengths, which differ by round-off, the first found stays.
    if (!least || length < least->length - touching_)
      least = Span{length, p + (0.5 * length) * direction};
  }

 private:
  TriangleTree const& tree_;
  double touching_;
  std::vector<Vec3> outward_;
};

}  // namespace

Thickness thinnest(TriangleMesh const& mesh, MeshTopology const& topology, TriangleTree const& tree,
                   Orientation const& orientation, double limit)
{
  Prober prober(mesh, topology, tree, orientation);
  double const longest = diagonal(bounds(mesh)) / 50;
  Thickness thickness;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    Vec3 const outward = prober.outward(t);
    visit_pieces(facet(mesh, t), longest, [&](Vec3 const& p) {
      prober.probe(thickness.wall, limit, t, p, -1.0 * outward);
      prober.probe(thickness.gap, limit, t, p, outward);
    });
  }
  return thickness;
}

}  // namespace velum::core
