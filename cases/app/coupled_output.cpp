#include "cases/app/coupled_output.hpp"

#include <spdlog/spdlog.h>

#include "cases/app/dump.hpp"
#include "cases/app/network_columns.hpp"
#include "core/check.hpp"

namespace velum::cases {
namespace {

std::vector<core::Column> columns(Scene const& scene)
{
  return valve_columns(scene, {{"outflow", "m3"},
                               {"inflow", "m3"},
                               {"leak_through_seat", "m3"},
                               {"leak_through_membrane", "m3"},
                               {"volume_inside", "m3"},
                               {"speed_max", "m/s"},
                               {"pressure_least", "Pa"},
                               {"sealed", "1"},
                               {"gap", "m"},
                               {"flow", "m3/s"},
                               {"gap_by_law", "1"}});
}

std::vector<double> row(Measurement const& m)
{
  std::vector<double> r = {m.pressure_above,
                           m.pressure_outside,
                           m.pressure_inside,
                           m.centre,
                           m.penetration,
                           m.seat_force,
                           m.outflow,
                           m.inflow,
                           m.through_seat,
                           m.through_membrane,
                           m.volume_inside,
                           m.speed_max,
                           m.pressure_least,
                           m.sealed ? 1.0 : 0.0,
                           m.gap,
                           m.flow,
                           m.gap_by_law};
  r.insert(r.end(), m.network.begin(), m.network.end());
  return r;
}

}  // namespace

CoupledOutput start_output(Scene const& scene, Derived const& d, core::Assumptions const& said,
                           std::filesystem::path const& folder)
{
  return {core::create_fields(folder, d.grid, said),
          core::start_series(folder / "series.csv", columns(scene)), 0};
}

CoupledOutput resume_output(CoupledOutput out, Scene const& scene, Derived const& d,
                            core::Assumptions const& said, std::filesystem::path const& folder)
{
  out.series = core::resume_series(folder / "series.csv", columns(scene), out.series.rows);
  try {
    out.fields = core::resume_fields(folder, d.grid, out.fields.dumps, out.fields.times);
  } catch (core::InputError const& lost) {
    spdlog::warn("{} Fields are written anew from here on; rows of series.csv are kept.",
                 lost.what());
    out.fields = core::create_fields(folder, d.grid, said);
  }
  return out;
}

template <class Real, template <class> class Body>
void record(CoupledOutput& out, CoupledScene<Real, Body> const& s, Measurement const& m,
            double output_every)
{
  core::append(out.series, m.time, row(m));
  double const almost = s.derived.units.dt;  // a stage ends up to half a step beside its time
  if (m.time + almost < out.next_dump) return;
  core::write_fields(out.fields, m.time, fluid_fields(s.state.fluid, s.derived.units),
                     membrane_curves(s));
  while (out.next_dump <= m.time + almost) out.next_dump += output_every;
}

template void record(CoupledOutput&, CoupledScene<float, ibm::Sharp> const&, Measurement const&,
                     double);
template void record(CoupledOutput&, CoupledScene<float, ibm::Diffuse> const&, Measurement const&,
                     double);
template void record(CoupledOutput&, CoupledScene<double, ibm::Sharp> const&, Measurement const&,
                     double);
template void record(CoupledOutput&, CoupledScene<double, ibm::Diffuse> const&, Measurement const&,
                     double);

}  // namespace velum::cases
