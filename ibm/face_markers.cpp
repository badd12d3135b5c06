#include "ibm/face_markers.hpp"

#include <algorithm>
#include <cmath>

namespace velum::ibm {

namespace {

constexpr double widest_spacing = 1.25;  // cells

int count_for(double length, int present)
{
  if (present == 0) return std::max(1, static_cast<int>(std::ceil(length - 1e-6)));
  return std::max(present, static_cast<int>(std::ceil(length / widest_spacing)));
}

}  // namespace

void place(FaceMarkers& markers, Surface const& surface, core::Symmetry symmetry)
{
  auto const& faces = surface.faces;
  markers.list.clear();
  for (int side : {0, 1}) {
    bool const plus = side == 0;
    double const sign = plus ? 1 : -1;
    auto const& face = plus ? faces.plus : faces.minus;
    auto& per_segment = markers.per_segment[side];
    per_segment.resize(face.size() - 1, 0);
    for (std::size_t e = 0; e + 1 < face.size(); ++e) {
      core::Vec2 const d = face[e + 1] - face[e];
      double const length = norm(d);
      if (!(length > 0)) continue;
      int const count = per_segment[e] = count_for(length, per_segment[e]);
      core::Vec2 const outward = (sign / length) * core::Vec2{d[1], -d[0]};
      core::Vec2 const drift[2] = {sign * surface.thickening[e] * faces.normal[e],
                                   sign * surface.thickening[e + 1] * faces.normal[e + 1]};
      for (int m = 0; m < count; ++m) {
        double const t = (m + 0.5) / count;
        core::Vec2 const X = face[e] + t * d;
        double const ring = std::max(0.0, core::ring(symmetry, X[1]));
        int const a = static_cast<int>(e);
        markers.list.push_back({X, outward, (1 - t) * drift[0] + t * drift[1],
                                ring * length / count, a, a + 1, t, plus});
      }
    }
  }
}

}  // namespace velum::ibm
