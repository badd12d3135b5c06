#include "lbm/lattice/d3q19.hpp"
#include "lbm/row_kernel.hpp"

namespace velum::lbm {

template void stream_and_collide(Fluid<double, D3Q19, double>&);

}  // namespace velum::lbm
