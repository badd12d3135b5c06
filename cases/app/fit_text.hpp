#pragma once
#include "cases/app/fit_study.hpp"

#include <string>

namespace velum::cases {

/// A line for each test: kind, points, stretches, which stress.
std::string tests_text(FitStudy const& study);

/// A law for people.
std::string law_text(FittedLaw const& law, StretchRanges const& fitted);

/// The material card of a law, as read_card() reads it.
std::string card_text(FittedLaw const& law, FitStudy const& study);

/// fit.csv: each point and what the laws say there, engineering stress.
std::string points_csv(FitStudy const& study);

/// curves.csv: each law over the stretch in all three tests, with its interval and its stability.
std::string curves_csv(FitStudy const& study);

}  // namespace velum::cases
