#include "cases/app/driven_record.hpp"

#include <fmt/format.h>

#include <cmath>

namespace velum::cases {
namespace {

double largest(double a, double b) { return std::abs(b) > std::abs(a) ? b : a; }

double displacement_error(DrivenRecord const& r) { return r.misfit / std::abs(r.swept); }

}  // namespace

DrivenRecord start_record(Measurement const& m)
{
  DrivenRecord record;
  record.start = m.centre;
  record.volume_start = m.volume_inside;
  record.mass_start = m.mass_inside;
  return record;
}

void note(DrivenRecord& r, Measurement const& m)
{
  r.lift = largest(r.lift, m.centre - r.start);
  r.swept = largest(r.swept, m.volume_inside - r.volume_start);
  r.misfit = std::max(r.misfit, std::abs(m.inflow - m.outflow - (m.mass_inside - r.mass_start)));
}

std::vector<core::Figure> figures(DrivenRecord const& r)
{
  return {{"centre_displacement", r.lift, "m"},
          {"swept_volume", r.swept, "m3"},
          {"displaced_volume_error", displacement_error(r), "1"},
          {"shape_error", r.static_shape, "1"}};
}

std::string record_text(DrivenRecord const& r)
{
  return fmt::format(
      "Membrane driven in its middle\n"
      "  largest lift of the middle         {:.4f} mm\n"
      "  largest volume swept               {:.4f} mm3\n"
      "  fluid displaced against it         {:.3g} % off at most\n"
      "  volume swept against that at rest  {:+.3g} % at the end\n",
      1e3 * r.lift, 1e9 * r.swept, 100 * displacement_error(r), 100 * r.static_shape);
}

}  // namespace velum::cases
