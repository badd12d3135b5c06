#include "cases/app/coupled_checkpoint.hpp"

#include "cases/app/coupled_state.hpp"
#include "core/check.hpp"

namespace velum::cases {
namespace {

void exchange(core::StateFile& file, std::string const& name, Measurement& m)
{
  double* const values[] = {
      &m.time,        &m.pressure_above, &m.pressure_outside, &m.pressure_inside, &m.volume_inside,
      &m.mass_inside, &m.centre,         &m.penetration,      &m.seat_force,      &m.gap,
      &m.flow,        &m.gap_by_law,     &m.speed_max,        &m.pressure_least,  &m.density_error,
      &m.outflow,     &m.inflow,         &m.through_seat,     &m.through_membrane};
  std::vector<double> flat;
  for (double const* v : values) flat.push_back(*v);
  file.field(name, flat);
  for (std::size_t k = 0; k < flat.size(); ++k) *values[k] = flat[k];
  file.number(name + " sealed", m.sealed);
  file.list(name + " network", m.network);
}

/// What the certificate gathers as the run goes on; the rest follows from the scene.
void exchange(core::StateFile& file, Certificate& c)
{
  exchange(file, "settled", c.settled);
  exchange(file, "window begin", c.window_begin);
  double values[] = {c.least_jump_shut, c.penetration_max, c.speed_max, c.mach_max};
  file.field("certificate", values, std::size(values));
  c.least_jump_shut = values[0];
  c.penetration_max = values[1];
  c.speed_max = values[2];
  c.mach_max = values[3];
  bool driven = c.driven.has_value();
  file.number("driven", driven);
  if (!driven) return c.driven.reset();
  DrivenRecord r = c.driven.value_or(DrivenRecord{});
  double record[] = {r.start, r.lift, r.volume_start, r.mass_start, r.swept, r.misfit};
  file.field("driven record", record, std::size(record));
  c.driven = {record[0], record[1], record[2], record[3], record[4], record[5]};
}

/// A run that fell back keeps the contact's stiffness of the step that it began with.
void exchange_stiffness(core::StateFile& file, ibm::SeatContact* seat, bool fallen)
{
  double stiffness = seat ? seat->contact.stiffness : 0;
  file.field("contact stiffness", stiffness);
  if (seat && fallen) seat->contact.stiffness = stiffness;
}

}  // namespace

template <class Real>
void exchange(core::StateFile& file, CoupledScene<Real, ibm::Sharp>& s, March& m,
              std::string& scene_text)
{
  file.number("step", m.step);
  file.number("fallen back", m.fallen);
  file.text("scene", scene_text);
  exchange_state(file, s, m.flows);
  exchange_stiffness(file, s.state.seat.get(), m.fallen > 0);
  exchange(file, "measurement", m.now);
  file.number("measured", m.measured);
  exchange(file, m.certificate);
  file.field("stretch", m.stretch.largest);
  file.field("stretch of a face", m.stretch.face);
  file.field("stretch i1", m.stretch.i1);
  file.number("stretch stable", m.stretch.stable);
  file.number("rows", m.out.series.rows);
  file.number("dumps", m.out.fields.dumps);
  file.text("dump times", m.out.fields.times);
  file.field("next dump", m.out.next_dump);
  file.field("next checkpoint", m.next_checkpoint);
  file.number("checkpoints", m.checkpoints);
  file.field("wall time", m.seconds);
  file.field("wall time of the membrane", s.state.membrane_seconds);
}

template <class Real>
std::filesystem::path save_checkpoint(std::filesystem::path const& folder,
                                      CoupledScene<Real, ibm::Sharp>& s, March& march,
                                      std::string scene_text)
{
  auto const path = folder / (march.checkpoints++ % 2 == 0 ? "checkpoint_a.h5" : "checkpoint_b.h5");
  auto file = core::StateFile::create(path);
  exchange(file, s, march, scene_text);
  file.commit();
  return path;
}

long times_fallen(std::filesystem::path const& checkpoint)
{
  long times = 0;
  auto file = core::StateFile::open(checkpoint);
  file.number("fallen back", times);
  return times;
}

std::filesystem::path newest_checkpoint(std::filesystem::path const& folder)
{
  std::filesystem::path newest;
  long steps = -1;
  for (auto const* name : {"checkpoint_a.h5", "checkpoint_b.h5"}) try {
      long found = 0;
      auto file = core::StateFile::open(folder / name);
      file.number("step", found);
      if (found <= steps) continue;
      steps = found;
      newest = folder / name;
    } catch (core::InputError const&) {  // absent or damaged: then it is the other one
    }
  return newest;
}

template void exchange(core::StateFile&, CoupledScene<float, ibm::Sharp>&, March&, std::string&);
template void exchange(core::StateFile&, CoupledScene<double, ibm::Sharp>&, March&, std::string&);
template std::filesystem::path save_checkpoint(std::filesystem::path const&,
                                               CoupledScene<float, ibm::Sharp>&, March&,
                                               std::string);
template std::filesystem::path save_checkpoint(std::filesystem::path const&,
                                               CoupledScene<double, ibm::Sharp>&, March&,
                                               std::string);

}  // namespace velum::cases
