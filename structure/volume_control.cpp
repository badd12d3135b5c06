#include "structure/volume_control.hpp"

#include "core/check.hpp"
#include "structure/pressure_load.hpp"
#include "structure/restrained.hpp"
#include "structure/sheet_pressure.hpp"
#include "structure/total_stiffness.hpp"

#include <fmt/format.h>
#include <Eigen/SparseLU>

#include <cmath>
#include <numbers>

namespace velum::structure {
namespace {

/// Residual of the forces, gradient of the volume, and what is missing of it.
struct Balance {
  Eigen::VectorXd residual, gradient;
  double scale, missing;

  double error(double volume) const
  {
    return std::max(residual.cwiseAbs().maxCoeff() / scale, std::abs(missing / volume));
  }
};

template <class Body>
Balance balance(Body const& body, Inflation const& by, double pressure, double volume)
{
  Eigen::VectorXd elastic = Eigen::VectorXd::Zero(body.position.size()), gradient = elastic;
  by.unit_pressure(body.position, gradient, nullptr);
  add_elastic_force(body, body.position, elastic);
  Balance b{elastic + pressure * gradient, gradient, elastic.cwiseAbs().maxCoeff(),
            volume - by.volume(body.position)};
  drop_fixed(body.fixed, b.residual);
  drop_fixed(body.fixed, b.gradient);
  return b;
}

/// The correction of positions and, last, of the pressure.
template <class Body>
Eigen::VectorXd correction(Body const& body, Inflation const& by, double pressure, Balance const& b)
{
  int const n = static_cast<int>(body.position.size());
  Triplets entries = total_stiffness(body, body.position, {&by.unit_pressure, 1}, pressure);
  auto fixed = body.fixed;
  fixed.push_back(0);
  for (int i = 0; i < n; ++i)
    if (b.gradient[i] != 0) {
      entries.emplace_back(i, n, -b.gradient[i]);
      entries.emplace_back(n, i, b.gradient[i]);
    }
  Eigen::VectorXd right(n + 1);
  right << b.residual, b.missing;
  Eigen::SparseLU<Eigen::SparseMatrix<double>> const lu(restrained(entries, fixed));
  return lu.info() == Eigen::Success ? Eigen::VectorXd(lu.solve(right))
                                     : Eigen::VectorXd::Constant(n + 1, std::nan(""));
}

}  // namespace

Inflation inflation(Sheet const& s)
{
  return {[&s](Eigen::VectorXd const& x) { return swept_volume(s, x); },
          [&s, outwards = Eigen::VectorXd(Eigen::VectorXd::Constant(element_count(s), -1))](
              Eigen::VectorXd const& x, Eigen::VectorXd& force, Triplets* tangent) {
            pressure_load(s, outwards)(x, force, tangent);
          }};
}

Inflation inflation(Membrane const& m)
{
  auto const volume = [&m](Eigen::VectorXd const& x) {
    bool const ring = m.symmetry == core::Symmetry::axisymmetric;
    double sum = 0;
    for (int e = 0; e < element_count(m); ++e) {
      auto const p = node(x, e), q = node(x, e + 1);
      sum += ring ? std::numbers::pi / 3 * (p[0] - q[0]) * (p[1] * p[1] + p[1] * q[1] + q[1] * q[1])
                  : (p[0] - q[0]) * (p[1] + q[1]) / 2;
    }
    return sum;
  };
  return {
      [volume, start = volume(m.reference)](Eigen::VectorXd const& x) { return volume(x) - start; },
      [&m, from_below = uniform_pressure(m, Side::minus, 1)](
          Eigen::VectorXd const& x, Eigen::VectorXd& force, Triplets* tangent) {
        pressure_load(m, from_below)(x, force, tangent);
      }};
}

template <class Body>
VolumeReport solve_at_volume(Body& body, Inflation const& by, double volume, double pressure,
                             VolumeOptions const& options)
{
  VolumeReport report{.pressure = pressure};
  double const start = by.volume(body.position);
  double carried = 0, step = 1;
  while (carried < 1) {
    double const part = std::min(1.0, carried + step);
    double const wanted = start + part * (volume - start);
    Eigen::VectorXd const good = body.position;
    double p = report.pressure;
    double const floor = rounding_force(body, body.position);
    auto b = balance(body, by, p, wanted);
    int iteration = 0;
    auto const done = [&] { return b.error(wanted) <= options.tolerance + floor / b.scale; };
    for (; iteration < options.max_iterations && !done(); ++iteration) {
      auto const change = correction(body, by, p, b);
      body.position += change.head(body.position.size());
      p += change[change.size() - 1];
      b = balance(body, by, p, wanted);
      if (!std::isfinite(b.error(wanted)) || largest_stretch(body, body.position) > 1e3) break;
    }
    report.iterations += iteration;
    if (done()) {
      carried = part;
      report.pressure = p;
      ++report.steps;
      step *= 2;
      continue;
    }
    body.position = good;
    step /= 2;
    if (step < options.min_step)
      throw core::Divergence(fmt::format(
          "no static equilibrium beyond {:.4f} of the way to the volume {:.4g} (residual {:.1e} of "
          "the nodal force); start from a tense state, or go in smaller steps",
          carried, volume, b.error(wanted)));
  }
  body.velocity.setZero();
  return report;
}

template VolumeReport solve_at_volume(Membrane&, Inflation const&, double, double,
                                      VolumeOptions const&);
template VolumeReport solve_at_volume(Sheet&, Inflation const&, double, double,
                                      VolumeOptions const&);

}  // namespace velum::structure
