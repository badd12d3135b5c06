#pragma once
#include <numbers>
#include <vector>

#include "structure/sheet_bending.hpp"
#include "structure/sheet_force.hpp"
#include "structure/sheet_mesh.hpp"
#include "tests/structure/lowest_mode.hpp"

namespace velum::tests {

/// A clamped disc of triangles, radius 1, neo-Hookean with shear modulus 1 and density 1, without
/// damping: a membrane stretched by 1.2, or a plate of a fifth of the radius in thickness.
struct VibratingDisc {
  structure::Sheet sheet;
  structure::SheetBending bending;  ///< empty: a membrane
  double rest = 0;                  ///< its potential energy at rest
  Mode mode{};                      ///< the slowest
  double period = 0;                ///< of that

  std::vector<structure::Load> loads() const
  {
    return bending.empty() ? std::vector<structure::Load>{}
                           : std::vector{structure::bending_load(bending)};
  }
};

enum class DiscKind { membrane, plate };

inline double potential(VibratingDisc const& d)
{
  return structure::elastic_energy(d.sheet, d.sheet.position) +
         structure::bending_energy(d.bending, d.sheet.position);
}

/// Energy of the motion: kinetic and what the potential has beyond that at rest.
inline double energy(VibratingDisc const& d, Eigen::VectorXd const& mass)
{
  return potential(d) - d.rest + structure::kinetic_energy(d.sheet, mass);
}

/// @param amplitude  how far the middle is moved out in the shape of the slowest mode, over the
///                   radius
inline VibratingDisc vibrating_disc(DiscKind kind, int rings, double amplitude)
{
  auto const mesh = structure::disc_mesh(structure::graded(0, 1, rings));
  double const thickness = kind == DiscKind::plate ? 0.2 : 0.01;
  VibratingDisc d{
      structure::make_sheet(mesh, thickness, structure::neo_hookean_rubber(1), 1), {}, 0, {}, 0};
  for (int p : structure::rim_points(mesh)) structure::clamp(d.sheet, p);
  if (kind == DiscKind::plate)
    d.bending = structure::sheet_bending(d.sheet, structure::Rim::clamped);
  else
    d.sheet.position *= 1.2;
  d.rest = potential(d);
  d.mode = lowest_mode(d.sheet, d.loads());
  d.period = 2 * std::numbers::pi / d.mode.omega;
  d.sheet.position += amplitude * d.mode.shape;
  return d;
}

}  // namespace velum::tests
