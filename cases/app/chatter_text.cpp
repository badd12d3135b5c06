#include <fmt/format.h>

#include <limits>

#include "cases/app/chatter.hpp"

namespace velum::cases {
namespace {

bool oscillates(Chatter const& c)
{
  return c.kind != ChatterKind::too_short && c.kind != ChatterKind::none;
}

char const* kind_in_words(ChatterKind kind)
{
  switch (kind) {
    case ChatterKind::decaying:
      return "decaying oscillation";
    case ChatterKind::growing:
      return "growing oscillation";
    default:
      return "limit cycle";
  }
}

}  // namespace

std::vector<core::Figure> figures(Chatter const& c)
{
  bool const short_record = c.kind == ChatterKind::too_short;
  std::vector<core::Figure> f = {
      {"chatter_cycles", short_record ? std::numeric_limits<double>::quiet_NaN() : c.cycles, "1"}};
  if (!oscillates(c)) return f;
  f.insert(f.end(), {{"chatter_limit_cycle", c.kind == ChatterKind::limit_cycle ? 1.0 : 0.0, "1"},
                     {"chatter_onset", c.onset, "s"},
                     {"chatter_end", c.end, "s"},
                     {"chatter_frequency", c.frequency, "Hz"},
                     {"chatter_amplitude", c.amplitude, "m"},
                     {"chatter_amplitude_largest", c.largest, "m"},
                     {"chatter_rate", c.rate, "1/s"},
                     {"chatter_phase_pressure_gap", c.pressure_phase, "deg"},
                     {"chatter_phase_flow_gap", c.flow_phase, "deg"},
                     {"chatter_phase_flow_pressure", c.flow_pressure, "deg"},
                     {"chatter_contacts_per_cycle", c.contacts_per_cycle, "1"}});
  return f;
}

std::string chatter_text(Chatter const& c, ChatterRule const& rule)
{
  if (c.kind == ChatterKind::none)
    return fmt::format("Chatter: none above {:.3g} um\n", 1e6 * rule.threshold);
  if (c.kind == ChatterKind::too_short)
    return fmt::format(
        "Chatter: the record is too short to tell: {:g} cycles in it, {:g} are needed\n", c.cycles,
        rule.fewest_cycles);
  std::string t = fmt::format("Chatter: {}\n", kind_in_words(c.kind));
  auto const row = [&](std::string const& name, std::string const& value) {
    t += fmt::format("  {:<34} {}\n", name, value);
  };
  row("above " + fmt::format("{:.3g} um", 1e6 * rule.threshold),
      fmt::format("from {:.4g} to {:.4g} ms, {:g} cycles", 1e3 * c.onset, 1e3 * c.end, c.cycles));
  row("frequency", fmt::format("{:.4g} Hz", c.frequency));
  row("amplitude, peak to peak", fmt::format("{:.3g} um in the last cycles, {:.3g} um at most",
                                             1e6 * c.amplitude, 1e6 * c.largest));
  row("rate of its logarithm", fmt::format("{:+.3g} 1/s", c.rate));
  row("phase ahead of the gap", fmt::format("pressure difference {:+.0f} deg, flow {:+.0f} deg",
                                            c.pressure_phase, c.flow_phase));
  row("flow ahead of pressure difference", fmt::format("{:+.0f} deg", c.flow_pressure));
  row("contacts per cycle", fmt::format("{:.2f}", c.contacts_per_cycle));
  return t;
}

}  // namespace velum::cases
