#include "structure/stress_kind.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace velum::structure {
namespace {

constexpr double gaussian_limit = 2.5;
constexpr int least_points = 5;
constexpr double clearly = 0.5;

/// Least relative residual over a c + b d, c and d not negative.
double residual(Eigen::VectorXd const& a, Eigen::VectorXd const& b, Eigen::VectorXd const& s)
{
  double const aa = a.dot(a), ab = a.dot(b), bb = b.dot(b), as = a.dot(s), bs = b.dot(s);
  double const one = (s - std::max(0.0, as / aa) * a).norm();
  double const two = (s - std::max(0.0, bs / bb) * b).norm();
  double best = std::min(one, two);
  double const det = aa * bb - ab * ab;
  if (det > 1e-12 * aa * bb) {
    double const c = (bb * as - ab * bs) / det, d = (aa * bs - ab * as) / det;
    if (c > 0 && d > 0) best = std::min(best, (s - c * a - d * b).norm());
  }
  return best / s.norm();
}

}  // namespace

std::optional<KindMisfit> misfit_by_kind(MaterialTest const& test)
{
  std::vector<std::size_t> used;
  for (std::size_t k = 0; k < test.stretch.size(); ++k)
    if (test.stretch[k] != 1 && test.stretch[k] <= gaussian_limit) used.push_back(k);
  if (used.size() < least_points) return {};
  auto const misfit = [&](StressKind kind) {
    auto const n = static_cast<Eigen::Index>(used.size());
    Eigen::VectorXd c10(n), equal(n), stress(n);
    for (Eigen::Index k = 0; k < n; ++k) {
      auto const point = used[static_cast<std::size_t>(k)];
      double const l = test.stretch[point];
      auto const terms = stress_terms(test.mode, l);
      c10[k] = per_engineering(kind, l) * terms[0];
      equal[k] = per_engineering(kind, l) * (terms[0] + terms[1]);
      stress[k] = test.stress[point];
    }
    return stress.norm() > 0 ? residual(c10, equal, stress) : 0;
  };
  return KindMisfit{misfit(StressKind::engineering), misfit(StressKind::true_)};
}

bool looks_like_the_other_kind(MaterialTest const& test)
{
  auto const misfit = misfit_by_kind(test);
  if (!misfit) return false;
  bool const said_true = test.kind == StressKind::true_;
  double const said = said_true ? misfit->true_ : misfit->engineering;
  double const other = said_true ? misfit->engineering : misfit->true_;
  return other < clearly * said;
}

}  // namespace velum::structure
