#include "cases/app/fluid_record.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cases/app/dump.hpp"

namespace velum::cases {
namespace {

void add_columns(Probe const& probe, std::vector<core::Column>& columns)
{
  switch (probe.kind) {
    case ProbeKind::point:
      columns.push_back({probe.name + "_velocity_x", "m/s"});
      columns.push_back({probe.name + "_velocity_y", "m/s"});
      columns.push_back({probe.name + "_pressure", "Pa"});
      return;
    case ProbeKind::force:
      columns.push_back({probe.name + "_force_x", "N"});
      columns.push_back({probe.name + "_force_y", "N"});
      return;
    case ProbeKind::pressure_difference:
      columns.push_back({probe.name + "_pressure_difference", "Pa"});
  }
}

template <class Real>
void add_probes(FluidScene<Real>& s, std::vector<double>& values)
{
  auto const& probes = s.scene->probes;
  auto const& units = s.lattice.derived.units;
  std::optional<Sampled> flow;
  if (std::any_of(probes.begin(), probes.end(),
                  [](Probe const& p) { return p.kind != ProbeKind::force; }))
    flow.emplace(sampled(s));
  auto const pressure = [&](Vec2 const& p) {
    return core::to_si_pressure(units, state_at(*flow, p).rho / 3);
  };
  std::size_t body = 0;
  for (auto const& probe : probes) {
    if (probe.kind == ProbeKind::force) {
      Vec2 const f = body_force(s, body++);
      values.insert(values.end(), {f[0], f[1]});
    } else if (probe.kind == ProbeKind::point) {
      auto const state = state_at(*flow, probe.from);
      values.insert(values.end(),
                    {core::to_si_velocity(units, state.ux), core::to_si_velocity(units, state.uy),
                     core::to_si_pressure(units, state.rho / 3)});
    } else {
      values.push_back(pressure(probe.from) - pressure(probe.to));
    }
  }
}

}  // namespace

template <class Real>
FluidRecord start_record(FluidScene<Real> const& s, std::filesystem::path const& out,
                         core::Assumptions const& about)
{
  FluidRecord record;
  auto& columns = record.history.columns;
  columns = {{"speed_max", "m/s"}};
  for (auto const& o : s.lattice.openings) {
    std::string const name = fmt::format("{}_{}", o.boundary, columns.size() / 2);
    columns.push_back({name + "_flow", "m3/s"});
    columns.push_back({name + "_traction", "Pa"});
  }
  for (auto const& probe : s.scene->probes) add_columns(probe, columns);
  if (out.empty()) return record;
  record.series.emplace(core::start_series(out / "series.csv", columns));
  record.fields = core::create_fields(out, s.lattice.derived.grid, about);
  return record;
}

template <class Real>
void add_sample(FluidRecord& record, FluidScene<Real>& s, lbm::Observation const& seen, double time)
{
  auto const& units = s.lattice.derived.units;
  std::vector<double> values = {core::to_si_velocity(units, seen.speed_max)};
  for (auto const& o : s.lattice.openings) {
    values.push_back(core::to_si_flow_rate(units, symmetry(*s.scene), o.opening.mass_flow));
    values.push_back(core::to_si_pressure(units, o.opening.traction));
  }
  add_probes(s, values);
  if (record.series) core::append(*record.series, time, values);
  record.history.time.push_back(time);
  record.history.rows.push_back(std::move(values));
}

template <class Real>
void add_dump(FluidRecord& record, FluidScene<Real> const& s, double time)
{
  if (record.fields)
    core::write_fields(*record.fields, time, fluid_fields(s.lattice.fluid, s.lattice.derived.units),
                       {});
}

template FluidRecord start_record(FluidScene<float> const&, std::filesystem::path const&,
                                  core::Assumptions const&);
template FluidRecord start_record(FluidScene<double> const&, std::filesystem::path const&,
                                  core::Assumptions const&);
template void add_sample(FluidRecord&, FluidScene<float>&, lbm::Observation const&, double);
template void add_sample(FluidRecord&, FluidScene<double>&, lbm::Observation const&, double);
template void add_dump(FluidRecord&, FluidScene<float> const&, double);
template void add_dump(FluidRecord&, FluidScene<double> const&, double);

}  // namespace velum::cases
