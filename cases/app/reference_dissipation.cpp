#include <algorithm>
#include <cmath>

#include "cases/app/derived.hpp"
#include "cases/app/reference.hpp"

namespace velum::cases {

std::vector<core::Figure> compare_dissipation(ReferenceData const& data, Result const& r)
{
  auto const& reference = *r.scene.reference;
  double const L = reference.length, U = flow_velocity(r.scene);
  auto const& time = r.history.time;
  auto const energy = r.history.column(reference.energy + "_kinetic_energy");
  double peak = 0, at = 0;
  for (std::size_t k = 2; k < energy.size(); ++k) {
    double const rate = (energy[k - 2] - energy[k]) / (time[k] - time[k - 2]);
    if (rate > peak) {
      peak = rate;
      at = time[k - 1];
    }
  }
  std::vector<core::Figure> figures = {{"dissipation_peak", peak * L / (U * U * U), "1"},
                                       {"dissipation_time", at * U / L, "1"}};
  auto const errors = errors_of(data, figures);
  figures.insert(figures.end(), errors.begin(), errors.end());
  return figures;
}

}  // namespace velum::cases
