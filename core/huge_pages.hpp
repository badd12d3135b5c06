#pragma once
#include <cstddef>

namespace velum::core {

/// Asks the system to back memory that nobody has touched yet with large pages, so that the many
/// streams of a lattice do not wait for address translation. A hint: where the system knows no such
/// thing, or has been told not to, nothing happens.
void prefer_huge_pages(void* memory, std::size_t bytes);

}  // namespace velum::core
