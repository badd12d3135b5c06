#include "cases/app/fluid_record.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cases/app/dump.hpp"
#include "lbm/formats.hpp"

namespace velum::cases {
namespace {

/// One column for each coordinate.
void add_vector(std::string const& name, char const* unit, int dimensions,
                std::vector<core::Column>& columns)
{
  for (int a = 0; a < dimensions; ++a)
    columns.push_back({fmt::format("{}_{}", name, "xyz"[a]), unit});
}

void add_columns(Probe const& probe, int dimensions, std::vector<core::Column>& columns)
{
  switch (probe.kind) {
    case ProbeKind::point:
      add_vector(probe.name + "_velocity", "m/s", dimensions, columns);
      columns.push_back({probe.name + "_pressure", "Pa"});
      return;
    case ProbeKind::force:
      add_vector(probe.name + "_force", "N", dimensions, columns);
      return;
    case ProbeKind::kinetic_energy:
      columns.push_back({probe.name + "_kinetic_energy", "m2/s2"});
      return;
    case ProbeKind::pressure_difference:
      columns.push_back({probe.name + "_pressure_difference", "Pa"});
  }
}

bool reads_the_flow(Probe const& probe)
{
  return probe.kind == ProbeKind::point || probe.kind == ProbeKind::pressure_difference;
}

template <class Real, class L, class Stored>
void add_probes(FluidScene<Real, L, Stored>& s, lbm::Observation const& seen,
                std::vector<double>& values)
{
  auto const& probes = s.scene->probes;
  auto const& units = s.lattice.derived.units;
  std::optional<Sampled> flow;
  if (std::any_of(probes.begin(), probes.end(), reads_the_flow)) flow.emplace(sampled(s));
  auto const pressure = [&](Vec3 const& p) {
    return core::to_si_pressure(units, state_at(*flow, p).rho / 3);
  };
  std::size_t body = 0;
  for (auto const& probe : probes) switch (probe.kind) {
      case ProbeKind::force: {
        Vec3 const f = body_force(s, body++);
        values.insert(values.end(), f.c, f.c + L::D);
        break;
      }
      case ProbeKind::point: {
        auto const state = state_at(*flow, probe.from);
        double const u[] = {state.ux, state.uy, state.uz};
        for (int a = 0; a < L::D; ++a) values.push_back(core::to_si_velocity(units, u[a]));
        values.push_back(core::to_si_pressure(units, state.rho / 3));
        break;
      }
      case ProbeKind::kinetic_energy: {
        double const speed = core::to_si_velocity(units, 1);
        values.push_back(0.5 * seen.speed_squared_mean * speed * speed);
        break;
      }
      case ProbeKind::pressure_difference:
        values.push_back(pressure(probe.from) - pressure(probe.to));
    }
}

}  // namespace

template <class Real, class L, class Stored>
FluidRecord start_record(FluidScene<Real, L, Stored> const& s, std::filesystem::path const& out,
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
  for (auto const& probe : s.scene->probes) add_columns(probe, L::D, columns);
  if (out.empty()) return record;
  record.series.emplace(core::start_series(out / "series.csv", columns));
  record.fields = core::create_fields(out, s.lattice.derived.grid, about);
  return record;
}

template <class Real, class L, class Stored>
void add_sample(FluidRecord& record, FluidScene<Real, L, Stored>& s, lbm::Observation const& seen,
                double time)
{
  auto const& units = s.lattice.derived.units;
  std::vector<double> values = {core::to_si_velocity(units, seen.speed_max)};
  for (auto const& o : s.lattice.openings) {
    values.push_back(core::to_si_flow_rate(units, symmetry(*s.scene), o.opening.mass_flow));
    values.push_back(core::to_si_pressure(units, o.opening.traction));
  }
  add_probes(s, seen, values);
  if (record.series) core::append(*record.series, time, values);
  record.history.time.push_back(time);
  record.history.rows.push_back(std::move(values));
}

template <class Real, class L, class Stored>
void add_dump(FluidRecord& record, FluidScene<Real, L, Stored> const& s, double time)
{
  if (record.fields)
    core::write_fields(*record.fields, time, fluid_fields(s.lattice.fluid, s.lattice.derived.units),
                       {});
}

#define VELUM_INSTANTIATE(Real, L, Stored)                                                   \
  template FluidRecord start_record(FluidScene<Real, lbm::L, Stored> const&,                 \
                                    std::filesystem::path const&, core::Assumptions const&); \
  template void add_sample(FluidRecord&, FluidScene<Real, lbm::L, Stored>&,                  \
                           lbm::Observation const&, double);                                 \
  template void add_dump(FluidRecord&, FluidScene<Real, lbm::L, Stored> const&, double);
VELUM_EACH_FLUID(VELUM_INSTANTIATE)
#undef VELUM_INSTANTIATE

}  // namespace velum::cases
