#include "cases/app/scene_sections.hpp"

#include "cases/app/geometry.hpp"

#include <fmt/format.h>

namespace velum::cases {

using core::Dimension;

namespace {

std::vector<std::string> axis_names(int dimensions)
{
  std::vector<std::string> names = {"x", "y", "z"};
  names.resize(static_cast<std::size_t>(dimensions));
  return names;
}

}  // namespace

Lattice read_lattice(SceneTable table)
{
  table.allow({"dx", "from", "to", "mach", "time_step", "collision", "magic", "wall_rule",
               "precision", "shift", "periodic", "symmetry", "stencil"});
  Lattice lattice{.dx = table.quantity("dx", Dimension::length, Sign::positive),
                  .from = table.point("from"),
                  .to = table.point("to")};
  lattice.mach = table.number("mach", lattice.mach);
  if (lattice.mach >= 1)
    table.fail("mach", fmt::format("must be below 1, but is {}.", lattice.mach));
  lattice.time_step = table.quantity_or_auto("time_step", Dimension::time);
  lattice.collision = table.choice<Collision>("collision", lattice.collision);
  lattice.magic = table.number("magic", lattice.magic);
  if (!lbm::is_defined(lattice.collision, lattice.wall_rule))
    lattice.wall_rule = lbm::WallRule::linear;
  lattice.wall_rule = table.choice<lbm::WallRule>("wall_rule", lattice.wall_rule);
  if (!lbm::is_defined(lattice.collision, lattice.wall_rule))
    table.fail("wall_rule",
               fmt::format("= \"quadratic\" needs collision = \"central_moments\", but "
                           "it is \"{}\"; \"linear\" and \"half_way\" go with all.",
                           word(lattice.collision)));
  lattice.precision = table.choice<Precision>("precision", lattice.precision);
  lattice.shift = table.point("shift", lattice.shift);
  if (table.has("periodic"))
    for (auto const& axis : table.texts("periodic", axis_names(table.dimensions())))
      lattice.periodic[static_cast<std::size_t>(axis[0] - 'x')] = true;
  if (table.has("symmetry"))
    for (auto const& side : table.texts("symmetry", side_names(table.dimensions())))
      lattice.mirrors |= lbm::mirror(side[0] - 'x', side[1] == '+');
  bool const space = table.dimensions() == 3;
  lattice.stencil = table.choice<Stencil>("stencil", space ? Stencil::d3q19 : Stencil::d2q9);
  if (space == (lattice.stencil == Stencil::d2q9))
    table.fail("stencil", fmt::format("cannot be \"{}\" in {}", word(lattice.stencil),
                                      space ? "space; \"d3q19\" or \"d3q27\" can."
                                            : "a plane; only \"d2q9\" can."));
  if (!lbm::is_defined(lattice.collision, directions(lattice.stencil)))
    table.fail("collision", "= \"cumulant\" needs stencil = \"d3q27\", in a 3d scene.");
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
  les.constant = table.number("constant", les.model == LesModel::vreman ? 0.025 : les.constant);
  return les;
}

namespace {

/// A patch in space: a rectangle from corner to corner, a disc, or the whole side.
Patch patch_in_space(SceneTable& entry)
{
  bool const disc = entry.has("centre") || entry.has("radius");
  entry.allow(disc ? std::vector<std::string>{"side", "centre", "radius"}
                   : std::vector<std::string>{"side", "from", "to"},
              disc ? " with a disc" : "");
  Patch patch{entry.text("side"), {}, {}, disc};
  if (disc) {
    Vec2 const centre = entry.pair("centre");
    double const radius = entry.quantity("radius", Dimension::length, Sign::positive);
    patch.from = centre - Vec2{radius, radius};
    patch.to = centre + Vec2{radius, radius};
  } else {
    patch.from = entry.pair("from");
    patch.to = entry.pair("to");
  }
  return patch;
}

Patch patch_in_plane(SceneTable& entry)
{
  entry.allow({"side", "from", "to"});
  return {entry.text("side"),
          {entry.quantity("from", Dimension::length), 0},
          {entry.quantity("to", Dimension::length), 0}};
}

/// The whole of a side of the box.
Patch whole_side(SceneTable& entry, Lattice const& lattice)
{
  Patch patch{entry.text("side"), {}, {}};
  auto const side = box_side(patch.side);
  if (!side)
    entry.fail("from", fmt::format("is missing; without it a patch is a whole side of the box, and "
                                   "\"{}\" is none.",
                                   patch.side));
  for (int k = 0; k + 1 < entry.dimensions(); ++k) {
    patch.from[k] = lattice.from[axis_along(*side, k)];
    patch.to[k] = lattice.to[axis_along(*side, k)];
  }
  return patch;
}

std::vector<Patch> read_patches(SceneTable& table, Lattice const& lattice)
{
  std::vector<Patch> patches;
  for (auto& entry : table.list("patches")) {
    entry.allow({"side", "from", "to", "centre", "radius"});
    bool const whole =
        !entry.has("from") && !entry.has("to") && !entry.has("centre") && !entry.has("radius");
    Patch const patch = whole                     ? whole_side(entry, lattice)
                        : entry.dimensions() == 3 ? patch_in_space(entry)
                                                  : patch_in_plane(entry);
    for (int k = 0; k + 1 < entry.dimensions(); ++k)
      if (patch.from[k] >= patch.to[k]) entry.fail("to", "must be larger than \"from\".");
    patches.push_back(patch);
  }
  return patches;
}

}  // namespace

Boundary read_boundary(SceneTable table, std::string name, core::Symmetry symmetry,
                       Lattice const& lattice)
{
  table.allow({"kind", "pressure", "velocity", "flow_rate", "patches", "profile", "along"});
  auto const kind = table.choice<BoundaryKind>("kind");
  bool const has_pressure = imposes_pressure(kind);
  bool const has_velocity = kind == BoundaryKind::velocity || kind == BoundaryKind::moving_wall;
  bool const is_port =
      kind == BoundaryKind::port;  // its flow is that of the orifices which end there
  std::string const key = has_pressure ? "pressure" : has_velocity ? "velocity" : word(kind);
  std::vector<std::string> keys{"kind", "patches"};
  if (!is_port) keys.insert(keys.begin() + 1, key);
  bool const has_profile = kind == BoundaryKind::traction || kind == BoundaryKind::velocity ||
                           kind == BoundaryKind::flow_rate;
  if (has_profile) keys.push_back("profile");
  bool const has_axis = kind == BoundaryKind::moving_wall && table.dimensions() == 3;
  if (has_axis) keys.push_back("along");
  table.allow(keys, fmt::format(" with kind = \"{}\"", word(kind)));

  Boundary boundary{std::move(name), kind, {}, {}};
  boundary.profile = table.choice<VelocityProfile>("profile", boundary.profile);
  if (has_pressure) {
    std::optional<double> fallback;
    if (kind == BoundaryKind::outflow) fallback = 0.0;
    boundary.value = table.curve(key, Dimension::time, Dimension::pressure, Sign::any, fallback);
  } else if (has_velocity) {
    boundary.value = table.curve(key, Dimension::time, Dimension::velocity);
  } else if (!is_port) {
    boundary.value = table.curve(
        key, Dimension::time,
        symmetry == core::Symmetry::planar ? Dimension::flow_rate_per_depth : Dimension::flow_rate);
  }
  if (has_axis) boundary.along = table.choice<Axis>("along");
  boundary.patches = read_patches(table, lattice);
  return boundary;
}

}  // namespace velum::cases
