#include "structure/side_jump.hpp"

namespace velum::structure {
namespace {

template <int d>
bool side_jumped(Eigen::VectorXd const& before, Eigen::VectorXd const& after, int a, int b)
{
  auto const side = [&](Eigen::VectorXd const& x) -> Eigen::Matrix<double, d, 1> {
    return x.segment<d>(d * b) - x.segment<d>(d * a);
  };
  return (side(after) - side(before)).norm() > side(before).norm();
}

}  // namespace

bool jumped(Membrane const& m, Eigen::VectorXd const& before, Eigen::VectorXd const& after)
{
  for (int e = 0; e < element_count(m); ++e)
    if (side_jumped<2>(before, after, e, e + 1)) return true;
  return false;
}

bool jumped(Sheet const& s, Eigen::VectorXd const& before, Eigen::VectorXd const& after)
{
  for (auto const& t : s.triangles)
    for (int i = 0; i < 3; ++i)
      if (side_jumped<3>(before, after, t[i], t[(i + 1) % 3])) return true;
  return false;
}

}  // namespace velum::structure
