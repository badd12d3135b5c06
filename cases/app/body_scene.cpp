#include "cases/app/body_scene.hpp"

#include "cases/app/body_words.hpp"
#include "cases/app/geometry.hpp"
#include "cases/app/open_scene.hpp"
#include "cases/app/overrides.hpp"
#include "cases/app/scene_base.hpp"
#include "cases/app/scene_sections.hpp"
#include "cases/app/scene_text.hpp"
#include "core/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace velum::cases {
namespace {

using core::Dimension;

/// Keys that a shape takes beside those that all take.
std::vector<std::string> keys_of(BodyShape shape, Elements elements)
{
  switch (shape) {
    case BodyShape::disc:
      return {"radius"};
    case BodyShape::annulus:
      return {"inner_radius", "radius"};
    case BodyShape::tube:
      return {"radius", "length"};
    case BodyShape::mesh:
      return {"file", "unit", "clamp"};
    case BodyShape::strip:
      break;
  }
  return elements == Elements::lines ? std::vector<std::string>{"from", "to"}
                                     : std::vector<std::string>{"from", "to", "length"};
}

/// Keys that every shape takes; one from a file is where it is and has its elements.
std::vector<std::string> common_keys(BodyShape shape)
{
  std::vector<std::string> keys{"elements", "shape", "material", "thickness", "rim", "bending"};
  if (shape != BodyShape::mesh) keys.insert(keys.end(), {"position", "element"});
  return keys;
}

void read_mesh(SceneTable& table, SoftBody& body)
{
  body.file = table.file_name("file");
  double const unit = table.quantity("unit", Dimension::length, Sign::positive);
  body.mesh = structure::read_gmsh(table.beside(body.file), unit);
  if (!table.has("clamp")) return;
  std::vector<std::string> names;
  for (auto const& [name, points] : body.mesh.groups) names.push_back(name);
  if (names.empty())
    table.fail("clamp", fmt::format("names groups, and \"{}\" has none: give its curves a Physical "
                                    "name in Gmsh.",
                                    body.file));
  body.clamps = table.texts("clamp", names);
}

void read_size(SceneTable& table, SoftBody& body)
{
  body.position = table.quantity("position", Dimension::length, Sign::any, 0.0);
  body.element = table.quantity("element", Dimension::length, Sign::positive);
  auto const positive = [&](char const* key) {
    return table.quantity(key, Dimension::length, Sign::positive);
  };
  if (body.shape == BodyShape::strip) {
    body.inner = table.quantity("from", Dimension::length);
    body.outer = table.quantity("to", Dimension::length);
    if (body.inner >= body.outer) table.fail("to", "must be larger than \"from\".");
  } else {
    body.outer = positive("radius");
  }
  if (body.shape == BodyShape::annulus) {
    body.inner = positive("inner_radius");
    if (body.inner >= body.outer) table.fail("inner_radius", "must be smaller than \"radius\".");
  }
  auto const own = keys_of(body.shape, body.elements);
  if (std::ranges::find(own, "length") != own.end()) body.length = positive("length");
  if (body.element > 0.5 * (body.outer - body.inner))
    table.fail("element", "must be at most half of what the body spans.");
}

SoftBody read_body(SceneTable table)
{
  std::vector<std::string> all = common_keys(BodyShape::disc);
  for (char const* key :
       {"radius", "length", "inner_radius", "from", "to", "file", "unit", "clamp"})
    all.push_back(key);
  table.allow(all);
  SoftBody body{
      .elements = table.choice<Elements>("elements"),
      .shape = table.choice<BodyShape>("shape"),
      .material = table.text("material"),
      .outer = 0,
      .thickness = table.curve("thickness", Dimension::length, Dimension::length, Sign::positive),
      .rim = table.choice<Rim>("rim", Rim::clamped),
      .bending = table.choice<Bending>("bending", Bending::auto_)};
  if (body.elements == Elements::lines && body.shape != BodyShape::disc &&
      body.shape != BodyShape::strip)
    table.fail("shape", fmt::format("cannot be \"{}\" with lines; \"disc\" and \"strip\" can.",
                                    word(body.shape)));
  auto keys = common_keys(body.shape);
  auto const own = keys_of(body.shape, body.elements);
  keys.insert(keys.end(), own.begin(), own.end());
  table.allow(keys,
              fmt::format(" with shape = \"{}\" of {}", word(body.shape), word(body.elements)));
  if (body.shape == BodyShape::mesh)
    read_mesh(table, body);
  else
    read_size(table, body);
  return body;
}

BodyLoad read_load(SceneTable table)
{
  table.allow({"pressures", "side", "volumes"});
  BodyLoad load;
  load.pressures = table.quantities("pressures", Dimension::pressure);
  load.side = table.choice<Side>("side", Side::minus);
  if (table.has("volumes")) load.volumes = table.quantities("volumes", Dimension::volume);
  if (!std::ranges::is_sorted(load.volumes, std::less_equal<>()))
    table.fail("volumes", "must ascend: each state starts from the one before.");
  return load;
}

BodyMarch read_march(SceneTable table)
{
  table.allow({"pressure", "side", "end", "step", "scheme"});
  BodyMarch march{
      .pressure = table.curve("pressure", Dimension::time, Dimension::pressure, Sign::not_negative),
      .end = table.quantity("end", Dimension::time, Sign::positive),
      .step = table.quantity("step", Dimension::time, Sign::positive)};
  if (march.step > march.end) table.fail("step", "must not be longer than \"end\".");
  if (table.has("scheme")) march.scheme = table.choice<structure::TimeScheme>("scheme");
  return march;
}

BodyReference read_body_reference(SceneTable table)
{
  table.allow({"file", "scale", "limit_load", "frequencies"});
  BodyReference reference{.file = table.file_name("file"),
                          .scale = table.choice<LoadScale>("scale")};
  if (table.has("limit_load")) reference.limit_load = table.number("limit_load", 0);
  if (table.has("frequencies")) reference.frequencies = table.numbers("frequencies");
  return reference;
}

BodyScene compose(SceneTable root)
{
  root.allow({"name", "fidelity", "body", "material", "solid", "contact", "load", "march", "modes",
              "reference"});
  BodyScene scene{.name = root.text("name"), .body = read_body(root.table("body"))};
  if (scene.name.find_first_of("/\\") != std::string::npos || scene.name.starts_with('.'))
    root.fail("name", "is used as the name of the results folder: no slashes, no dot in front.");
  root.choice<Fidelity>("fidelity");
  root.set_dimensions(scene.body.elements == Elements::triangles ? 3 : 2);
  for (auto const& [key, table] : root.table("material").tables())
    scene.materials.emplace(key, read_material(table));
  if (!scene.materials.contains(scene.body.material)) {
    std::vector<std::string> names;
    for (auto const& [name, unused] : scene.materials) names.push_back(name);
    root.table("body").fail(
        "material", fmt::format("= \"{}\" is not a material of the scene{}", scene.body.material,
                                did_you_mean(scene.body.material, names)));
  }
  if (root.has("solid"))
    for (auto const& [key, table] : root.table("solid").tables())
      scene.solids.push_back(read_solid(table, key));
  if (root.has("contact")) {
    scene.contact = read_contact(root.table("contact"));
    if (std::ranges::none_of(scene.solids,
                             [&](Solid const& s) { return s.name == scene.contact->seat; }))
      root.table("contact").fail(
          "seat", fmt::format("= \"{}\" is not a solid of the scene.", scene.contact->seat));
  }
  if (root.has("march")) {
    if (root.has("load"))
      root.fail("march", "and \"load\" both say what presses on the body; keep one.");
    scene.march = read_march(root.table("march"));
    scene.load.side = root.table("march").choice<Side>("side", Side::minus);
  } else {
    scene.load = read_load(root.table("load"));
  }
  if (root.has("modes")) {
    double const modes = root.number("modes", 0);
    if (modes != std::floor(modes) || modes > 100)
      root.fail("modes", "must be a whole number up to 100: how many vibrations to find.");
    scene.modes = int(modes);
  }
  if (root.has("reference")) scene.reference = read_body_reference(root.table("reference"));
  return scene;
}

void check(BodyScene const& scene)
{
  for (auto const& solid : scene.solids) try {
      if (scene.body.elements == Elements::triangles)
        placed_in_space(solid);
      else
        placed(solid);
    } catch (core::InputError const& error) {
      reject(scene.source, "solid." + solid.name, fmt::format("cannot be built: {}", error.what()));
    }
  if (scene.march && scene.contact && scene.contact->method != ContactMethod::penalty)
    reject(scene.source, "contact.method",
           fmt::format("= \"{}\" is for states in equilibrium; a march takes \"{}\".",
                       word(scene.contact->method), word(ContactMethod::penalty)));
  if (scene.march && scene.reference && scene.reference->limit_load)
    reject(scene.source, "reference.limit_load", "is for states in equilibrium, not for a march.");
  if (!scene.load.volumes.empty()) {
    if (scene.contact)
      reject(scene.source, "load.volumes",
             "is for a body without contact: what lies on a seat encloses no single volume.");
    if (has_bending(scene.body))
      reject(scene.source, "load.volumes",
             "is for membranes: past the limit point velum knows no bending; say body.bending = "
             "\"off\".");
    if (scene.load.side == Side::plus)
      reject(scene.source, "load.volumes", "is enclosed below: load.side must be \"minus\".");
  }
  if (scene.modes > 0 && !has_bending(scene.body))
    reject(scene.source, "modes",
           "of a flat body without bending do not exist: nothing resists; say body.bending = "
           "\"on\".");
  if (scene.reference && !scene.reference->frequencies.empty() &&
      scene.modes < int(scene.reference->frequencies.size()))
    reject(scene.source, "reference.frequencies", "has more entries than \"modes\" asks for.");
}

}  // namespace

