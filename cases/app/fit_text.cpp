#include "cases/app/fit_text.hpp"

#include "cases/app/scene_words.hpp"
#include "cases/app/version.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace velum::cases {
namespace {

using structure::StressKind;
using structure::StretchRange;

constexpr char const* coefficient_names[] = {"c10", "c01", "c20", "c11", "c02"};

/// A unit for all stresses of a law.
struct Scale {
  double pascal;
  char const* name;
};

Scale scale_of(FittedLaw const& law)
{
  return shear_modulus(law.fit.material) < 0.1e6 ? Scale{1e3, "kPa"} : Scale{1e6, "MPa"};
}

/// "0.4730 +- 0.0021 MPa": two digits of the interval.
std::string with_interval(double value, double half, Scale const& scale)
{
  double const shown = half / scale.pascal;
  int const digits = shown > 0 ? std::clamp(1 - int(std::floor(std::log10(shown))), 0, 9) : 6;
  double const unit = std::pow(10.0, -digits);
  double const rounded = unit * std::round(value / scale.pascal / unit) + 0.0;  // no "-0.0"
  return fmt::format("{:.{}f} +- {:.{}f} {}", rounded, digits, shown, digits, scale.name);
}

std::string stress_in_words(TestFile const& file)
{
  if (file.kind == "bulge") return "true stress at the pole, p r l^2 / 2H";
  if (!file.states_stress_kind)
    return "taken as engineering stress (force per undeformed area): the header does not say which";
  return file.test.kind == StressKind::true_ ? "true stress" : "engineering stress";
}

std::string percent(double share) { return fmt::format("{:.2g} %", 100 * share); }

std::string stability_in_words(FittedLaw const& law)
{
  std::string limits;
  for (auto const mode : structure::all_test_modes) {
    auto const range = law.stable.at(mode);
    std::string ends;
    if (range.from > searched_stretches.from) ends = fmt::format("above {:.3f}", range.from);
    if (range.to < searched_stretches.to)
      ends += fmt::format("{}below {:.3f}", ends.empty() ? "" : " and ", range.to);
    if (!ends.empty())
      limits += fmt::format("{}{} {}", limits.empty() ? "" : ", ", word(mode), ends);
  }
  std::string const searched =
      fmt::format("from stretch {:g} to {:g}", searched_stretches.from, searched_stretches.to);
  return limits.empty() ? "in all three tests " + searched : limits + "; otherwise " + searched;
}

std::string range_table(std::string const& name, StretchRanges const& ranges)
{
  std::string text;
  for (auto const& [mode, range] : ranges)
    text += fmt::format("\n[{}.{}]\nfrom = {:.6g}\nto = {:.6g}\n", name, word(mode), range.from,
                        range.to);
  return text;
}

}  // namespace

std::string tests_text(FitStudy const& study)
{
  std::string text;
  for (auto const& file : study.files) {
    auto const& l = file.test.stretch;
    auto const [least, most] = std::minmax_element(l.begin(), l.end());
    text += fmt::format("{}: {}, {} points, stretch {:.4g} to {:.4g}, {}\n",
                        file.path.filename().string(), file.kind, l.size(), *least, *most,
                        stress_in_words(file));
    for (auto const& column : file.ignored)
      text += fmt::format("  column \"{}\" is left alone\n", column);
  }
  return text;
}

std::string law_text(FittedLaw const& law, StretchRanges const& fitted)
{
  auto const& f = law.fit;
  auto const scale = scale_of(law);
  std::string t = word(f.model) + '\n';
  auto const row = [&](std::string const& name, std::string const& value) {
    t += fmt::format("  {:<14} {}\n", name, value);
  };
  for (int k = 0; k < parameters(f.model); ++k)
    row(coefficient_names[k], with_interval(f.coefficients[k], half_interval(f, k), scale));
  row("shear modulus",
      with_interval(shear_modulus(f.material), half_interval_of_shear_modulus(f), scale));
  row("residuals",
      fmt::format("{:.3g} {}, {} of the stress, {}", f.rms / scale.pascal, scale.name,
                  percent(f.relative_rms),
                  is_systematic(f) ? "in runs of one sign: the law misses the shape of the data, "
                                     "and the intervals are too narrow"
                                   : "no runs of one sign"));
  std::string known, guessed;
  for (auto const mode : structure::all_test_modes) {
    auto& part = fitted.contains(mode) ? known : guessed;
    part +=
        fmt::format("{}{} {}", part.empty() ? "" : ", ", word(mode), percent(law.known.at(mode)));
  }
  if (!guessed.empty()) known += "; not tested, if the law is right: " + guessed;
  row("stress within", known);
  row("stable", stability_in_words(law));
  return t;
}

std::string card_text(FittedLaw const& law, FitStudy const& study)
{
  auto const& f = law.fit;
  std::string t = fmt::format("# Written by velum {} fit from", version());
  for (auto const& file : study.files) t += ' ' + file.path.filename().string();
  t += fmt::format(".\n# A scene takes it with card = \"{}.toml\" in its [material.<name>].\n",
                   word(f.model));
  t += fmt::format("model = \"{}\"\n", word(f.model));
  for (int k = 0; k < parameters(f.model); ++k)
    t += fmt::format("{} = \"{:.9g} MPa\"\n", coefficient_names[k], 1e-6 * f.coefficients[k]);
  t += range_table("fitted", study.fitted);
  if (!failures(law, study.fitted).empty()) t += "\n# Unstable by Drucker within what was fitted.";
  t += range_table("stable", law.stable);
  t += "\n[confidence]  # half of the 95 % intervals\n";
  for (int k = 0; k < parameters(f.model); ++k)
    t += fmt::format("{} = \"{:.3g} MPa\"\n", coefficient_names[k], 1e-6 * half_interval(f, k));
  t += fmt::format("shear_modulus = \"{:.3g} MPa\"  # of {:.6g} MPa\n",
                   1e-6 * half_interval_of_shear_modulus(f), 1e-6 * shear_modulus(f.material));
  t += fmt::format(
      "\n[fit]\npoints = {}\nrms = \"{:.4g} MPa\"\nrelative_rms = {:.4g}\n"
      "systematic = {}  # the law, not the noise, limits it\n",
      f.points, 1e-6 * f.rms, f.relative_rms, is_systematic(f));
  return t;
}

}  // namespace velum::cases
