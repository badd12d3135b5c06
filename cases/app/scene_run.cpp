#include "cases/app/scene_sections.hpp"

#include <fmt/format.h>

#include <cmath>

namespace velum::cases {

using core::Dimension;

Schedule read_schedule(SceneTable table)
{
  table.allow({"settle", "shut", "end", "output_every", "sample_every", "steady",
               "checkpoint_every", "fall_back"});
  Schedule run{.output_every = 0, .end = 0, .sample_every = 0};
  run.shut = table.quantity("shut", Dimension::time, Sign::not_negative, 0.0);
  if (table.has("end")) {
    run.end = table.quantity("end", Dimension::time, Sign::positive);
    if (run.shut > run.end) table.fail("shut", "must not exceed \"end\".");
    run.settle = table.quantity("settle", Dimension::time, Sign::not_negative, run.end - run.shut);
  } else {
    run.settle = table.quantity("settle", Dimension::time, Sign::positive);
    run.end = run.settle + run.shut;
  }
  run.output_every = table.quantity("output_every", Dimension::time, Sign::positive, run.end);
  run.sample_every =
      table.quantity("sample_every", Dimension::time, Sign::positive, run.output_every);
  if (table.has("checkpoint_every"))
    run.checkpoint_every = table.quantity("checkpoint_every", Dimension::time, Sign::positive);
  if (table.has("fall_back")) {
    double const times = table.number("fall_back", 1);
    if (times != std::floor(times) || times > 10)
      table.fail("fall_back",
                 fmt::format("must be a whole number from 1 to 10, but is {}.", times));
    run.fall_back = static_cast<int>(times);
  }
  if (table.has("steady")) run.steady = table.number("steady", 0);
  if (run.steady >= 1) table.fail("steady", fmt::format("must be below 1, but is {}.", run.steady));
  return run;
}

Start read_start(SceneTable table)
{
  table.allow({"settle", "scene"});
  Start start{.settle = table.quantity("settle", Dimension::time, Sign::positive)};
  if (table.has("scene")) start.scene = table.file_name("scene");
  return start;
}

InitialState read_initial(SceneTable table)
{
  table.allow({"kind", "velocity", "steepness", "disturbance"});
  InitialState initial{.kind = table.choice<InitialKind>("kind")};
  std::vector<std::string> keys{"kind"};
  if (initial.kind != InitialKind::rest) keys.push_back("velocity");
  if (initial.kind == InitialKind::shear_layer)
    keys.insert(keys.end(), {"steepness", "disturbance"});
  table.allow(keys, fmt::format(" with kind = \"{}\"", word(initial.kind)));
  if (initial.kind == InitialKind::rest) return initial;
  initial.velocity = table.quantity("velocity", Dimension::velocity, Sign::positive);
  initial.steepness = table.number("steepness", initial.steepness);
  initial.disturbance = table.number("disturbance", initial.disturbance);
  return initial;
}

Probe read_probe(SceneTable table, std::string name)
{
  table.allow({"kind", "at", "solid", "from", "to"});
  Probe probe{.name = std::move(name), .kind = table.choice<ProbeKind>("kind")};
  std::string const condition = fmt::format(" with kind = \"{}\"", word(probe.kind));
  switch (probe.kind) {
    case ProbeKind::point:
      table.allow({"kind", "at"}, condition);
      probe.from = table.point("at");
      break;
    case ProbeKind::force:
      table.allow({"kind", "solid"}, condition);
      probe.solid = table.text("solid");
      break;
    case ProbeKind::pressure_difference:
      table.allow({"kind", "from", "to"}, condition);
      probe.from = table.point("from");
      probe.to = table.point("to");
      break;
    case ProbeKind::kinetic_energy:
      table.allow({"kind"}, condition);
      break;
  }
  return probe;
}

Reference read_reference(SceneTable table)
{
  table.allow({"kind", "file", "length", "radius", "force", "pressure_difference", "kinetic_energy",
               "figure", "value", "scale"});
  Reference reference{.kind = table.choice<ReferenceKind>("kind")};
  std::string const condition = fmt::format(" with kind = \"{}\"", word(reference.kind));
  bool const body = reference.kind == ReferenceKind::body;
  bool const dissipation = reference.kind == ReferenceKind::dissipation;
  if (reference.kind == ReferenceKind::taylor_green) {
    table.allow({"kind"}, condition);
  } else if (reference.kind == ReferenceKind::pipe) {
    table.allow({"kind", "radius"}, condition);
    reference.length = table.quantity("radius", Dimension::length, Sign::positive);
  } else if (reference.kind == ReferenceKind::figure) {
    table.allow({"kind", "figure", "value", "scale"}, condition);
    reference.figure = table.text("figure");
    reference.value = table.any_number("value");
    reference.scale = table.number("scale", std::abs(reference.value));
    if (reference.scale == 0)
      table.fail("value", "= 0 needs a scale beside it, of which the error is a share.");
  } else {
    std::vector<std::string> keys{"kind", "file", "length"};
    if (body) keys.insert(keys.end(), {"force", "pressure_difference"});
    if (dissipation) keys.push_back("kinetic_energy");
    table.allow(keys, condition);
    reference.file = table.file_name("file");
    reference.length = table.quantity("length", Dimension::length, Sign::positive);
    if (body) reference.force = table.text("force");
    if (dissipation) reference.energy = table.text("kinetic_energy");
    if (table.has("pressure_difference")) reference.difference = table.text("pressure_difference");
  }
  return reference;
}

Sweep read_sweep(SceneTable table)
{
  table.allow({"dx"});
  return {table.quantities("dx", Dimension::length)};
}

}  // namespace velum::cases
