#include "structure/sheet_force.hpp"

#include "structure/triangle_element.hpp"

#include <algorithm>
#include <limits>

namespace velum::structure {
namespace {

template <class Value>
Eigen::VectorXd lump(Sheet const& s, Value const& value)
{
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(node_count(s));
  for (int e = 0; e < element_count(s); ++e)
    for (int a : s.triangles[static_cast<std::size_t>(e)])
      sum[a] += value(e) * triangle_shape(s, e).area / 3;
  return sum;
}

}  // namespace

double elastic_energy(Sheet const& s, Eigen::VectorXd const& x)
{
  double energy = 0;
  for (int e = 0; e < element_count(s); ++e) {
    auto const k = triangle_element(s, x, e);
    energy += k.volume * k.energy.W;
  }
  return energy;
}

void add_elastic_force(Sheet const& s, Eigen::VectorXd const& x, Eigen::VectorXd& force)
{
  for (int e = 0; e < element_count(s); ++e) {
    Vector9 const f = element_force(triangle_element(s, x, e));
    auto const& t = s.triangles[static_cast<std::size_t>(e)];
    for (int a = 0; a < 3; ++a) force.segment<3>(3 * t[a]) -= f.segment<3>(3 * a);
  }
}

void add_stiffness(Sheet const& s, Eigen::VectorXd const& x, Triplets& stiffness)
{
  for (int e = 0; e < element_count(s); ++e) {
    Matrix9 const K = element_tangent(triangle_element(s, x, e));
    add_block(stiffness, s.triangles[static_cast<std::size_t>(e)], K);
  }
}

double rounding_force(Sheet const& s, Eigen::VectorXd const& x)
{
  double stiffest = 0;
  for (int e = 0; e < element_count(s); ++e) {
    auto const k = triangle_shape(s, e);
    stiffest = std::max(stiffest, 4 * shear_modulus(s.material) * s.thickness[e] * k.area *
                                      k.gradient.squaredNorm());
  }
  return 4 * std::numeric_limits<double>::epsilon() * stiffest * x.cwiseAbs().maxCoeff();
}

double largest_stretch(Sheet const& s, Eigen::VectorXd const& x)
{
  double largest = 0;
  for (int e = 0; e < element_count(s); ++e) {
    auto const F = deformation_gradient(s, x, triangle_shape(s, e), e);
    largest = std::max(largest, principal_stretches(F)[0]);
  }
  return largest;
}

Eigen::VectorXd nodal_area(Sheet const& s)
{
  return lump(s, [](int) { return 1.0; });
}

Eigen::VectorXd lumped_mass(Sheet const& s)
{
  return lump(s, [&](int e) { return s.density * s.thickness[e]; });
}

Eigen::VectorXd nodal_thickness(Sheet const& s, Eigen::VectorXd const& x)
{
  return lump(s,
              [&](int e) {
                auto const F = deformation_gradient(s, x, triangle_shape(s, e), e);
                return s.thickness[e] / F.col(0).cross(F.col(1)).norm();
              })
      .cwiseQuotient(nodal_area(s));
}

Triplets consistent_mass(Sheet const& s)
{
  Triplets entries;
  for (int e = 0; e < element_count(s); ++e) {
    double const share = s.density * s.thickness[e] * triangle_shape(s, e).area / 12;
    auto const& t = s.triangles[static_cast<std::size_t>(e)];
    for (int a : t)
      for (int b : t)
        for (int i = 0; i < 3; ++i)
          entries.emplace_back(3 * a + i, 3 * b + i, (a == b ? 2 : 1) * share);
  }
  return entries;
}

double kinetic_energy(Sheet const& s, Eigen::VectorXd const& mass)
{
  double energy = 0;
  for (int a = 0; a < node_count(s); ++a)
    energy += mass[a] / 2 * node3(s.velocity, a).squaredNorm();
  return energy;
}

}  // namespace velum::structure
