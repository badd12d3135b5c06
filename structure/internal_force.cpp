#include "structure/internal_force.hpp"

#include "structure/line_element.hpp"

#include <algorithm>
#include <limits>

namespace velum::structure {

double elastic_energy(Membrane const& m, Eigen::VectorXd const& x)
{
  double energy = 0;
  for (int e = 0; e < element_count(m); ++e) {
    auto const k = line_element(m, x, e);
    energy += k.A * membrane_energy(m.material, m.thickness[e], k.l1, k.l2).W;
  }
  return energy;
}

void add_elastic_force(Membrane const& m, Eigen::VectorXd const& x, Eigen::VectorXd& force)
{
  for (int e = 0; e < element_count(m); ++e) force.segment<4>(2 * e) -= element_force(m, x, e);
}

void add_stiffness(Membrane const& m, Eigen::VectorXd const& x, Triplets& stiffness)
{
  for (int e = 0; e < element_count(m); ++e) {
    Eigen::Matrix4d const k = element_tangent(m, x, e);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) stiffness.emplace_back(2 * e + i, 2 * e + j, k(i, j));
  }
}

double rounding_force(Membrane const& m, Eigen::VectorXd const& x)
{
  double stiffest = 0;
  for (int e = 0; e < element_count(m); ++e) {
    auto const k = line_element(m, x, e);
    double const H = m.thickness[e];
    auto const w = membrane_energy(m.material, H, k.l1, k.l2);
    double const modulus = std::max({4 * shear_modulus(m.material) * H, w.K11, w.K22});
    stiffest = std::max(stiffest, modulus * k.A / (k.L * k.L));
  }
  return 4 * std::numeric_limits<double>::epsilon() * stiffest * x.cwiseAbs().maxCoeff();
}

double largest_stretch(Membrane const& m, Eigen::VectorXd const& x)
{
  double largest = 0;
  for (int e = 0; e < element_count(m); ++e) {
    auto const k = line_element(m, x, e);
    largest = std::max({largest, k.l1, k.l2});
  }
  return largest;
}

}  // namespace velum::structure
