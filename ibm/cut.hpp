#pragma once
#include "ibm/surface.hpp"

namespace velum::ibm {

/// Where a link meets a face.
struct Hit {
  double q = 0.5;  // share of the link
  int first = 0;   // nodes that carry the place, and the share of the second
  int second = 0;
  double share = 0;
  bool found = false;
};

/// Segments of a face sorted into lattice rows, so that a link looks at a few only.
struct FaceIndex {
  double origin_y = 0;
  std::vector<int> first, last;  // per row: range of segments that come within one row of it
};

void sort_into_rows(FaceIndex& index, FaceLine const& face, double origin_y, int ny);

/// First place where the link from p along c meets the face. The labels have decided that the link
/// is cut; should round-off hide the place, q = 1/2 and the nearest segment stand in for it.
Hit cut(FaceLine const& face, FaceIndex const& index, core::Vec2 p, core::Vec2 c);

/// Distance of p from the face.
double distance(FaceLine const& face, FaceIndex const& index, core::Vec2 p);

}  // namespace velum::ibm
