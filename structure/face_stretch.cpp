#include "structure/face_stretch.hpp"

#include <algorithm>
#include <cmath>

namespace velum::structure {
namespace {

core::Vec2 along(Eigen::VectorXd const& x, int e) { return node(x, e + 1) - node(x, e); }

/// From one direction to another.
double angle(core::Vec2 a, core::Vec2 b)
{
  return std::abs(std::atan2(a[0] * b[1] - a[1] * b[0], dot(a, b)));
}

}  // namespace

double largest_face_stretch(Membrane const& m, Rim rim)
{
  auto const length = [&](int e) { return norm(along(m.reference, e)); };
  auto const stretch = [&](int e) { return norm(along(m.position, e)) / length(e); };
  int const elements = element_count(m);
  double largest = 0;
  for (int a = 0; a <= elements; ++a) {
    int const before = std::max(a - 1, 0), behind = std::min(a, elements - 1);
    double const H = (m.thickness[before] + m.thickness[behind]) / 2;  // as line_bending.hpp has it
    double turn = 0;
    if (before != behind)
      turn = 2 * angle(along(m.position, before), along(m.position, behind)) /
             (length(before) + length(behind));
    else if (rim == Rim::clamped && m.fixed[2 * a] && m.fixed[2 * a + 1])
      turn = 2 * angle(along(m.reference, behind), along(m.position, behind)) / length(behind);
    else if (a == 0 && starts_on_axis(m))  // the mirror image goes on beyond the axis
      turn = 2 * angle({0, 1}, along(m.position, 0)) / length(0);
    largest = std::max(largest, (stretch(before) + stretch(behind)) / 2 + H / 2 * turn);
  }
  return largest;
}

}  // namespace velum::structure
