#pragma once
#include "cases/app/scene_words.hpp"
#include "structure/scheme.hpp"
#include "structure/stable_step.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>

namespace velum::cases {

/// The scheme that a scene asks for, or the cheaper one; the sentence says both where they differ.
/// Arguments as in structure::choose_scheme().
inline structure::SchemeChoice chosen_scheme(std::optional<structure::TimeScheme> asked, double dt,
                                             double stable, double cost_ratio,
                                             std::string const& unit = "s")
{
  using structure::TimeScheme;
  auto own = structure::choose_scheme(dt, stable, cost_ratio, unit);
  if (!asked || *asked == own.scheme) return own;
  int const substeps = *asked == TimeScheme::implicit ? 1 : structure::substeps_for(dt, stable);
  std::string const count =
      *asked == TimeScheme::implicit
          ? ""
          : fmt::format(", {} sub-step{}", substeps, substeps == 1 ? "" : "s");
  return {*asked, substeps,
          fmt::format("{}, as the scene says{}; of itself: {}", word(*asked), count, own.sentence)};
}

}  // namespace velum::cases
