#include "structure/fit.hpp"

#include "core/check.hpp"
#include "structure/student_t.hpp"

#include <fmt/format.h>
#include <Eigen/QR>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace velum::structure {
namespace {

constexpr double confidence = 0.95;
constexpr double worst_condition = 1e8;  // beyond it round-off decides
constexpr double least_share = 0.05;     // of the largest stress, for relative weights

/// The points of all tests, a row each; points at rest say nothing and are left out.
struct Rows {
  Eigen::MatrixXd terms;    // [n,p]
  Eigen::VectorXd stress;   // [n]
  Eigen::VectorXd weight;   // [n]
  std::vector<char> first;  // 1: of its test
};

Rows rows(int p, std::vector<MaterialTest> const& tests, FitWeight weight)
{
  std::size_t most = 0;
  for (auto const& test : tests) most += test.stretch.size();
  auto const size = static_cast<Eigen::Index>(most);
  Rows r{Eigen::MatrixXd(size, p), Eigen::VectorXd(size), Eigen::VectorXd(size), {}};
  Eigen::Index n = 0;
  for (auto const& test : tests) {
    double largest = 0;
    for (double const s : test.stress) largest = std::max(largest, std::abs(s));
    bool first = true;
    for (std::size_t k = 0; k < test.stretch.size(); ++k) {
      double const l = test.stretch[k], s = test.stress[k];
      if (l == 1) continue;
      auto const terms = stress_terms(test.mode, l);
      for (int j = 0; j < p; ++j)
        r.terms(n, j) = per_engineering(test.kind, l) * terms[static_cast<std::size_t>(j)];
      r.stress[n] = s;
      r.weight[n] =
          weight == FitWeight::alike ? 1 : 1 / std::max(std::abs(s), least_share * largest);
      r.first.push_back(first ? 1 : 0);
      first = false;
      ++n;
    }
  }
  r.terms.conservativeResize(n, p);
  r.stress.conservativeResize(n);
  r.weight.conservativeResize(n);
  return r;
}

MooneyRivlin material_of(Eigen::VectorXd const& c)
{
  auto const at = [&](int k) { return k < c.size() ? c[k] : 0; };
  return {at(0), at(1), at(2), at(3), at(4)};
}

/// Correlation of weighted residuals with the next one of the same test.
double neighbours(Eigen::VectorXd const& residual, std::vector<char> const& first)
{
  double sum = 0;
  for (Eigen::Index k = 1; k < residual.size(); ++k)
    if (!first[static_cast<std::size_t>(k)]) sum += residual[k] * residual[k - 1];
  double const all = residual.squaredNorm();
  return all > 0 ? sum / all : 0;
}

}  // namespace

Fit fit(FitModel model, std::vector<MaterialTest> const& tests, FitWeight weight)
{
  int const p = parameters(model);
  Rows const r = rows(p, tests, weight);
  int const n = static_cast<int>(r.stress.size());
  core::require(
      n > p, fmt::format("{} point{} away from rest {} too few for {} parameter{}; it "
                         "takes at least {}.",
                         n, n == 1 ? "" : "s", n == 1 ? "is" : "are", p, p == 1 ? "" : "s", p + 1));

  Eigen::MatrixXd A = r.weight.asDiagonal() * r.terms;
  Eigen::VectorXd const scale = A.colwise().norm().cwiseInverse();
  A = A * scale.asDiagonal();
  Eigen::VectorXd const b = r.weight.cwiseProduct(r.stress);
  Eigen::VectorXd const singular = Eigen::JacobiSVD<Eigen::MatrixXd>(A).singularValues();
  double const condition = singular[p - 1] > 0 ? singular[0] / singular[p - 1] : INFINITY;
  core::require(condition < worst_condition,
                fmt::format("these tests cannot tell its {} parameters apart; add a test of "
                            "another kind or of larger stretches.",
                            p));

  Eigen::HouseholderQR<Eigen::MatrixXd> const qr(A);
  Eigen::VectorXd const c = qr.solve(b);
  Eigen::VectorXd const residual = b - A * c;
  Eigen::MatrixXd const R = qr.matrixQR().topRows(p).triangularView<Eigen::Upper>();
  Eigen::MatrixXd const inverse =
      R.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(p, p));
  double const freedom = n - p;

  Fit f;
  f.model = model;
  f.coefficients = scale.cwiseProduct(c);
  f.material = material_of(f.coefficients);
  f.covariance = residual.squaredNorm() / freedom * scale.asDiagonal() * inverse *
                 inverse.transpose() * scale.asDiagonal();
  f.points = n;
  f.quantile = student_quantile(n - p, confidence);
  f.rms = std::sqrt((r.stress - r.terms * f.coefficients).squaredNorm() / freedom);
  f.relative_rms = weight == FitWeight::alike ? f.rms / std::sqrt(r.stress.squaredNorm() / n)
                                              : std::sqrt(residual.squaredNorm() / freedom);
  f.condition = condition;
  f.autocorrelation = neighbours(residual, r.first);
  return f;
}

double half_interval(Fit const& f, Eigen::VectorXd const& combination)
{
  return f.quantile * std::sqrt(std::max(0.0, combination.dot(f.covariance * combination)));
}

double half_interval(Fit const& f, int k)
{
  return half_interval(f, Eigen::VectorXd::Unit(f.coefficients.size(), k));
}

double half_interval(Fit const& f, TestMode mode, double stretch)
{
  auto const terms = stress_terms(mode, stretch);
  Eigen::VectorXd combination(f.coefficients.size());
  for (Eigen::Index k = 0; k < combination.size(); ++k)
    combination[k] = terms[static_cast<std::size_t>(k)];
  return half_interval(f, combination);
}

double half_interval_of_shear_modulus(Fit const& f)
{
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(f.coefficients.size());
  sum.head(std::min<Eigen::Index>(2, sum.size())).setConstant(2);
  return half_interval(f, sum);
}

bool is_systematic(Fit const& f)
{
  // the residuals of white noise are a little apart from each other, by p / n
  double const expected = -double(f.coefficients.size()) / f.points;
  return f.autocorrelation > expected + 2 / std::sqrt(f.points) && f.relative_rms > 1e-9;
}

}  // namespace velum::structure
