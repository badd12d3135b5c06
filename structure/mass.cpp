#include "structure/mass.hpp"

#include <cmath>

namespace velum::structure {
namespace {

/// Sum over elements of value(e) times the integral of each end's shape function over the ring;
/// the ring grows linearly along the element, hence the weights 1/3 and 1/6.
template <class PerElement>
Eigen::VectorXd lump(Membrane const& m, PerElement value)
{
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(node_count(m));
  for (int e = 0; e < element_count(m); ++e) {
    auto const a = node(m.reference, e), b = node(m.reference, e + 1);
    double const share = value(e) * norm(b - a);
    double const ra = core::ring(m.symmetry, a[1]), rb = core::ring(m.symmetry, b[1]);
    sum[e] += share * (2 * ra + rb) / 6;
    sum[e + 1] += share * (ra + 2 * rb) / 6;
  }
  return sum;
}

}  // namespace

Eigen::VectorXd nodal_area(Membrane const& m)
{
  return lump(m, [](int) { return 1.0; });
}

Eigen::VectorXd lumped_mass(Membrane const& m)
{
  return lump(m, [&](int e) { return m.density * m.thickness[e]; });
}

double kinetic_energy(Membrane const& m, Eigen::VectorXd const& mass)
{
  double energy = 0;
  for (int a = 0; a < node_count(m); ++a) {
    auto const v = node(m.velocity, a);
    energy += 0.5 * mass[a] * dot(v, v);
  }
  return energy;
}

}  // namespace velum::structure
