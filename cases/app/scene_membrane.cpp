#include "cases/app/scene_sections.hpp"

#include <fmt/format.h>

namespace velum::cases {

using core::Dimension;

Material read_material(SceneTable table)
{
  table.allow({"shear_modulus", "card", "density", "damping_mass", "damping_stiffness"});
  Material material{{},
                    table.quantity("density", Dimension::density, Sign::positive),
                    table.quantity("damping_mass", Dimension::frequency, Sign::not_negative, 0.0),
                    table.quantity("damping_stiffness", Dimension::time, Sign::not_negative, 0.0)};
  if (!table.has("card")) {
    material.rubber = structure::neo_hookean_rubber(
        table.quantity("shear_modulus", Dimension::pressure, Sign::positive));
    return material;
  }
  if (table.has("shear_modulus"))
    table.fail("shear_modulus", "and \"card\" both say how stiff the rubber is; keep one.");
  material.file = table.file_name("card");
  material.card = read_card(table.beside(material.file));
  material.rubber = material.card->rubber;
  return material;
}

namespace {

Spring read_spring(SceneTable table, core::Symmetry symmetry)
{
  table.allow({"stiffness", "free_length", "installed_length", "radius"});
  auto const stiffness =
      symmetry == core::Symmetry::planar ? Dimension::stiffness_per_depth : Dimension::stiffness;
  Spring const spring{
      table.quantity("stiffness", stiffness, Sign::not_negative),
      table.quantity("free_length", Dimension::length, Sign::positive),
      table.quantity("installed_length", Dimension::length, Sign::positive),
      table.quantity("radius", Dimension::length, Sign::positive),
  };
  if (spring.installed_length > spring.free_length)
    table.fail("installed_length", "must not exceed \"free_length\": the spring can only push.");
  return spring;
}

DrivenCentre read_centre(SceneTable table, MembraneSheet const& membrane)
{
  table.allow({"radius", "displacement"});
  DrivenCentre const centre{table.quantity("radius", Dimension::length, Sign::positive),
                            table.curve("displacement", Dimension::time, Dimension::length)};
  if (membrane.shape != MembraneShape::disc)
    table.fail("radius", "belongs to a disc; the middle of a strip cannot be driven.");
  if (centre.radius > membrane.to - membrane.element)
    table.fail("radius", "must leave an element or more between it and the rim.");
  return centre;
}

Stop read_stop(SceneTable table, MembraneSheet const& membrane)
{
  table.allow({"position", "radius"});
  Stop const stop{table.quantity("position", Dimension::length),
                  table.quantity("radius", Dimension::length, Sign::positive, membrane.to)};
  if (membrane.shape != MembraneShape::disc)
    table.fail("position", "belongs to a disc; a strip has no stop.");
  if (stop.radius > membrane.to) table.fail("radius", "must not exceed that of the membrane.");
  return stop;
}

}  // namespace

MembraneSheet read_membrane(SceneTable table, core::Symmetry symmetry, double dx)
{
  std::vector<std::string> keys{"shape",  "material",  "position", "radius", "from",
                                "to",     "thickness", "element",  "rim",    "bending",
                                "centre", "spring",    "stop"};
  table.allow(keys);
  auto const shape = table.choice<MembraneShape>("shape");
  bool const disc = shape == MembraneShape::disc;
  if (disc != (symmetry == core::Symmetry::axisymmetric))
    table.fail("shape",
               fmt::format("cannot be \"{}\" in {} scene; it must be \"{}\".", word(shape),
                           disc ? "a planar" : "an axisymmetric", disc ? "strip" : "disc"));
  std::erase_if(keys, [&](std::string const& key) {
    return disc ? key == "from" || key == "to" : key == "radius";
  });
  table.allow(keys, fmt::format(" with shape = \"{}\"", word(shape)));

  MembraneSheet membrane{
      .shape = shape,
      .material = table.text("material"),
      .position = table.quantity("position", Dimension::length),
      .from = disc ? 0.0 : table.quantity("from", Dimension::length),
      .to = disc ? table.quantity("radius", Dimension::length, Sign::positive)
                 : table.quantity("to", Dimension::length),
      .thickness = table.curve("thickness", Dimension::length, Dimension::length, Sign::positive),
      .element = table.quantity("element", Dimension::length, Sign::positive, dx),
      .rim = table.choice<Rim>("rim", Rim::clamped),
      .bending = table.choice<Bending>("bending", Bending::auto_)};
  if (membrane.from >= membrane.to) table.fail("to", "must be larger than \"from\".");
  if (membrane.element > 0.5 * (membrane.to - membrane.from))
    table.fail("element", "must be at most half the width of the membrane.");
  if (table.has("centre")) membrane.centre = read_centre(table.table("centre"), membrane);
  if (table.has("spring")) membrane.spring = read_spring(table.table("spring"), symmetry);
  if (table.has("stop")) membrane.stop = read_stop(table.table("stop"), membrane);
  return membrane;
}

ContactPair read_contact(SceneTable table)
{
  table.allow({"seat", "method", "stiffness", "lip_pressure"});
  ContactPair contact{.seat = table.text("seat")};
  contact.method = table.choice<ContactMethod>("method", contact.method);
  contact.stiffness = table.pressure_per_length_or_auto("stiffness");
  contact.lip_pressure = table.choice<LipPressure>("lip_pressure", contact.lip_pressure);
  return contact;
}

Coupling read_coupling(SceneTable table)
{
  table.allow({"method", "scheme", "membrane", "feedback"});
  Coupling coupling;
  coupling.method = table.choice<CouplingMethod>("method", coupling.method);
  coupling.scheme = table.choice<CouplingScheme>("scheme", coupling.scheme);
  coupling.membrane = table.choice<MembraneScheme>("membrane", coupling.membrane);
  coupling.feedback = table.choice<Feedback>("feedback", coupling.feedback);
  return coupling;
}

double slenderness(MembraneSheet const& membrane)
{
  double const span =
      membrane.shape == MembraneShape::disc ? membrane.to : (membrane.to - membrane.from) / 2;
  return largest_magnitude(membrane.thickness) / span;
}

bool has_bending(MembraneSheet const& membrane)
{
  return bends(membrane.bending, slenderness(membrane));
}

}  // namespace velum::cases
