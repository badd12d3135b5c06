#pragma once
#include "contact/contact.hpp"

namespace velum::contact {

/// Where the markers touch and how hard.
struct Patch {
  int first = -1, last = -1;  ///< outermost markers in contact; -1: none
  double begin = 0, end = 0;  ///< the patch's edges between markers, in marker numbers: where
                              ///< lambda - k g, linear between markers, passes through zero
  double penetration = 0;     ///< largest, length; 0 where nothing penetrates
  double force = 0;           ///< sum of area x traction: the obstacle's normal force
  core::Vec2 resultant = {};  ///< sum of the force vectors on the markers
};

inline bool touches(Patch const& p) { return p.first >= 0; }

/// Patch of the present positions. Markers must be numbered along the body.
Patch contact_patch(Contact const& c, core::Markers const& markers);

}  // namespace velum::contact
