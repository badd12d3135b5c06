#include "lbm/spans.hpp"

#include "core/host_access.hpp"

#include <algorithm>

namespace velum::lbm {

Spans make_spans(std::vector<std::uint8_t> const& mask, int nx, int ny, int nz, int first,
                 int pitch, int plane)
{
  constexpr int vector = core::on_host ? vector_cells : 1;
  std::vector<Span> spans;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j) {
      auto const* row = &mask[(static_cast<std::size_t>(k) * ny + j) * nx];
      int const start = first + k * plane + j * pitch;
      for (int i = 0; i < nx;) {
        if (!row[i]) {
          ++i;
          continue;
        }
        int end = i;
        while (end < nx && row[end]) end += vector;
        for (; i < end; i += longest_span)
          spans.push_back({start + i, std::min(longest_span, end - i), j});
        i = end;
      }
    }
  Spans list("spans", spans.size());
  Kokkos::View<Span const*, Kokkos::HostSpace, Kokkos::MemoryUnmanaged> const host(spans.data(),
                                                                                   spans.size());
  if (!spans.empty()) Kokkos::deep_copy(list, host);
  return list;
}

}  // namespace velum::lbm
