#include "lbm/lattice/d2q9.hpp"
#include "lbm/row_kernel.hpp"

namespace velum::lbm {

template void stream_and_collide(Fluid<float, D2Q9, float>&);

}  // namespace velum::lbm
