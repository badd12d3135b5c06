#pragma once
#include <Kokkos_Core.hpp>
#include <cstdint>
#include <vector>

namespace velum::lbm {

/// Cells along x, one after the other, that a step updates together.
struct Span {
  std::int32_t cell;    // the first
  std::int32_t length;  // a multiple of vector_cells on the host
  std::int32_t row;     // j, for the radius
};
using Spans = Kokkos::View<Span*>;

/// Spans are cut here: long enough for vectors and prefetching, short enough to share out.
constexpr int longest_span = 512;

/// Spans end on whole vectors: the cells without fluid that this adds are updated for nothing, and
/// without harm, because what arrives at a fluid cell from one without fluid is always written by a
/// wall, an opening or a body before it is read.
constexpr int vector_cells = 16;

/// The runs of fluid in a mask over the box, [nz][ny][nx], in the fewest vectors: one starts at
/// every cell with fluid that those before it have not covered.
/// Rows are `pitch` and planes `plane` cells apart, the first cell of the box is cell `first`.
Spans make_spans(std::vector<std::uint8_t> const& mask, int nx, int ny, int nz, int first,
                 int pitch, int plane);

}  // namespace velum::lbm
