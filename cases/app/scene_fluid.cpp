#include "cases/app/scene_sections.hpp"

#include <fmt/format.h>

namespace velum::cases {

using core::Dimension;

Lattice read_lattice(SceneTable table)
{
  table.allow({"dx", "from", "to", "mach", "time_step", "collision", "magic", "precision", "shift",
               "periodic"});
  Lattice lattice{.dx = table.quantity("dx", Dimension::length, Sign::positive),
                  .from = table.point("from"),
                  .to = table.point("to")};
  lattice.mach = table.number("mach", lattice.mach);
  if (lattice.mach >= 1)
    table.fail("mach", fmt::format("must be below 1, but is {}.", lattice.mach));
  lattice.time_step = table.quantity_or_auto("time_step", Dimension::time);
  lattice.collision = table.choice<Collision>("collision", lattice.collision);
  lattice.magic = table.number("magic", lattice.magic);
  lattice.precision = table.choice<Precision>("precision", lattice.precision);
  lattice.shift = table.point("shift", lattice.shift);
  if (table.has("periodic"))
    for (auto const& axis : table.texts("periodic", {"x", "y"}))
      (axis == "x" ? lattice.periodic_x : lattice.periodic_y) = true;
  return lattice;
}

FluidProperties read_fluid(SceneTable table)
{
  table.allow({"density", "viscosity", "body_force"});
  FluidProperties fluid{
      table.quantity("density", Dimension::density, Sign::positive),
      table.quantity("viscosity", Dimension::kinematic_viscosity, Sign::positive)};
  if (table.has("body_force"))
    fluid.body_force = table.vector("body_force", Dimension::acceleration);
  return fluid;
}

Les read_les(SceneTable table)
{
  table.allow({"model", "constant"});
  Les les;
  les.model = table.choice<LesModel>("model", les.model);
  les.constant = table.number("constant", les.constant);
  return les;
}

namespace {

std::vector<Patch> read_patches(SceneTable& table)
{
  std::vector<Patch> patches;
  for (auto& entry : table.list("patches")) {
    entry.allow({"side", "from", "to"});
    Patch const patch{entry.text("side"), entry.quantity("from", Dimension::length),
                      entry.quantity("to", Dimension::length)};
    if (patch.from >= patch.to) entry.fail("to", "must be larger than \"from\".");
    patches.push_back(patch);
  }
  return patches;
}

}  // namespace

Boundary read_boundary(SceneTable table, std::string name, core::Symmetry symmetry)
{
  table.allow({"kind", "pressure", "velocity", "flow_rate", "patches", "profile"});
  auto const kind = table.choice<BoundaryKind>("kind");
  bool const has_pressure = kind == BoundaryKind::traction || kind == BoundaryKind::pressure ||
                            kind == BoundaryKind::outflow;
  bool const has_velocity = kind == BoundaryKind::velocity || kind == BoundaryKind::moving_wall;
  std::string const key = has_pressure ? "pressure" : has_velocity ? "velocity" : word(kind);
  std::vector<std::string> keys{"kind", key, "patches"};
  bool const has_profile = kind == BoundaryKind::traction || kind == BoundaryKind::velocity ||
                           kind == BoundaryKind::flow_rate;
  if (has_profile) keys.push_back("profile");
  table.allow(keys, fmt::format(" with kind = \"{}\"", word(kind)));

  Boundary boundary{std::move(name), kind, {}, {}};
  boundary.profile = table.choice<VelocityProfile>("profile", boundary.profile);
  if (has_pressure) {
    std::optional<double> fallback;
    if (kind == BoundaryKind::outflow) fallback = 0.0;
    boundary.value = table.curve(key, Dimension::time, Dimension::pressure, Sign::any, fallback);
  } else if (has_velocity) {
    boundary.value = table.curve(key, Dimension::time, Dimension::velocity);
  } else {
    boundary.value = table.curve(
        key, Dimension::time,
        symmetry == core::Symmetry::planar ? Dimension::flow_rate_per_depth : Dimension::flow_rate);
  }
  boundary.patches = read_patches(table);
  return boundary;
}

}  // namespace velum::cases
