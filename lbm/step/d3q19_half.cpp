#include "lbm/lattice/d3q19.hpp"
#include "lbm/row_kernel.hpp"

namespace velum::lbm {

template void stream_and_collide(Fluid<float, D3Q19, std::int16_t>&);

}  // namespace velum::lbm
