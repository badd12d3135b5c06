#include "cases/app/fit_warnings.hpp"

#include "cases/app/scene_words.hpp"
#include "structure/stress_kind.hpp"

#include <fmt/format.h>

namespace velum::cases {
namespace {

using structure::StressKind;

/// Residuals of a test as either kind of stress, where the other one fits far better.
void warn_of_kind(TestFile const& file, std::vector<std::string>& all)
{
  if (file.kind == "bulge" || !structure::looks_like_the_other_kind(file.test)) return;
  auto const misfit = *structure::misfit_by_kind(file.test);
  bool const as_true = file.test.kind == StressKind::true_;
  double const said = as_true ? misfit.true_ : misfit.engineering;
  double const other = as_true ? misfit.engineering : misfit.true_;
  all.push_back(fmt::format(
      "{}: its stresses look like {} stresses: taken so, rubber misses them by {:.2g} %, taken as "
      "{} ones by {:.2g} %. If they are, name the column \"{}\".",
      file.path.string(), as_true ? "engineering" : "true (Cauchy)", 100 * other,
      as_true ? "true" : "engineering", 100 * said,
      as_true ? "engineering_stress" : "true_stress"));
}

void warn_of_law(FittedLaw const& law, StretchRanges const& fitted, std::vector<std::string>& all)
{
  std::string ends;
  for (auto const& [mode, stretch] : failures(law, fitted))
    ends += fmt::format("{}in {} tension {} stretch {:.4g}", ends.empty() ? "" : ", ", word(mode),
                        stretch >= 1 ? "from" : "below", stretch);
  if (!ends.empty())
    all.push_back(
        fmt::format("{} is unstable by Drucker {}, within what was fitted: do not "
                    "use it there.",
                    word(law.fit.model), ends));
  if (parameters(law.fit.model) > 1 && fitted.size() == 1)
    all.push_back(fmt::format(
        "{} rests on {} alone: under other loads it may be off by far more than its intervals say, "
        "which take the law for right; {}.",
        word(law.fit.model), tests_in_words(fitted),
        fitted.contains(structure::TestMode::equibiaxial)
            ? "add a uniaxial test"
            : "a membrane is stretched both ways, so add an equibiaxial test or a bulge"));
}

}  // namespace

std::vector<std::string> warnings(FitStudy const& study)
{
  std::vector<std::string> all;
  for (auto const& file : study.files) warn_of_kind(file, all);
  for (auto const& law : study.laws) warn_of_law(law, study.fitted, all);
  return all;
}

}  // namespace velum::cases
