#include "structure/pressure_load.hpp"

#include <array>
#include <numbers>

namespace velum::structure {
namespace {

/// Integrals over a segment of p 2 pi y N_a and of p 2 pi N_a N_b (planar: of p N_a and zero); a
/// and b are the element's nodes.
struct Integrals {
  std::array<double, 2> pressure_area{};
  std::array<std::array<double, 2>, 2> by_radius{};
};

Integrals integrate(Membrane const& m, Eigen::VectorXd const& x, PressureSegment const& s)
{
  bool const ring = m.symmetry == core::Symmetry::axisymmetric;
  double const ya = x[2 * s.element + 1], yb = x[2 * s.element + 3];
  Integrals sum;
  for (double const g : {0.5 - 0.5 / std::numbers::sqrt3, 0.5 + 0.5 / std::numbers::sqrt3}) {
    double const xi = s.from + g * (s.to - s.from);
    double const p = 0.5 * (s.to - s.from) * (s.p_from + g * (s.p_to - s.p_from));
    double const N[2] = {1 - xi, xi};
    for (int a = 0; a < 2; ++a) {
      sum.pressure_area[a] += p * N[a] * core::ring(m.symmetry, ya + xi * (yb - ya));
      if (!ring) continue;
      for (int b = 0; b < 2; ++b) sum.by_radius[a][b] += 2 * std::numbers::pi * p * N[a] * N[b];
    }
  }
  return sum;
}

/// Force on node a: pressure_area[a] (-dy, dx) on the plus side, d from the first node to the last.
void add_segment(Membrane const& m, Eigen::VectorXd const& x, PressureSegment const& s,
                 Eigen::VectorXd& force, Triplets* tangent)
{
  auto const w = integrate(m, x, s);
  double const sign = s.side == Side::plus ? 1 : -1;
  int const i = 2 * s.element;
  double const dx = sign * (x[i + 2] - x[i]), dy = sign * (x[i + 3] - x[i + 1]);
  for (int a = 0; a < 2; ++a) {
    force[i + 2 * a] -= w.pressure_area[a] * dy;
    force[i + 2 * a + 1] += w.pressure_area[a] * dx;
    if (!tangent) continue;
    for (int b = 0; b < 2; ++b) {
      double const turn = sign * (b == 0 ? -1 : 1) * w.pressure_area[a];
      int const row = i + 2 * a, column = i + 2 * b;
      tangent->emplace_back(row, column + 1, -turn - w.by_radius[a][b] * dy);
      tangent->emplace_back(row + 1, column, turn);
      tangent->emplace_back(row + 1, column + 1, w.by_radius[a][b] * dx);
    }
  }
}

}  // namespace

FacePressure uniform_pressure(Membrane const& m, Side side, double pressure)
{
  FacePressure all;
  for (int e = 0; e < element_count(m); ++e)
    all.push_back({.element = e, .side = side, .p_from = pressure, .p_to = pressure});
  return all;
}

Load pressure_load(Membrane const& m, FacePressure const& pressure)
{
  return [&m, &pressure](Eigen::VectorXd const& x, Eigen::VectorXd& force, Triplets* tangent) {
    for (auto const& s : pressure) add_segment(m, x, s, force, tangent);
  };
}

Eigen::VectorXd pressure_force(Membrane const& m, FacePressure const& pressure)
{
  Eigen::VectorXd force = Eigen::VectorXd::Zero(m.position.size());
  pressure_load(m, pressure)(m.position, force, nullptr);
  return force;
}

}  // namespace velum::structure
