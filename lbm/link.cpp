#include "lbm/link.hpp"

#include <algorithm>

namespace velum::lbm {

void upload(LinkList& list, std::vector<Link> const& links)
{
  list.size = static_cast<int>(links.size());
  if (links.size() > list.links.extent(0))
    list.links = Kokkos::View<Link*>("links", links.size() + links.size() / 4 + 64);
  if (links.empty()) return;
  auto const part = Kokkos::subview(list.links, std::make_pair(std::size_t{0}, links.size()));
  Kokkos::View<Link const*, Kokkos::HostSpace, Kokkos::MemoryUnmanaged> const host(links.data(),
                                                                                   links.size());
  Kokkos::deep_copy(part, host);
}

}  // namespace velum::lbm
