#include "cases/app/csv_text.hpp"
#include "cases/app/fit_text.hpp"
#include "cases/app/scene_words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace velum::cases {

std::string points_csv(FitStudy const& study)
{
  std::string text = "file,test,stretch [1],engineering_stress [Pa]";
  for (auto const& law : study.laws) text += fmt::format(",{} [Pa]", word(law.fit.model));
  text += '\n';
  for (auto const& file : study.files) {
    auto const& test = file.test;
    for (std::size_t k = 0; k < test.stretch.size(); ++k) {
      double const l = test.stretch[k];
      text += fmt::format("{},{},{:.8g},{:.8g}", csv_cell(file.path.filename().string()),
                          word(test.mode), l, test.stress[k] / per_engineering(test.kind, l));
      for (auto const& law : study.laws)
        text += fmt::format(",{:.8g}", engineering_stress(law.fit.material, test.mode, l));
      text += '\n';
    }
  }
  return text;
}

std::string curves_csv(FitStudy const& study)
{
  constexpr int points = 80;
  std::string text =
      "test,model,stretch [1],engineering_stress [Pa],half_interval [Pa],stable [1]\n";
  for (auto const mode : structure::all_test_modes) {
    auto const range = claimed_range(study.fitted, mode);
    for (auto const& law : study.laws)
      for (int k = 0; k <= points; ++k) {
        double const l = range.from + (range.to - range.from) * k / points;
        auto const stable = law.stable.at(mode);
        text += fmt::format("{},{},{:.8g},{:.8g},{:.4g},{}\n", word(mode), word(law.fit.model), l,
                            engineering_stress(law.fit.material, mode, l),
                            half_interval(law.fit, mode, l),
                            l >= stable.from && l <= stable.to ? 1 : 0);
      }
  }
  return text;
}

}  // namespace velum::cases
