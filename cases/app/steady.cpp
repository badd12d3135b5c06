#include "cases/app/steady.hpp"

#include <cmath>

namespace velum::cases {

bool SteadyTest::passed(lbm::CellStates const& cells)
{
  std::vector<double> now;
  now.reserve(3 * cells.size());
  for (std::size_t j = 0; j < cells.extent(0); ++j)
    for (std::size_t i = 0; i < cells.extent(1); ++i) {
      now.push_back(cells(j, i).ux);
      now.push_back(cells(j, i).uy);
      now.push_back(cells(j, i).uz);
    }
  double changed = 0, whole = 0;
  for (std::size_t k = 0; k < before_.size(); ++k) {
    changed += (now[k] - before_[k]) * (now[k] - before_[k]);
    whole += now[k] * now[k];
  }
  if (!before_.empty() && whole > 0) change_ = std::sqrt(changed / whole);
  before_ = std::move(now);
  return change_ < limit_;
}

}  // namespace velum::cases
