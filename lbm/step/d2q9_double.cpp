#include "lbm/lattice/d2q9.hpp"
#include "lbm/row_kernel.hpp"

namespace velum::lbm {

template void stream_and_collide(Fluid<double, D2Q9, double>&);

}  // namespace velum::lbm
