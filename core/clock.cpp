#include "core/clock.hpp"

#include <algorithm>
#include <cmath>

namespace velum::core {

std::int64_t steps_in(Clock const& clock, double interval)
{
  return std::max<std::int64_t>(1, std::llround(interval / clock.dt));
}

}  // namespace velum::core
