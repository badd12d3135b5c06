#include "cases/app/material_card.hpp"

#include "cases/app/scene_table.hpp"
#include "cases/app/scene_text.hpp"
#include "cases/app/scene_words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace velum::cases {
namespace {

StretchRanges read_ranges(SceneTable table)
{
  std::vector<std::string> names;
  for (auto const& [name, mode] : words(structure::TestMode{})) names.push_back(name);
  table.allow(names);
  StretchRanges ranges;
  for (auto const& [name, mode] : words(structure::TestMode{})) {
    if (!table.has(name)) continue;
    SceneTable range = table.table(name);
    range.allow({"from", "to"});
    for (std::string const key : {"from", "to"})
      if (!range.has(key)) range.fail(key, "is missing; it must be a stretch, such as 1.5.");
    ranges[mode] = {range.number("from", 1), range.number("to", 1)};
    if (ranges[mode].from > ranges[mode].to) range.fail("to", "must not be below \"from\".");
  }
  return ranges;
}

}  // namespace

MaterialCard read_card(std::filesystem::path const& file)
{
  toml::table const whole = parse_toml(file, "material card");
  Origins origins{.file = file.string(), .overridden = {}, .places = {}, .whole = "the card"};
  SceneTable root(whole, "", origins);
  std::vector<std::string> const names{"c10", "c01", "c20", "c11", "c02"};
  std::vector<std::string> keys{"model", "fitted", "stable", "confidence", "fit"};
  auto const with = [&](int count) {
    auto all = keys;
    all.insert(all.begin() + 1, names.begin(), names.begin() + count);
    return all;
  };
  root.allow(with(5));
  MaterialCard card{
      .model = root.choice<structure::FitModel>("model"), .rubber = {}, .fitted = {}, .stable = {}};
  int const count = structure::parameters(card.model);
  root.allow(with(count), fmt::format(" with model = \"{}\"", word(card.model)));
  auto& m = card.rubber;
  double* const coefficients[] = {&m.c10, &m.c01, &m.c20, &m.c11, &m.c02};
  for (int k = 0; k < count; ++k)
    *coefficients[k] = root.quantity(names[static_cast<std::size_t>(k)], core::Dimension::pressure);
  if (structure::shear_modulus(m) <= 0)
    root.fail("c10", fmt::format("gives a shear modulus at rest, 2 (c10 + c01), of {:.4g} MPa; it "
                                 "must be positive.",
                                 1e-6 * structure::shear_modulus(m)));
  if (!root.has("fitted"))
    root.fail("fitted",
              "is missing; it must say which stretches were fitted: "
              "[fitted.uniaxial] from = 1.0, to = 2.0.");
  card.fitted = read_ranges(root.table("fitted"));
  if (card.fitted.empty())
    root.fail("fitted", "is empty; it must have a table such as [fitted.uniaxial].");
  if (root.has("stable")) card.stable = read_ranges(root.table("stable"));
  return card;
}

double largest_stretch(StretchRanges const& fitted)
{
  double largest = 1;
  for (auto const& [mode, range] : fitted) largest = std::max(largest, range.to);
  return largest;
}

double largest_i1(StretchRanges const& fitted)
{
  double largest = 0;
  for (auto const& [mode, range] : fitted)
    for (double const l : {range.from, range.to})
      largest = std::max(largest, structure::test_invariants(mode, l).i1);
  return largest;
}

std::string tests_in_words(StretchRanges const& fitted)
{
  std::string all;
  std::size_t left = fitted.size();
  for (auto const& [mode, range] : fitted) {
    all += word(mode);
    --left;
    all += left > 1 ? ", " : left == 1 ? " and " : "";
  }
  return all + " tension";
}

}  // namespace velum::cases
