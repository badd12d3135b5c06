#pragma once
#include <cstdint>

namespace velum::core {

/// The two real types of a fluid: Compute in registers, Storage in memory. 16-bit storage is fixed
/// point: a share of a range that the run chooses (lbm/populations.hpp).
template <class ComputeReal, class StorageReal>
struct Precision {
  using Compute = ComputeReal;
  using Storage = StorageReal;
};

using Double = Precision<double, double>;
using Single = Precision<float, float>;
using Half = Precision<float, std::int16_t>;

}  // namespace velum::core
