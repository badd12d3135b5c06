#pragma once
#include "cases/app/material_card.hpp"
#include "cases/app/test_data.hpp"
#include "structure/fit.hpp"

#include <string>
#include <vector>

namespace velum::cases {

/// A law fitted to tests, and what is to be known before it is used.
struct FittedLaw {
  structure::Fit fit;
  StretchRanges stable;                         // as far as searched_stretches
  std::map<structure::TestMode, double> known;  // 95 % of the stress lies within this share of it
};

/// Stability is looked for between these stretches.
inline constexpr structure::StretchRange searched_stretches{0.2, 10};

struct FitStudy {
  std::vector<TestFile> files;
  StretchRanges fitted;              // of the tests, by kind
  std::vector<FittedLaw> laws;       // that can be had
  std::vector<std::string> refused;  // a sentence for each that cannot
};

/// Fits the laws to all tests at once, with their points between two stretches.
/// @throws core::InputError  a test has no point there; none of the laws can be had
FitStudy fit_laws(std::vector<TestFile> files, std::vector<structure::FitModel> const& models,
                  structure::StretchRange const& between, structure::FitWeight weight);

/// Stretches at which a law has to hold in a test: from rest as far as that test was made, or,
/// where it was not, as far as draws the chains out like the others (the same I1).
structure::StretchRange claimed_range(StretchRanges const& fitted, structure::TestMode mode);

/// The tests in which a law is not stable over its claimed stretches, with the stretch at which it
/// fails.
std::map<structure::TestMode, double> failures(FittedLaw const& law, StretchRanges const& fitted);

}  // namespace velum::cases
