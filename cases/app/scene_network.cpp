#include "cases/app/scene_sections.hpp"

#include <fmt/format.h>

namespace velum::cases {

using core::Dimension;

namespace {

/// A share above 0 and at most 1, such as a discharge coefficient.
double coefficient(SceneTable& table, std::string const& key, double fallback)
{
  double const value = table.number(key, fallback);
  if (value > 1)
    table.fail(key, fmt::format("= {} must not exceed 1: no passage passes more than its section.",
                                value));
  return value;
}

LiftedSeat read_seat(SceneTable table)
{
  table.allow({"diameter", "land", "discharge", "lift"});
  LiftedSeat seat{.diameter = table.quantity("diameter", Dimension::length, Sign::positive),
                  .land = table.quantity("land", Dimension::length, Sign::positive)};
  seat.discharge = coefficient(table, "discharge", seat.discharge);
  seat.lift = table.curve("lift", Dimension::time, Dimension::length, Sign::not_negative);
  return seat;
}

PilotMembrane read_pilot(SceneTable table, LiftedSeat const& seat)
{
  table.allow({"material", "radius", "boss", "thickness"});
  PilotMembrane const pilot{
      .material = table.text("material"),
      .radius = table.quantity("radius", Dimension::length, Sign::positive),
      .boss = table.quantity("boss", Dimension::length, Sign::positive),
      .thickness = table.curve("thickness", Dimension::length, Dimension::length, Sign::positive)};
  if (pilot.boss > 0.9 * pilot.radius)
    table.fail("boss", "must leave a tenth of the radius or more to the elastic ring around it.");
  if (seat.diameter / 2 >= pilot.radius)
    table.fail("radius", "must be larger than that of the seat that the membrane lifts off.");
  return pilot;
}

}  // namespace

GapSection read_gap(SceneTable table)
{
  table.allow({"cells", "discharge", "seals_at", "inlet_length", "outlet_length"});
  GapSection gap;
  gap.cells = table.number("cells", 4);
  gap.discharge = coefficient(table, "discharge", gap.discharge);
  gap.seals_at = table.quantity("seals_at", Dimension::length, Sign::positive, gap.seals_at);
  gap.inlet_length = table.quantity("inlet_length", Dimension::length, Sign::not_negative, 0.0);
  gap.outlet_length = table.quantity("outlet_length", Dimension::length, Sign::not_negative, 0.0);
  return gap;
}

ChamberSection read_chamber(SceneTable table, std::string name)
{
  table.allow({"side", "volume", "bulk_modulus", "pressure"});
  ChamberSection chamber{.name = std::move(name),
                         .side = table.choice<ChamberSide>("side", ChamberSide::none),
                         .volume = table.quantity("volume", Dimension::volume, Sign::positive)};
  chamber.bulk_modulus =
      table.quantity("bulk_modulus", Dimension::pressure, Sign::positive, chamber.bulk_modulus);
  chamber.initial = table.quantity_or_auto("pressure", Dimension::pressure);
  return chamber;
}

OrificeSection read_orifice(SceneTable table, std::string name)
{
  table.allow({"from", "to", "area", "discharge", "transition", "length", "seat", "membrane"});
  OrificeSection orifice{.name = std::move(name),
                         .from = table.text("from"),
                         .to = table.text("to"),
                         .area = table.quantity("area", Dimension::area, Sign::positive)};
  orifice.discharge = coefficient(table, "discharge", orifice.discharge);
  orifice.transition = table.number("transition", orifice.transition);
  orifice.length = table.quantity("length", Dimension::length, Sign::not_negative, 0.0);
  if (table.has("seat")) orifice.seat = read_seat(table.table("seat"));
  if (table.has("membrane")) {
    if (!orifice.seat)
      table.fail("membrane", "is what lifts off a seat: [" + table.path() + ".seat] is missing.");
    orifice.member = read_pilot(table.table("membrane"), *orifice.seat);
  }
  return orifice;
}

}  // namespace velum::cases
