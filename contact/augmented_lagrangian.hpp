#pragma once
#include "contact/contact.hpp"

namespace velum::contact {

/// Uzawa's update of the multipliers after a solve or a step: lambda <- max(0, lambda - k g).
/// Afterwards the same gap gives the same traction with a smaller penetration at the next solve;
/// repeated, g -> 0 in contact, lambda -> 0 outside, lambda g = 0 everywhere.
/// Simo and Laursen, Comput. Struct. 42 (1992) 97, doi:10.1016/0045-7949(92)90540-G.
/// Returns the largest change, pressure. An empty multiplier counts as zero.
double update_multipliers(Contact& c, core::Markers const& markers);

/// Largest |lambda g| over the markers: zero where contact is exact.
double complementarity(Contact const& c, core::Markers const& markers);

}  // namespace velum::contact
