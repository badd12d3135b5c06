#pragma once
#include "structure/material_test.hpp"

#include <Eigen/Core>

#include <vector>

namespace velum::structure {

/// Laws by their number of coefficients, the first so many of c10, c01, c20, c11, c02.
enum class FitModel { neo_hookean = 1, mooney_rivlin_2 = 2, mooney_rivlin_5 = 5 };
inline constexpr std::array all_fit_models{FitModel::neo_hookean, FitModel::mooney_rivlin_2,
                                           FitModel::mooney_rivlin_5};
constexpr int parameters(FitModel model) { return static_cast<int>(model); }

/// How much a point counts: all alike, or by its own stress, but none more than at a twentieth of
/// the largest of its test.
enum class FitWeight { alike, relative };

/// Coefficients that fit tests, and how well they are known. Stresses are compared as measured:
/// engineering with engineering, true with true.
struct Fit {
  FitModel model;
  MooneyRivlin material;
  Eigen::VectorXd coefficients;  ///< of the law          [p]
  Eigen::MatrixXd covariance;    ///< of the coefficients [p,p]
  int points;                    ///< away from rest
  double quantile;               ///< standard errors in half of a 95 % interval
  double rms;                    ///< of the residuals, sqrt(sum r^2 / (points - p))
  double relative_rms;           ///< the same over the rms of the stresses, or, with relative
                                 ///< weights, of the residuals each over its own stress
  double condition;              ///< of the columns, each scaled to 1
  double autocorrelation;        ///< of neighbouring residuals: near 0 for noise, near 1 for misfit
};

/// Linear least squares by Householder QR. The intervals hold for independent errors of one size
/// (with FitWeight::relative: of one share of the stress).
/// @throws InputError  too few points for the law, or tests that cannot tell its coefficients apart
Fit fit(FitModel model, std::vector<MaterialTest> const& tests,
        FitWeight weight = FitWeight::alike);

/// Half of the 95 % interval of a linear combination of the coefficients.
double half_interval(Fit const& f, Eigen::VectorXd const& combination);
/// Of coefficient k.
double half_interval(Fit const& f, int k);
/// Of the engineering stress in a test, measured or not.
double half_interval(Fit const& f, TestMode mode, double stretch);
/// Of the shear modulus at rest.
double half_interval_of_shear_modulus(Fit const& f);

/// True where the residuals follow each other as errors of measurement would not: the law, not the
/// noise, limits the fit, and the intervals are too narrow.
bool is_systematic(Fit const& f);

}  // namespace velum::structure
