#include "cases/app/derived.hpp"

#include "cases/app/chosen_scheme.hpp"
#include "cases/app/geometry.hpp"
#include "contact/penalty.hpp"
#include "core/check.hpp"
#include "structure/line_bending.hpp"
#include "structure/mass.hpp"
#include "structure/stable_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace velum::cases {
namespace {

double largest_pressure(Scene const& scene)
{
  double pressure = 0;
  for (auto const& boundary : scene.boundaries)
    if (imposes_pressure(boundary.kind))
      pressure = std::max(pressure, largest_magnitude(boundary.value));
  return pressure;
}

double area(Scene const& scene, Boundary const& boundary)
{
  double sum = 0;
  for (auto const& patch : boundary.patches) {
    double width = patch.to[0] - patch.from[0];
    if (symmetry(scene) == core::Symmetry::none) width *= patch.to[1] - patch.from[1];
    if (patch.disc) width *= std::numbers::pi / 4;
    auto const side = box_side(patch.side);
    double const radius = side && side->axis == 1
                              ? (side->upper ? scene.lattice.to[1] : scene.lattice.from[1])
                              : 0.5 * (patch.from[0] + patch.to[0]);
    sum += core::ring(symmetry(scene), radius) * width;
  }
  return sum;
}

/// Top of a velocity profile over its mean.
double peak(Scene const& scene, Boundary const& boundary)
{
  if (boundary.profile == VelocityProfile::uniform) return 1;
  bool const space = symmetry(scene) == core::Symmetry::none;
  bool const ring = symmetry(scene) == core::Symmetry::axisymmetric;
  double top = 1.5;
  for (Patch const& patch : boundary.patches)
    top = std::max(top, patch.disc || (ring && patch.from[0] == 0) ? 2.0 : space ? 2.25 : 1.5);
  return top;
}

double velocity_of(Scene const& scene, Boundary const& boundary, double value)
{
  switch (boundary.kind) {
    case BoundaryKind::velocity:
    case BoundaryKind::moving_wall:
      return std::abs(value);
    case BoundaryKind::flow_rate:
      return std::abs(value) / area(scene, boundary);
    default:
      return 0;
  }
}

/// Top of laminar flow under a force along an axis: g h^2/8 nu between plates, g R^2/4 nu in a
/// pipe. In space h is the narrower side of the duct; a square one reaches 1/13.6 of g h^2/nu, and
/// what lies between is joined by 1 + 0.7 (h/w)^2.
double laminar_velocity_along(Scene const& scene, int axis)
{
  auto const& lattice = scene.lattice;
  double narrow = std::numeric_limits<double>::infinity(), wide = narrow;
  for (int across = 0; across < dimensions(scene); ++across) {
    if (across == axis) continue;
    double const width = lattice.to[across] - lattice.from[across];
    wide = std::isfinite(narrow) ? std::max(narrow, width) : wide;
    narrow = std::min(narrow, width);
  }
  bool const pipe =
      axis == 0 && symmetry(scene) == core::Symmetry::axisymmetric && lattice.from[1] == 0;
  double const share = (pipe ? 4 : 8) * (1 + 0.7 * std::pow(narrow / wide, 2));
  return std::abs(scene.fluid.body_force[axis]) * narrow * narrow / (share * scene.fluid.viscosity);
}

double largest_slope(Curve const& curve)
{
  double slope = 0;
  for (std::size_t k = 1; k < curve.at.size(); ++k)
    slope = std::max(
        slope, std::abs((curve.value[k] - curve.value[k - 1]) / (curve.at[k] - curve.at[k - 1])));
  return slope;
}

int cells_across(Lattice const& lattice, int axis)
{
  return static_cast<int>(std::ceil((lattice.to[axis] - lattice.from[axis]) / lattice.dx - 1e-6));
}

double smallest_thickness(MembraneSheet const& membrane)
{
  double least = std::min(value_at(membrane.thickness, membrane.from),
                          value_at(membrane.thickness, membrane.to));
  for (std::size_t k = 0; k < membrane.thickness.at.size(); ++k)
    if (membrane.thickness.at[k] > membrane.from && membrane.thickness.at[k] < membrane.to)
      least = std::min(least, membrane.thickness.value[k]);
  return least;
}

std::optional<structure::TimeScheme> asked_scheme(Scene const& scene)
{
  switch (scene.coupling.membrane) {
    case MembraneScheme::explicit_:
      return structure::TimeScheme::explicit_substeps;
    case MembraneScheme::implicit:
      return structure::TimeScheme::implicit;
    case MembraneScheme::auto_:
      return {};
  }
  return {};
}

/// Square of the angular frequency of the lightest part of the membrane on the seat's penalty.
double contact_frequency2(Scene const& scene, Derived const& d)
{
  if (!scene.contact) return 0;
  double const areal_mass = scene.materials.at(scene.membrane->material).density * d.thickness;
  double const k =
      scene.contact->stiffness.value_or(contact::stable_stiffness(areal_mass, d.units.dt));
  return k / areal_mass;
}

void derive_membrane(Scene const& scene, Derived& d)
{
  auto const& sheet = *scene.membrane;
  auto const& material = scene.materials.at(sheet.material);
  d.thickness = smallest_thickness(sheet);
  d.mass_ratio = material.density * d.thickness / (scene.fluid.density * scene.lattice.dx);
  auto const membrane = make_membrane(scene);
  d.structure_step = structure::stable_step(membrane, structure::lumped_mass(membrane),
                                            membrane.reference, bending_of(sheet, membrane));
  d.sub_steps = structure::substeps_for(d.units.dt, d.structure_step);
  double const closed =
      1 / std::sqrt(1 / (d.structure_step * d.structure_step) + contact_frequency2(scene, d) / 4);
  d.membrane_scheme = chosen_scheme(asked_scheme(scene), 1e6 * d.units.dt, 1e6 * closed,
                                    structure::coupled_cost_ratio(membrane), "us");
  // The undamped limit is 2 / omega, so omega^2 = 4 / step^2.
  if (material.damping_stiffness > 0)
    d.damping_step = d.structure_step * d.structure_step / (2 * material.damping_stiffness);
}

}  // namespace

