#pragma once
#include "structure/drucker.hpp"
#include "structure/fit.hpp"

#include <filesystem>
#include <map>
#include <string>

namespace velum::cases {

using StretchRanges = std::map<structure::TestMode, structure::StretchRange>;

/// A rubber as velum fit found it. A card is a TOML file:
///     model = "mooney_rivlin_2"     # or "neo_hookean", "mooney_rivlin_5"
///     c10 = "0.31 MPa"
///     c01 = "0.05 MPa"              # as many coefficients as the model has
///     [fitted.uniaxial]             # stretches of the tests, one table for each kind
///     from = 1.02
///     to = 2.5
///     [stable.uniaxial]             # Drucker's range of each kind; may be missing
///     [confidence]                  # half of the 95 % intervals; for readers
///     [fit]                         # points, residuals; for readers
struct MaterialCard {
  structure::FitModel model;
  structure::MooneyRivlin rubber;  // Pa
  StretchRanges fitted, stable;
};

/// @throws core::InputError  as for a scene; also where the rubber has no stiffness at rest
MaterialCard read_card(std::filesystem::path const& file);

/// The largest stretch of any test.
double largest_stretch(StretchRanges const& fitted);

/// The largest I1 - 3 of any test: how far the chains were drawn out, whichever way.
double largest_i1(StretchRanges const& fitted);

/// The kinds of test behind a card, "uniaxial and planar tension".
std::string tests_in_words(StretchRanges const& fitted);

}  // namespace velum::cases
