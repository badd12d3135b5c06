#include "cases/app/scene_checks.hpp"

#include "cases/app/derived.hpp"
#include "cases/app/geometry.hpp"
#include "cases/app/reference.hpp"
#include "cases/app/scene_words.hpp"
#include "core/spelling.hpp"

#include <fmt/format.h>

#include <algorithm>
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
  return scene.lattice.periodic[static_cast<std::size_t>(axis)];
}

bool any_periodic(Scene const& scene)
{
  auto const& p = scene.lattice.periodic;
  return std::any_of(p.begin(), p.end(), [](bool periodic) { return periodic; });
}

/// The coupled run starts from the hydrostatic state between rigid walls at rest.
void check_membrane_alone(Scene const& scene)
{
  auto const refuse = [&](bool given, std::string const& key) {
    if (given) reject(scene, key, "is for scenes without a membrane; this one has one.");
  };
  refuse(any_periodic(scene), "lattice.periodic");
  refuse(scene.lattice.mirrors != 0, "lattice.symmetry");
  if (scene.lattice.precision == Precision::half)
    reject(scene, "lattice.precision", "= \"half\" is for scenes without a membrane.");
  refuse(core::norm(scene.fluid.body_force) > 0, "fluid.body_force");
  refuse(scene.initial.kind != InitialKind::rest, "initial");
  refuse(!scene.probes.empty(), "probe");
  if (scene.reference && scene.reference->kind != ReferenceKind::figure)
    reject(scene, "reference.kind",
           fmt::format("= \"{}\" is for scenes without a membrane; this one has one and can "
                       "compare a \"figure\" of its summary.",
                       word(scene.reference->kind)));
  refuse(scene.run.steady > 0, "run.steady");
  if (scene.les.model == LesModel::vreman)
    reject(scene, "les.model", "= \"vreman\" is for scenes without a membrane.");
  if (!scene.reference) refuse(!scene.chart.dx.empty(), "chart");
  for (auto const& boundary : scene.boundaries)
    refuse(boundary.kind == BoundaryKind::moving_wall, key_of(boundary) + ".kind");
}

/// A periodic side must hold a whole number of cells, or the period would not be that of the scene.
void check_period(Scene const& scene, double dx, std::string const& key)
{
  for (int axis = 0; axis < dimensions(scene); ++axis) {
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
  if (is_periodic(scene, 1) && symmetry(scene) == core::Symmetry::axisymmetric)
    reject(scene, "lattice.periodic", "cannot hold \"y\", the radius of an axisymmetric scene.");
  check_period(scene, scene.lattice.dx, "lattice.dx");
  for (std::size_t k = 0; k < scene.chart.dx.size(); ++k)
    check_period(scene, scene.chart.dx[k], fmt::format("chart.dx[{}]", k));
  for (auto const& boundary : scene.boundaries)
    for (std::size_t k = 0; k < boundary.patches.size(); ++k)
      if (auto const side = box_side(boundary.patches[k].side);
          side && (is_periodic(scene, side->axis) || is_mirror(scene, *side)))
        reject(scene, fmt::format("{}.patches[{}].side", key_of(boundary), k),
               fmt::format("= \"{}\" is {}; it has no boundary.", boundary.patches[k].side,
                           is_mirror(scene, *side) ? "a plane of symmetry" : "a periodic side"));
}

void check_mirrors(Scene const& scene)
{
  bool const ring = symmetry(scene) == core::Symmetry::axisymmetric;
  for (auto const& name : side_names(dimensions(scene))) {
    auto const side = *box_side(name);
    if (!is_mirror(scene, side)) continue;
    if (is_periodic(scene, side.axis))
      reject(scene, "lattice.symmetry",
             fmt::format("holds \"{}\", a periodic side by lattice.periodic.", name));
    if (ring && side.axis == 1)
      reject(scene, "lattice.symmetry",
             fmt::format("cannot hold \"{}\" in an axisymmetric scene: no plane of symmetry is "
                         "round.",
                         name));
  }
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
               fmt::format("= \"{}\" is a solid; a moving wall lies on a side of the box: {}.",
                           boundary.patches[k].side, core::any_of(side_names(dimensions(scene)))));
      if (dimensions(scene) == 3 && static_cast<int>(boundary.along) == side->axis)
        reject(scene, key_of(boundary) + ".along",
               fmt::format("= \"{}\" points through the wall \"{}\", which can only slide along "
                           "itself.",
                           word(boundary.along), boundary.patches[k].side));
      if (side->axis == 0 && symmetry(scene) == core::Symmetry::axisymmetric)
        reject(scene, key, "would move along the radius; in an axisymmetric scene only y+ slides.");
    }
  }
}

