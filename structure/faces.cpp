#include "structure/faces.hpp"

#include "structure/line_element.hpp"

#include <cmath>

namespace velum::structure {
namespace {

struct FaceNode {
  core::Vec2 normal;
  double thickness;
};

FaceNode of_element(Membrane const& m, LineElement const& k, int e)
{
  return {{k.ty, -k.tx}, current_thickness(m, k, e)};
}

/// At the joint of elements e and e + 1: each counts with the other's length.
FaceNode between(Membrane const& m, LineElement const& a, LineElement const& b, int e)
{
  double const wa = b.l / (a.l + b.l), wb = a.l / (a.l + b.l);
  core::Vec2 const t{wa * a.tx + wb * b.tx, wa * a.ty + wb * b.ty};
  return {(1 / norm(t)) * core::Vec2{t[1], -t[0]},
          wa * current_thickness(m, a, e) + wb * current_thickness(m, b, e + 1)};
}

}  // namespace

void locate_faces(Membrane const& m, Eigen::VectorXd const& x, double thickness_scale, Faces& faces)
{
  int const nodes = node_count(m);
  faces.normal.resize(nodes);
  faces.thickness.resize(nodes);
  faces.plus.resize(nodes);
  faces.minus.resize(nodes);

  auto element = line_element(m, x, 0);
  auto here = of_element(m, element, 0);
  if (starts_on_axis(m)) here.normal = {std::copysign(1.0, element.ty), 0};
  for (int a = 0; a < nodes; ++a) {
    faces.normal[a] = here.normal;
    faces.thickness[a] = here.thickness;
    auto const half = 0.5 * thickness_scale * here.thickness * here.normal;
    faces.plus[a] = node(x, a) + half;
    faces.minus[a] = node(x, a) - half;
    if (a + 2 < nodes) {
      auto const next = line_element(m, x, a + 1);
      here = between(m, element, next, a);
      element = next;
    } else {
      here = of_element(m, element, nodes - 2);
    }
  }
}

}  // namespace velum::structure