bool is_body_scene(std::filesystem::path const& file, std::vector<std::string> const& overrides)
{
  auto table = read_tables(file);
  for (auto const& text : overrides) apply_override(table, text);
  return table["fidelity"].value<std::string>() == word(Fidelity::structure);
}

BodyScene read_body_scene(std::filesystem::path const& file,
                          std::vector<std::string> const& overrides)
{
  OpenScene open(file, overrides);
  BodyScene scene = compose(open.root());
  scene.source = open.close();
  check(scene);
  return scene;
}

double span(SoftBody const& body)
{
  switch (body.shape) {
    case BodyShape::disc:
    case BodyShape::tube:
      return body.outer;
    case BodyShape::mesh: {
      Eigen::Map<Eigen::Matrix3Xd const> const points(body.mesh.mesh.points.data(), 3,
                                                      body.mesh.mesh.points.size() / 3);
      Eigen::Vector3d lengths = points.rowwise().maxCoeff() - points.rowwise().minCoeff();
      std::ranges::sort(lengths);
      return lengths[1] / 2;
    }
    default:
      return (body.outer - body.inner) / 2;
  }
}

double slenderness(SoftBody const& body) { return largest_magnitude(body.thickness) / span(body); }

bool has_bending(SoftBody const& body) { return bends(body.bending, slenderness(body)); }

}  // namespace velum::cases
