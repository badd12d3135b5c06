#include "cases/app/fit_study.hpp"

#include "cases/app/scene_words.hpp"
#include "core/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace velum::cases {
namespace {

using structure::Fit;
using structure::MaterialTest;
using structure::StretchRange;
using structure::TestMode;

constexpr int looks = 20;  // stretches at which a stress is asked for its interval

void restrict_to(TestFile& file, StretchRange const& between)
{
  MaterialTest kept{file.test.mode, file.test.kind, {}, {}};
  for (std::size_t k = 0; k < file.test.stretch.size(); ++k) {
    double const l = file.test.stretch[k];
    if (l < between.from || l > between.to) continue;
    kept.stretch.push_back(l);
    kept.stress.push_back(file.test.stress[k]);
  }
  core::require(!kept.stretch.empty(),
                fmt::format("{}: has no point between the stretches {:.4g} and {:.4g}.",
                            file.path.string(), between.from, between.to));
  file.test = std::move(kept);
}

StretchRanges ranges(std::vector<TestFile> const& files)
{
  StretchRanges all;
  for (auto const& file : files) {
    auto const& l = file.test.stretch;
    auto const [least, most] = std::minmax_element(l.begin(), l.end());
    auto const [at, fresh] = all.try_emplace(file.test.mode, StretchRange{*least, *most});
    at->second = {std::min(at->second.from, *least), std::max(at->second.to, *most)};
  }
  return all;
}

/// Where an interval is widest against its stress.
struct Doubt {
  double share = 0, stretch = 1, stress = 0, half = 0;
};

Doubt doubt(Fit const& f, TestMode mode, StretchRange const& range)
{
  Doubt worst;
  for (double const end : {range.from, range.to})
    for (int k = 1; k <= looks && end != 1; ++k) {
      double const l = 1 + (end - 1) * k / looks;
      double const stress = engineering_stress(f.material, mode, l),
                   half = half_interval(f, mode, l);
      if (half / std::abs(stress) > worst.share) worst = {half / std::abs(stress), l, stress, half};
    }
  return worst;
}

FittedLaw fit_law(structure::FitModel model, std::vector<MaterialTest> const& tests,
                  StretchRanges const& fitted, structure::FitWeight weight)
{
  FittedLaw law{structure::fit(model, tests, weight), {}, {}};
  double const mu = shear_modulus(law.fit.material);
  core::require(mu > 0, fmt::format("the fit has a shear modulus of {:.3g} MPa at rest, which must "
                                    "be positive.",
                                    1e-6 * mu));
  for (auto const mode : structure::all_test_modes) {
    auto const worst = doubt(law.fit, mode, claimed_range(fitted, mode));
    core::require(worst.share < 1,
                  fmt::format("these tests leave the stress in {} tension unknown: at stretch "
                              "{:.4g} it is {:.2g} +- {:.2g} MPa; add a test of another kind, or "
                              "larger stretches.",
                              word(mode), worst.stretch, 1e-6 * worst.stress, 1e-6 * worst.half));
    law.known[mode] = worst.share;
    law.stable[mode] = structure::stable_range(law.fit.material, mode, searched_stretches);
  }
  return law;
}

}  // namespace

StretchRange claimed_range(StretchRanges const& fitted, TestMode mode)
{
  if (auto const own = fitted.find(mode); own != fitted.end())
    return {std::min(1.0, own->second.from), std::max(1.0, own->second.to)};
  double const i1 = largest_i1(fitted);
  double low = 1, high = 1 + std::sqrt(i1 + 3);  // I1 is at least the square of the stretch
  for (int k = 0; k < 60; ++k) {
    double const middle = (low + high) / 2;
    (structure::test_invariants(mode, middle).i1 < i1 ? low : high) = middle;
  }
  return {1, low};
}

std::map<TestMode, double> failures(FittedLaw const& law, StretchRanges const& fitted)
{
  std::map<TestMode, double> all;
  for (auto const& [mode, stable] : law.stable) {
    auto const claimed = claimed_range(fitted, mode);
    if (stable.to < claimed.to)
      all[mode] = stable.to;
    else if (stable.from > claimed.from)
      all[mode] = stable.from;
  }
  return all;
}

FitStudy fit_laws(std::vector<TestFile> files, std::vector<structure::FitModel> const& models,
                  StretchRange const& between, structure::FitWeight weight)
{
  FitStudy study{std::move(files), {}, {}, {}};
  std::vector<MaterialTest> tests;
  for (auto& file : study.files) {
    restrict_to(file, between);
    tests.push_back(file.test);
  }
  study.fitted = ranges(study.files);
  for (auto const model : models) try {
      study.laws.push_back(fit_law(model, tests, study.fitted, weight));
    } catch (core::InputError const& error) {
      study.refused.push_back(fmt::format("{}: {}", word(model), error.what()));
    }
  core::require(!study.laws.empty(), study.refused.empty() ? "" : study.refused.front());
  return study;
}

}  // namespace velum::cases
