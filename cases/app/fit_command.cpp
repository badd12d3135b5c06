#include "cases/app/commands.hpp"
#include "cases/app/fit_study.hpp"
#include "cases/app/fit_text.hpp"
#include "cases/app/fit_warnings.hpp"
#include "cases/app/picture.hpp"
#include "cases/app/scene_words.hpp"
#include "core/check.hpp"
#include "core/output/folder.hpp"
#include "core/spelling.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace velum::cases {
namespace {

std::vector<structure::FitModel> models(std::string const& name)
{
  if (name.empty()) return {structure::all_fit_models.begin(), structure::all_fit_models.end()};
  std::vector<std::string> names;
  for (auto const& [known, model] : words(structure::FitModel{})) {
    if (known == name) return {model};
    names.push_back(known);
  }
  std::string const near = core::nearest(name, names);
  throw core::InputError(fmt::format(
      "--model: {} is not a law{} Laws: {}.", name,
      near.empty() ? "." : fmt::format("; did you mean \"{}\"?", near), core::any_of(names)));
}

}  // namespace

void fit_command(Options const& options)
{
  auto const wanted = models(options.model);
  core::require(options.from < options.to,
                fmt::format("--from {:g} is not below --to {:g}.", options.from, options.to));
  std::vector<TestFile> files;
  for (auto const& path : options.data) files.push_back(read_test_file(path));
  auto const study =
      fit_laws(std::move(files), wanted, {options.from, options.to},
               options.relative ? structure::FitWeight::relative : structure::FitWeight::alike);

  auto const out =
      core::make_folder(options.out.empty() ? std::filesystem::path("results") /
                                                  ("fit_" + options.data[0].stem().string())
                                            : options.out);
  core::write_atomically(out / "fit.csv", points_csv(study));
  core::write_atomically(out / "curves.csv", curves_csv(study));
  for (auto const& law : study.laws)
    core::write_atomically(out / (word(law.fit.model) + ".toml"), card_text(law, study));

  if (!options.quiet) {
    fmt::print("{}", tests_text(study));
    for (auto const& law : study.laws)
      fmt::print("\n{}  {:<14} {}\n", law_text(law, study.fitted), "card",
                 (out / (word(law.fit.model) + ".toml")).string());
    for (auto const& sentence : study.refused) fmt::print("\nno card for {}\n", sentence);
    fmt::print("\n{}\n", (out / "fit.csv").string());
    std::fflush(stdout);
  }
  for (auto const& sentence : warnings(study)) fmt::print(stderr, "warning: {}\n", sentence);
  draw("fit.py", out);
}

}  // namespace velum::cases
