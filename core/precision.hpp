#pragma once

namespace velum::core {

/// The two real types of a fluid: Compute in registers, Storage in memory.
template <class ComputeReal, class StorageReal>
struct Precision {
  using Compute = ComputeReal;
  using Storage = StorageReal;
};

using Double = Precision<double, double>;
using Single = Precision<float, float>;

}  // namespace velum::core
