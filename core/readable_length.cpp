#include "core/readable_length.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace velum::core {

LengthUnit readable_unit(double metres)
{
  // Half a unit of the fourth digit below the step: what is written as 1000 belongs above it.
  double const size = std::abs(metres) * (1 + 0.5e-4);
  if (size >= 1) return {1, "m"};
  if (size >= 1e-3 || size == 0) return {1e-3, "mm"};
  if (size >= 1e-6) return {1e-6, "um"};
  return {1e-9, "nm"};
}

std::string readable_length(double metres)
{
  auto const unit = readable_unit(metres);
  return fmt::format("{:.4g} {}", metres / unit.metres, unit.name);
}

std::string readable_place(double x, double y, double z)
{
  auto const unit = readable_unit(std::max({std::abs(x), std::abs(y), std::abs(z)}));
  auto const in_unit = [&](double metres) {
    return std::abs(metres) < 1e-9 * unit.metres ? 0.0 : metres / unit.metres;
  };
  return fmt::format("({:.4g}, {:.4g}, {:.4g}) {}", in_unit(x), in_unit(y), in_unit(z), unit.name);
}

}  // namespace velum::core
