#include "cases/app/scene_checks.hpp"

#include "cases/app/derived.hpp"
#include "cases/app/geometry.hpp"
#include "cases/app/scene_words.hpp"
#include "core/check.hpp"
#include "core/spelling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace velum::cases {
namespace {

std::string mm(double metres) { return fmt::format("{:.6g} mm", 1e3 * metres); }

std::string coordinate(int axis) { return axis == 0 ? "first" : axis == 1 ? "second" : "third"; }

std::vector<std::string> solid_names(Scene const& scene)
{
  std::vector<std::string> names;
  for (auto const& s : scene.solids) names.push_back(s.name);
  return names;
}

void check_lattice(Scene const& scene)
{
  auto const& lattice = scene.lattice;
  double cells = 1;
  for (int axis = 0; axis < dimensions(scene); ++axis) {
    double const width = lattice.to[axis] - lattice.from[axis];
    if (width <= 0)
      reject(scene, "lattice.to",
             fmt::format("must be larger than lattice.from in its {} "
                         "coordinate, but {} is not above {}.",
                         coordinate(axis), mm(lattice.to[axis]), mm(lattice.from[axis])));
    if (lattice.dx > 0.25 * width)
      reject(scene, "lattice.dx",
             fmt::format("= {} leaves fewer than 4 cells across the {} coordinate of the domain, "
                         "which is {} wide.",
                         mm(lattice.dx), coordinate(axis), mm(width)));
    cells *= width / lattice.dx;
  }
  if (cells > 2e9)
    reject(scene, "lattice.dx",
           fmt::format("= {} makes {:.3g} cells; at most 2e9 are allowed.", mm(lattice.dx), cells));
  if (symmetry(scene) == core::Symmetry::axisymmetric && lattice.from[1] < 0)
    reject(scene, "lattice.from[1]", "is a radius and must not be negative.");
}

void check_solids(Scene const& scene)
{
  for (auto const& s : scene.solids) {
    std::string const key = "solid." + s.name;
    if (box_side(s.name))
      reject(scene, key, "has the name of a side of the lattice box; choose another one.");
    try {
      solid_distance(scene, s.name);
    } catch (core::InputError const& error) {
      reject(scene, key, fmt::format("cannot be built: {}", error.what()));
    }
  }
}

void check_range(Scene const& scene, Patch const& patch, std::string const& key)
{
  auto const side = box_side(patch.side);
  double const slack = 1e-6 * scene.lattice.dx;
  for (int k = 0; k + 1 < dimensions(scene); ++k) {
    int const axis = side ? axis_along(*side, k) : 1;
    for (auto const& [end, at] : {std::pair{".from", patch.from[k]}, {".to", patch.to[k]}})
      if (at < scene.lattice.from[axis] - slack || at > scene.lattice.to[axis] + slack)
        reject(scene, patch.disc ? key + ".radius" : key + end,
               fmt::format("= {} is outside the domain, which goes from {} to {} "
                           "there.",
                           mm(at), mm(scene.lattice.from[axis]), mm(scene.lattice.to[axis])));
  }
}

void check_patch(Scene const& scene, Patch const& patch, std::string const& key)
{
  auto const side = box_side(patch.side);
  bool const space = dimensions(scene) == 3;
  auto names = side_names(dimensions(scene));
  if (!space) {
    auto const solids = solid_names(scene);
    names.insert(names.end(), solids.begin(), solids.end());
  }
  if (side ? side->axis >= dimensions(scene) : space || !find_solid(scene, patch.side))
    reject_name(scene, key + ".side", patch.side, space ? "side" : "side or solid", names);
  if (patch.side == "y-" && symmetry(scene) == core::Symmetry::axisymmetric &&
      scene.lattice.from[1] == 0)
    reject(scene, key + ".side", "= \"y-\" is the axis of symmetry; nothing can enter there.");
  check_range(scene, patch, key);
  if (!opens_to_fluid(scene, patch))
    reject(scene, key,
           fmt::format("lies on a closed wall: from {} to {} no fluid cell opens to "
                       "\"{}\"; move the patch or the solid.",
                       mm(patch.from[0]), mm(patch.to[0]), patch.side));
}

/// Whether the bounds of two patches overlap; discs are taken for the squares around them.
bool overlap(Patch const& a, Patch const& b, int dimensions)
{
  if (a.side != b.side) return false;
  for (int k = 0; k + 1 < dimensions; ++k)
    if (b.from[k] >= a.to[k] || a.from[k] >= b.to[k]) return false;
  return true;
}

void check_boundaries(Scene const& scene)
{
  std::vector<std::pair<std::string, Patch>> seen;
  for (auto const& boundary : scene.boundaries) {
    bool const top = boundary.name == "inlet" || boundary.name == "outlet";
    std::string const key = top ? boundary.name : "boundary." + boundary.name;
    for (std::size_t k = 0; k < boundary.patches.size(); ++k) {
      auto const& patch = boundary.patches[k];
      std::string const patch_key = fmt::format("{}.patches[{}]", key, k);
      check_patch(scene, patch, patch_key);
      for (auto const& [other_key, other] : seen)
        if (overlap(patch, other, dimensions(scene)))
          reject(scene, patch_key, fmt::format("overlaps {}.", other_key));
      seen.emplace_back(patch_key, patch);
    }
  }
}

/// The rim is held, so it must lie in a solid, or at the edge of the domain, through its whole
/// thickness: what is left open beside it would leak.
void check_rim(Scene const& scene, double y, std::string const& key)
{
  auto const& lattice = scene.lattice;
  auto const& membrane = *scene.membrane;
  double const slack = 1e-3 * lattice.dx;
  if (y <= lattice.from[1] + slack || y >= lattice.to[1] - slack) return;
  auto const walls = all_solids(scene);
  double const half = 0.5 * value_at(membrane.thickness, y);
  double gap = 0;
  for (double const offset : {-half, 0.0, half})
    gap = std::max(gap, core::distance(walls, {membrane.position + offset, y}));
  if (gap > slack)
    reject(
        scene, key,
        fmt::format("= {} puts the {} rim in the open: it must lie in or touch "
                    "a solid, or reach the edge of the domain{}.",
                    mm(y), word(membrane.rim),
                    std::isfinite(gap) ? fmt::format(", but the nearest wall is {} away", mm(gap))
                                       : ", but the scene has no solid"));
}

void check_membrane(Scene const& scene)
{
  auto const& lattice = scene.lattice;
  auto const& membrane = *scene.membrane;
  double const slack = 1e-6 * lattice.dx;
  bool const disc = membrane.shape == MembraneShape::disc;

  check_material(scene, "membrane.material", membrane.material);
  double const half = 0.5 * largest_magnitude(membrane.thickness);
  // under a chamber the lattice only has to reach what its fluid touches
  bool const dry = find_chamber(scene, ChamberSide::above) != nullptr;
  double const top = dry ? membrane.position : membrane.position + half;
  if (membrane.position - half < lattice.from[0] || top > lattice.to[0])
    reject(
        scene, "membrane.position",
        fmt::format("= {} puts the membrane, {} thick, outside the domain, which goes from {} to "
                    "{} there.",
                    mm(membrane.position), mm(2 * half), mm(lattice.from[0]), mm(lattice.to[0])));
  if (disc && lattice.from[1] > 0)
    reject(scene, "membrane.shape",
           fmt::format("= \"disc\" lies outside the domain, which begins "
                       "at the radius {}.",
                       mm(lattice.from[1])));
  if (membrane.from < lattice.from[1] - slack || membrane.to > lattice.to[1] + slack)
    reject(
        scene, disc ? "membrane.radius" : "membrane.to",
        fmt::format("puts the membrane, from {} to {}, outside the domain, which goes from {} to "
                    "{} there.",
                    mm(membrane.from), mm(membrane.to), mm(lattice.from[1]), mm(lattice.to[1])));
  check_rim(scene, membrane.to, disc ? "membrane.radius" : "membrane.to");
  if (!disc) check_rim(scene, membrane.from, "membrane.from");
  if (membrane.stop && !scene.contact)
    reject(scene, "membrane.stop", "needs a [contact] with a seat, whose stiffness it shares.");
  if (membrane.spring &&
      membrane.spring->radius > 0.5 * (membrane.to - membrane.from) * (disc ? 2 : 1))
    reject(scene, "membrane.spring.radius", "must not exceed that of the membrane.");
}

void check_contact(Scene const& scene)
{
  if (!scene.membrane) reject(scene, "contact", "needs a membrane; the scene has none.");
  auto const* seat = find_solid(scene, scene.contact->seat);
  if (!seat) reject_name(scene, "contact.seat", scene.contact->seat, "solid", solid_names(scene));
  if (seat->operation == Operation::subtract)
    reject(scene, "contact.seat", "names a solid that is subtracted; a seat must be added.");
}

}  // namespace

