#include <fmt/format.h>

#include <algorithm>

#include "cases/app/geometry.hpp"
#include "cases/app/scene_checks.hpp"

namespace velum::cases {
namespace {

/// What an orifice may join.
std::vector<std::string> nodes(Scene const& scene)
{
  std::vector<std::string> names;
  for (auto const& c : scene.chambers) names.push_back(c.name);
  for (auto const& b : scene.boundaries)
    if (imposes_pressure(b.kind) || b.kind == BoundaryKind::port) names.push_back(b.name);
  return names;
}

void check_chambers(Scene const& scene)
{
  int above = 0;
  for (auto const& c : scene.chambers) {
    std::string const key = "chamber." + c.name;
    if (find_boundary(scene, c.name))
      reject(scene, key, "has the name of a boundary; choose another one.");
    if (c.side == ChamberSide::none) continue;
    if (++above > 1) reject(scene, key + ".side", "= \"above\" is taken by another chamber.");
    if (scene.coupling.method == CouplingMethod::diffuse)
      reject(scene, key + ".side",
             "= \"above\" needs coupling.method = \"sharp\": a diffuse membrane has fluid on both "
             "sides.");
    for (auto const& b : scene.boundaries)
      for (std::size_t k = 0; k < b.patches.size(); ++k)
        if (b.patches[k].side == "x+")
          reject(scene,
                 fmt::format("{}{}.patches[{}]",
                             b.name == "inlet" || b.name == "outlet" ? "" : "boundary.", b.name, k),
                 fmt::format("is on the side \"x+\", above the membrane, where chamber \"{}\" is "
                             "and no fluid of the lattice; join it by an orifice.",
                             c.name));
  }
}

void check_orifice(Scene const& scene, OrificeSection const& o)
{
  std::string const key = "orifice." + o.name;
  auto const known = nodes(scene);
  for (auto const& [end, name] : {std::pair{".from", o.from}, {".to", o.to}})
    if (std::find(known.begin(), known.end(), name) == known.end())
      reject_name(scene, key + end, name, "chamber, boundary with a pressure, or port", known);
  if (o.from == o.to) reject(scene, key + ".to", "must be another place than \"from\".");
  if (o.member) check_material(scene, key + ".membrane.material", o.member->material);
}

void check_ports(Scene const& scene)
{
  for (auto const& b : scene.boundaries) {
    if (b.kind != BoundaryKind::port) continue;
    if (std::none_of(scene.orifices.begin(), scene.orifices.end(),
                     [&](OrificeSection const& o) { return o.from == b.name || o.to == b.name; }))
      reject(scene, "boundary." + b.name + ".kind",
             "= \"port\" takes its flow from orifices, but none begins or ends there.");
  }
}

}  // namespace

void check_network(Scene const& scene)
{
  if (scene.fidelity == Fidelity::lumped)
    for (auto const& [present, name] : {std::pair{scene.membrane.has_value(), "a membrane"},
                                        {scene.contact.has_value(), "a contact"},
                                        {find_boundary(scene, "inlet") != nullptr, "an inlet"},
                                        {find_boundary(scene, "outlet") != nullptr, "an outlet"}})
      if (!present)
        reject(scene, "fidelity", fmt::format("= \"lumped\" needs {}; the scene has none.", name));
  if (scene.gap.cells > 0 && !scene.contact)
    reject(scene, "gap", "closes the gap of a seat; the scene has no contact.");
  if (scene.gap.cells > 0 && scene.coupling.method == CouplingMethod::diffuse)
    reject(scene, "gap", "needs coupling.method = \"sharp\".");
  check_ports(scene);
  if (scene.chambers.empty() && scene.orifices.empty()) return;
  std::string const first = scene.chambers.empty() ? "orifice" : "chamber";
  if (!scene.membrane || symmetry(scene) != core::Symmetry::axisymmetric)
    reject(scene, first, "is for axisymmetric scenes with a membrane.");
  if (scene.chambers.empty()) reject(scene, "orifice", "needs a chamber to fill or empty.");
  check_chambers(scene);
  for (auto const& o : scene.orifices) check_orifice(scene, o);
}

}  // namespace velum::cases