double opening_area(Scene const& scene, std::string const& boundary)
{
  return area(scene, *find_boundary(scene, boundary));
}

double reference_velocity(Scene const& scene)
{
  double velocity = std::sqrt(2 * largest_pressure(scene) / scene.fluid.density);
  for (auto const& boundary : scene.boundaries)
    velocity =
        std::max(velocity, peak(scene, boundary) *
                               velocity_of(scene, boundary, largest_magnitude(boundary.value)));
  velocity = std::max(velocity, scene.initial.velocity);
  for (int axis = 0; axis < dimensions(scene); ++axis)
    velocity = std::max(velocity, laminar_velocity_along(scene, axis));
  if (scene.membrane && scene.membrane->centre)
    velocity = std::max(velocity, largest_slope(scene.membrane->centre->displacement));
  return velocity;
}

double flow_velocity(Scene const& scene)
{
  double velocity = scene.initial.velocity;
  for (auto const& boundary : scene.boundaries)
    velocity =
        std::max(velocity, velocity_of(scene, boundary, value_at(boundary.value, scene.run.end)));
  return velocity;
}

structure::Membrane make_membrane(MembraneSheet const& sheet, Material const& material,
                                  core::Symmetry symmetry)
{
  return structure::flat_membrane(
      {.symmetry = symmetry,
       .from = sheet.from,
       .to = sheet.to,
       .element_size = sheet.element,
       .thickness = [thickness = sheet.thickness](double y) { return value_at(thickness, y); },
       .material = material.rubber,
       .density = material.density,
       .axial = sheet.position});
}

structure::Membrane make_membrane(Scene const& scene)
{
  auto const& sheet = *scene.membrane;
  return make_membrane(sheet, scene.materials.at(sheet.material), symmetry(scene));
}

std::vector<structure::Load> bending_of(MembraneSheet const& sheet,
                                        structure::Membrane const& membrane)
{
  if (!has_bending(sheet)) return {};
  return {structure::bending_load(std::make_shared<structure::LineBending const>(
      structure::line_bending(membrane, sheet.rim)))};
}

Derived derive(Scene const& scene)
{
  auto const& lattice = scene.lattice;
  auto const& fluid = scene.fluid;
  Derived d{};
  d.pressure = largest_pressure(scene);
  d.velocity = reference_velocity(scene);
  if (d.velocity == 0 && !lattice.time_step) d.velocity = std::sqrt(2 * 1e3 / fluid.density);

  double const lattice_velocity = lattice.mach / std::numbers::sqrt3;
  double const dt = lattice.time_step.value_or(lattice_velocity * lattice.dx / d.velocity);
  d.units = {.dx = lattice.dx, .dt = dt, .rho = fluid.density};
  d.grid = {.nx = cells_across(lattice, 0),
            .ny = cells_across(lattice, 1),
            .dx = lattice.dx,
            .origin = lattice.from + lattice.shift,
            .symmetry = symmetry(scene),
            .nz = dimensions(scene) == 3 ? cells_across(lattice, 2) : 1};
  d.sound_speed = lattice.dx / (dt * std::numbers::sqrt3);
  d.mach = d.velocity / d.sound_speed;
  d.viscosity = core::to_lattice_kinematic_viscosity(d.units, fluid.viscosity);
  d.tau_minus_half = 3 * d.viscosity;
  d.cell_reynolds = d.velocity * lattice.dx / fluid.viscosity;
  d.density_jump = d.pressure / (fluid.density * d.sound_speed * d.sound_speed);
  d.acoustic_transit = std::max({d.grid.nx, d.grid.ny, d.grid.nz}) * lattice.dx / d.sound_speed;
  d.steps = static_cast<std::int64_t>(std::ceil(scene.run.end / dt - 1e-9));
  if (scene.membrane) derive_membrane(scene, d);
  return d;
}

void check_time_step(Scene const& scene, Derived const& d)
{
  double const dt = d.units.dt, end = scene.run.end;
  if (end > 0 && end < dt / 2)
    throw core::InputError(
        fmt::format("{}: run.end = {:.3g} s does not hold one time step, which is {:.3g} s.",
                    scene.source.file, end, dt));
  if (d.mach >= 1)
    throw core::InputError(fmt::format(
        "{}: with lattice.time_step = {:.3g} s a velocity of {:.3g} m/s is Mach {:.3g}; it must be "
        "below 1: lattice.time_step < \"{:.3g} us\".",
        scene.source.file, dt, d.velocity, d.mach, 1e6 * dt / d.mach));
}

}  // namespace velum::cases