void check_material(Scene const& scene, std::string const& key, std::string const& name)
{
  if (scene.materials.contains(name)) return;
  std::vector<std::string> names;
  for (auto const& [known, material] : scene.materials) names.push_back(known);
  reject_name(scene, key, name, "material", names);
}

void reject_name(Scene const& scene, std::string const& key, std::string const& name,
                 std::string const& kind, std::vector<std::string> const& known)
{
  std::string const near = core::nearest(name, known);
  std::string const hint = !near.empty()   ? fmt::format("did you mean \"{}\"?", near)
                           : known.empty() ? fmt::format("the scene has no {}.", kind)
                                           : fmt::format("allowed: {}.", core::any_of(known));
  reject(scene, key, fmt::format("= \"{}\" names no {} of the scene; {}", name, kind, hint));
}

void check_scene(Scene const& scene)
{
  check_lattice(scene);
  check_solids(scene);
  check_boundaries(scene);
  if (scene.membrane) check_membrane(scene);
  if (scene.contact) check_contact(scene);
  if (scene.fidelity == Fidelity::hydrostatic && !scene.membrane)
    reject(scene, "fidelity", "= \"hydrostatic\" needs a membrane; the scene has none.");
  check_network(scene);
  check_flow(scene);
  check_march(scene);
  if (reference_velocity(scene) == 0 && !scene.lattice.time_step &&
      scene.fidelity != Fidelity::hydrostatic)
    reject(scene, "lattice",
           "needs a time_step, such as \"0.1 us\": nothing in the scene has a "
           "pressure or velocity from which it could be derived.");
}

}  // namespace velum::cases
