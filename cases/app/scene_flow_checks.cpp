#include "cases/app/scene_checks.hpp"

#include "cases/app/derived.hpp"
#include "cases/app/geometry.hpp"
#include "cases/app/reference.hpp"
#include "cases/app/scene_words.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

namespace velum::cases {
namespace {

std::string key_of(Boundary const& boundary)
{
  bool const top = boundary.name == "inlet" || boundary.name == "outlet";
  return top ? boundary.name : "boundary." + boundary.name;
}

bool is_periodic(Scene const& scene, int axis)
{
  return axis == 0 ? scene.lattice.periodic_x : scene.lattice.periodic_y;
}

/// The coupled run starts from the hydrostatic state between rigid walls at rest.
void check_membrane_alone(Scene const& scene)
{
  auto const refuse = [&](bool given, std::string const& key) {
    if (given) reject(scene, key, "is for scenes without a membrane; this one has one.");
  };
  refuse(scene.lattice.periodic_x || scene.lattice.periodic_y, "lattice.periodic");
  refuse(scene.fluid.body_force[0] != 0 || scene.fluid.body_force[1] != 0, "fluid.body_force");
  refuse(scene.initial.kind != InitialKind::rest, "initial");
  refuse(!scene.probes.empty(), "probe");
  refuse(scene.reference.has_value(), "reference");
  refuse(scene.run.steady > 0, "run.steady");
  refuse(!scene.chart.dx.empty(), "chart");
  for (auto const& boundary : scene.boundaries)
    refuse(boundary.kind == BoundaryKind::moving_wall, key_of(boundary) + ".kind");
}

/// A periodic side must hold a whole number of cells, or the period would not be that of the scene.
void check_period(Scene const& scene, double dx, std::string const& key)
{
  for (int axis = 0; axis < 2; ++axis) {
    double const cells = (scene.lattice.to[axis] - scene.lattice.from[axis]) / dx;
    if (!is_periodic(scene, axis) || std::abs(cells - std::round(cells)) < 1e-6) continue;
    reject(scene, key,
           fmt::format("= {:.6g} mm does not divide the periodic side of {:.6g} mm; \"{:.6g} mm\" "
                       "would.",
                       1e3 * dx, 1e3 * cells * dx, 1e3 * cells * dx / std::ceil(cells)));
  }
}

void check_periodic(Scene const& scene)
{
  if (scene.lattice.periodic_y && symmetry(scene) == core::Symmetry::axisymmetric)
    reject(scene, "lattice.periodic", "cannot hold \"y\", the radius of an axisymmetric scene.");
  check_period(scene, scene.lattice.dx, "lattice.dx");
  for (std::size_t k = 0; k < scene.chart.dx.size(); ++k)
    check_period(scene, scene.chart.dx[k], fmt::format("chart.dx[{}]", k));
  for (auto const& boundary : scene.boundaries)
    for (std::size_t k = 0; k < boundary.patches.size(); ++k)
      if (auto const side = box_side(boundary.patches[k].side);
          side && is_periodic(scene, side->axis))
        reject(scene, fmt::format("{}.patches[{}].side", key_of(boundary), k),
               fmt::format("= \"{}\" is a periodic side; it has no boundary.",
                           boundary.patches[k].side));
}

void check_moving_walls(Scene const& scene)
{
  for (auto const& boundary : scene.boundaries) {
    if (boundary.kind != BoundaryKind::moving_wall) continue;
    for (std::size_t k = 0; k < boundary.patches.size(); ++k) {
      auto const side = box_side(boundary.patches[k].side);
      std::string const key = fmt::format("{}.patches[{}].side", key_of(boundary), k);
      if (!side)
        reject(scene, key,
               fmt::format("= \"{}\" is a solid; a moving wall lies on a side of the box: x-, x+, "
                           "y- or y+.",
                           boundary.patches[k].side));
      if (side->axis == 0 && symmetry(scene) == core::Symmetry::axisymmetric)
        reject(scene, key, "would move along the radius; in an axisymmetric scene only y+ slides.");
    }
  }
}

void check_initial(Scene const& scene)
{
  if (scene.initial.kind == InitialKind::rest) return;
  if (!scene.lattice.periodic_x || !scene.lattice.periodic_y)
    reject(
        scene, "initial.kind",
        fmt::format("= \"{}\" needs lattice.periodic = [\"x\", \"y\"].", word(scene.initial.kind)));
}

void check_place(Scene const& scene, Vec2 const& p, std::string const& key)
{
  for (int axis = 0; axis < 2; ++axis)
    if (p[axis] < scene.lattice.from[axis] || p[axis] > scene.lattice.to[axis])
      reject(scene, key,
             fmt::format("= ({:.6g}, {:.6g}) mm is outside the domain.", 1e3 * p[0], 1e3 * p[1]));
  if (core::distance(all_solids(scene), p) < -0.5 * scene.lattice.dx)
    reject(scene, key,
           fmt::format("= ({:.6g}, {:.6g}) mm is inside a solid.", 1e3 * p[0], 1e3 * p[1]));
}

void check_probes(Scene const& scene)
{
  for (auto const& probe : scene.probes) {
    std::string const key = "probe." + probe.name;
    if (probe.kind != ProbeKind::force)
      check_place(scene, probe.from, key + (probe.kind == ProbeKind::point ? ".at" : ".from"));
    if (probe.kind == ProbeKind::pressure_difference) check_place(scene, probe.to, key + ".to");
    if (probe.kind != ProbeKind::force || find_solid(scene, probe.solid)) continue;
    std::vector<std::string> names;
    for (auto const& s : scene.solids) names.push_back(s.name);
    reject_name(scene, key + ".solid", probe.solid, "solid", names);
  }
}

void check_probe_of_reference(Scene const& scene, std::string const& key, std::string const& name,
                              ProbeKind kind)
{
  auto const* probe = find_probe(scene, name);
  if (probe && probe->kind == kind) return;
  std::vector<std::string> names;
  for (auto const& p : scene.probes)
    if (p.kind == kind) names.push_back(p.name);
  reject_name(scene, key, name, fmt::format("probe with kind = \"{}\"", word(kind)), names);
}

void check_reference(Scene const& scene)
{
  auto const& reference = *scene.reference;
  auto const kind = reference.kind;
  if (kind == ReferenceKind::taylor_green && scene.initial.kind != InitialKind::taylor_green)
    reject(scene, "reference.kind",
           "= \"taylor_green\" needs initial.kind = \"taylor_green\", whose decay it compares "
           "with.");
  if (kind == ReferenceKind::pipe &&
      !(symmetry(scene) == core::Symmetry::axisymmetric && scene.lattice.periodic_x &&
        scene.lattice.from[1] == 0 && scene.fluid.body_force[0] != 0))
    reject(
        scene, "reference.kind",
        "= \"pipe\" needs an axisymmetric scene from the axis on, lattice.periodic = [\"x\"] and "
        "a fluid.body_force along x.");
  if (reference.file.empty()) return;
  auto const file = std::filesystem::path(scene.file).parent_path() / reference.file;
  if (!std::filesystem::is_regular_file(file))
    reject(scene, "reference.file",
           fmt::format("= \"{}\" is not a file beside the scene.", reference.file));
  if (flow_velocity(scene) == 0)
    reject(scene, "reference.kind",
           fmt::format("= \"{}\" needs a velocity to compare with: of a boundary or of the "
                       "initial flow.",
                       word(kind)));
  load_reference(scene);  // says now what is wrong in the file, not at the end of the run
  if (kind != ReferenceKind::body) return;
  check_probe_of_reference(scene, "reference.force", reference.force, ProbeKind::force);
  if (!reference.difference.empty())
    check_probe_of_reference(scene, "reference.pressure_difference", reference.difference,
                             ProbeKind::pressure_difference);
}

}  // namespace

void check_flow(Scene const& scene)
{
  if (scene.membrane) return check_membrane_alone(scene);
  check_periodic(scene);
  check_moving_walls(scene);
  check_initial(scene);
  check_probes(scene);
  if (scene.reference) check_reference(scene);
}

}  // namespace velum::cases