void check_initial(Scene const& scene)
{
  if (scene.initial.kind == InitialKind::rest || scene.initial.kind == InitialKind::uniform) return;
  bool const space = dimensions(scene) == 3;
  for (int axis = 0; axis < dimensions(scene); ++axis)
    if (!is_periodic(scene, axis))
      reject(scene, "initial.kind",
             fmt::format("= \"{}\" needs lattice.periodic = {}.", word(scene.initial.kind),
                         space ? "[\"x\", \"y\", \"z\"]" : "[\"x\", \"y\"]"));
  Vec3 const side = scene.lattice.to - scene.lattice.from;
  if (space && scene.initial.kind == InitialKind::taylor_green &&
      (std::abs(side[1] - side[0]) > 1e-9 * side[0] ||
       std::abs(side[2] - side[0]) > 1e-9 * side[0]))
    reject(scene, "initial.kind", "= \"taylor_green\" needs a cube in space.");
}

std::string readable(Vec3 const& p, int dimensions)
{
  std::string const third = dimensions == 3 ? fmt::format(", {:.6g}", 1e3 * p[2]) : "";
  return fmt::format("({:.6g}, {:.6g}{}) mm", 1e3 * p[0], 1e3 * p[1], third);
}

void check_place(Scene const& scene, Vec3 const& p, std::string const& key)
{
  std::string const place = readable(p, dimensions(scene));
  for (int axis = 0; axis < dimensions(scene); ++axis)
    if (p[axis] < scene.lattice.from[axis] || p[axis] > scene.lattice.to[axis])
      reject(scene, key, fmt::format("= {} is outside the domain.", place));
  if (distance_to_solids(scene)(p) < -0.5 * scene.lattice.dx)
    reject(scene, key, fmt::format("= {} is inside a solid.", place));
}

void check_probes(Scene const& scene)
{
  for (auto const& probe : scene.probes) {
    std::string const key = "probe." + probe.name;
    if (probe.kind == ProbeKind::point || probe.kind == ProbeKind::pressure_difference)
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
  bool const vortices = scene.initial.kind == InitialKind::taylor_green;
  if (kind == ReferenceKind::taylor_green && (!vortices || dimensions(scene) == 3))
    reject(scene, "reference.kind",
           "= \"taylor_green\" needs a plane scene with initial.kind = \"taylor_green\", whose "
           "decay it compares with.");
  bool const pipe = scene.lattice.periodic[0] && scene.fluid.body_force[0] != 0 &&
                    (dimensions(scene) == 3 || (symmetry(scene) == core::Symmetry::axisymmetric &&
                                                scene.lattice.from[1] == 0));
  if (kind == ReferenceKind::pipe && !pipe)
    reject(scene, "reference.kind",
           "= \"pipe\" needs lattice.periodic = [\"x\"], a fluid.body_force along x, and an "
           "axisymmetric scene from the axis on or a 3d one.");
  if (reference.file.empty()) return;
  auto const file = std::filesystem::path(scene.source.file).parent_path() / reference.file;
  if (!std::filesystem::is_regular_file(file))
    reject(scene, "reference.file",
           fmt::format("= \"{}\" is not a file beside the scene.", reference.file));
  if (flow_velocity(scene) == 0)
    reject(scene, "reference.kind",
           fmt::format("= \"{}\" needs a velocity to compare with: of a boundary or of the "
                       "initial flow.",
                       word(kind)));
  load_reference(scene);  // says now what is wrong in the file, not at the end of the run
  if (kind == ReferenceKind::dissipation)
    check_probe_of_reference(scene, "reference.kinetic_energy", reference.energy,
                             ProbeKind::kinetic_energy);
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
  check_mirrors(scene);
  check_moving_walls(scene);
  check_initial(scene);
  check_probes(scene);
  if (scene.reference) check_reference(scene);
}

}  // namespace velum::cases
