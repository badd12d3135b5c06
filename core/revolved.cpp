#include "core/revolved.hpp"

#include <cmath>
#include <utility>

namespace velum::core {

SignedDistance<3> revolved(Obstacle profile)
{
  return [profile = std::move(profile)](Vec3 const& p) {
    return distance(profile, {p[0], std::hypot(p[1], p[2])});
  };
}

}  // namespace velum::core
