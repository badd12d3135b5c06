#include "lbm/lattice/d3q27.hpp"
#include "lbm/row_kernel.hpp"

namespace velum::lbm {

template void stream_and_collide(Fluid<double, D3Q27, double>&);

}  // namespace velum::lbm
