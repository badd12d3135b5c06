#include "ibm/surface.hpp"

#include <cmath>
#include <string>

#include "core/check.hpp"

namespace velum::ibm {

namespace {

// far enough to leave any box: the continuation only has to divide what is inside
constexpr double far_away = 1e4;

void fill(FaceLine& line, std::vector<core::Vec2> const& face, bool axis)
{
  int const n = static_cast<int>(face.size());
  auto const count = static_cast<std::size_t>(n);
  line.points.resize(count + 2);
  line.first.resize(count + 1);
  line.second.resize(count + 1);
  core::Vec2 const begin = face[0];
  line.points[0] =
      axis ? core::Vec2{face[1][0], -face[1][1]} : core::Vec2{begin[0], begin[1] - far_away};
  line.first[0] = axis ? 1 : 0;
  line.second[0] = 0;
  for (int a = 0; a < n; ++a) {
    auto const k = static_cast<std::size_t>(a);
    line.points[k + 1] = face[k];
    line.first[k + 1] = a;
    line.second[k + 1] = a + 1 < n ? a + 1 : a;
  }
  line.points[count + 1] = {face[count - 1][0], face[count - 1][1] + far_away};
}

/// Throws where a face is lost: everything behind takes its points for numbers.
void check_finite(structure::Faces const& faces)
{
  for (std::size_t a = 0; a < faces.plus.size(); ++a)
    for (int d : {0, 1})
      if (!std::isfinite(faces.plus[a][d]) || !std::isfinite(faces.minus[a][d]))
        throw core::Divergence("the faces of the membrane are no longer finite, first at node " +
                               std::to_string(a) +
                               ": an element next to it has collapsed or run "
                               "away; load, sub-step or contact may be too stiff");
}

}  // namespace

void locate(Surface& surface, structure::Membrane const& membrane)
{
  auto const n = static_cast<std::size_t>(structure::node_count(membrane));
  std::vector<double> before = surface.faces.thickness;
  structure::locate_faces(membrane, membrane.position, 1.0, surface.faces);
  check_finite(surface.faces);
  surface.thickening.resize(n, 0);
  if (before.empty()) before = surface.faces.thickness;
  for (std::size_t a = 0; a < n; ++a)
    surface.thickening[a] +=
        ((surface.faces.thickness[a] - before[a]) / 2 - surface.thickening[a]) / thickening_memory;
  bool const axis = structure::starts_on_axis(membrane);
  fill(surface.plus, surface.faces.plus, axis);
  fill(surface.minus, surface.faces.minus, axis);
}

}  // namespace velum::ibm
