#include "cases/app/scene.hpp"

#include "cases/app/open_scene.hpp"
#include "cases/app/scene_checks.hpp"
#include "cases/app/scene_sections.hpp"
#include "core/check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace velum::cases {
namespace {

/// The symmetry has to be known before the sections whose units depend on it.
core::Symmetry symmetry_of(Fidelity fidelity, SceneTable& root)
{
  if (fidelity == Fidelity::planar) return core::Symmetry::planar;
  if (fidelity == Fidelity::space) return core::Symmetry::none;
  if (fidelity == Fidelity::axisymmetric || !root.has("membrane"))
    return core::Symmetry::axisymmetric;
  auto const shape = root.table("membrane").choice<MembraneShape>("shape", MembraneShape::disc);
  return shape == MembraneShape::disc ? core::Symmetry::axisymmetric : core::Symmetry::planar;
}

Scene compose(SceneTable root)
{
  root.allow({"name",    "fidelity", "lattice",   "fluid",    "les",      "solid",
              "inlet",   "outlet",   "boundary",  "material", "membrane", "contact",
              "gap",     "chamber",  "orifice",   "coupling", "run",      "start",
              "initial", "probe",    "reference", "chart"});
  std::string name = root.text("name");
  if (name.find_first_of("/\\") != std::string::npos || name.starts_with('.'))
    root.fail("name", "is used as the name of the results folder: no slashes, no dot in front.");
  auto const fidelity = root.choice<Fidelity>("fidelity");
  if (fidelity == Fidelity::structure)
    root.fail("fidelity", "= \"structure\" is a body without fluid, which has no place here.");
  auto const symmetry_of_scene = symmetry_of(fidelity, root);
  root.set_dimensions(core::dimensions(symmetry_of_scene));
  if (root.has("membrane") && fidelity == Fidelity::space)
    root.fail("membrane", "is for planar and axisymmetric scenes; in space velum has none yet.");

  Scene scene{.name = std::move(name),
              .fidelity = fidelity,
              .lattice = read_lattice(root.table("lattice")),
              .fluid = read_fluid(root.table("fluid")),
              .les = root.has("les") ? read_les(root.table("les")) : Les{},
              .coupling = root.has("coupling") ? read_coupling(root.table("coupling")) : Coupling{},
              .run = read_schedule(root.table("run"))};
  if (root.has("solid"))
    for (auto const& [key, table] : root.table("solid").tables())
      scene.solids.push_back(read_solid(table, key));
  for (std::string const key : {"inlet", "outlet"})
    if (root.has(key))
      scene.boundaries.push_back(
          read_boundary(root.table(key), key, symmetry_of_scene, scene.lattice));
  if (root.has("boundary"))
    for (auto const& [key, table] : root.table("boundary").tables()) {
      if (key == "inlet" || key == "outlet")
        table.fail("kind", fmt::format("belongs to a boundary whose table is simply [{}].", key));
      scene.boundaries.push_back(read_boundary(table, key, symmetry_of_scene, scene.lattice));
    }
  if (root.has("material"))
    for (auto const& [key, table] : root.table("material").tables())
      scene.materials.emplace(key, read_material(table));
  if (root.has("membrane"))
    scene.membrane = read_membrane(root.table("membrane"), symmetry_of_scene, scene.lattice.dx);
  if (root.has("contact")) scene.contact = read_contact(root.table("contact"));
  if (root.has("gap")) scene.gap = read_gap(root.table("gap"));
  if (root.has("chamber"))
    for (auto const& [key, table] : root.table("chamber").tables())
      scene.chambers.push_back(read_chamber(table, key));
  if (root.has("orifice"))
    for (auto const& [key, table] : root.table("orifice").tables())
      scene.orifices.push_back(read_orifice(table, key));
  if (root.has("start")) scene.start = read_start(root.table("start"));
  if (root.has("initial")) scene.initial = read_initial(root.table("initial"));
  if (root.has("probe"))
    for (auto const& [key, table] : root.table("probe").tables())
      scene.probes.push_back(read_probe(table, key));
  if (root.has("reference")) scene.reference = read_reference(root.table("reference"));
  if (root.has("chart")) scene.chart = read_sweep(root.table("chart"));
  return scene;
}

}  // namespace

Scene read_scene(std::filesystem::path const& file, std::vector<std::string> const& overrides)
{
  OpenScene open(file, overrides);
  Scene scene = compose(open.root());
  scene.source = open.close();
  check_scene(scene);
  return scene;
}

void reject(SceneFile const& source, std::string const& key, std::string const& what)
{
  // A part of an array or a default has the place of what contains it.
  std::string place = source.file;
  std::string outer = key;
  while (!outer.empty()) {
    if (auto const found = source.places.find(outer); found != source.places.end()) {
      place = found->second;
      break;
    }
    auto const cut = outer.find_last_of(".[");
    outer.resize(cut == std::string::npos ? 0 : cut);
  }
  throw core::InputError(fmt::format("{}: {} {}", place, key, what));
}

core::Symmetry symmetry(Scene const& scene)
{
  if (scene.fidelity == Fidelity::space) return core::Symmetry::none;
  bool const planar =
      scene.fidelity == Fidelity::planar ||
      ((scene.fidelity == Fidelity::hydrostatic || scene.fidelity == Fidelity::lumped) &&
       scene.membrane && scene.membrane->shape == MembraneShape::strip);
  return planar ? core::Symmetry::planar : core::Symmetry::axisymmetric;
}

int dimensions(Scene const& scene) { return core::dimensions(symmetry(scene)); }

Boundary const* find_boundary(Scene const& scene, std::string const& name)
{
  auto const found = std::find_if(scene.boundaries.begin(), scene.boundaries.end(),
                                  [&](Boundary const& b) { return b.name == name; });
  return found == scene.boundaries.end() ? nullptr : &*found;
}

Probe const* find_probe(Scene const& scene, std::string const& name)
{
  auto const found = std::find_if(scene.probes.begin(), scene.probes.end(),
                                  [&](Probe const& p) { return p.name == name; });
  return found == scene.probes.end() ? nullptr : &*found;
}

ChamberSection const* find_chamber(Scene const& scene, ChamberSide side)
{
  auto const found = std::find_if(scene.chambers.begin(), scene.chambers.end(),
                                  [&](ChamberSection const& c) { return c.side == side; });
  return found == scene.chambers.end() ? nullptr : &*found;
}

Solid const* find_solid(Scene const& scene, std::string const& name)
{
  auto const found = std::find_if(scene.solids.begin(), scene.solids.end(),
                                  [&](Solid const& s) { return s.name == name; });
  return found == scene.solids.end() ? nullptr : &*found;
}

}  // namespace velum::cases
