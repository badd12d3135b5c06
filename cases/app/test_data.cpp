#include "cases/app/test_data.hpp"

#include "cases/app/scene_text.hpp"
#include "cases/app/test_columns.hpp"
#include "cases/app/test_stretch.hpp"
#include "core/check.hpp"
#include "core/spelling.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace velum::cases {
namespace {

using core::Dimension;
using structure::StressKind;
using structure::TestMode;

std::vector<std::string> const kinds{"uniaxial", "equibiaxial", "planar", "bulge"};
std::vector<std::string> const stresses{"engineering_stress", "true_stress", "stress"};

std::string name(TestColumns const& data) { return data.table.path.string(); }

std::string read_kind(TestColumns const& data)
{
  auto const found = data.remarks.find("test");
  std::string hint;
  for (auto const& [key, value] : data.remarks)
    if (hint.empty()) hint = core::nearest(key, {"test"}).empty() ? "" : " instead of # " + key;
  core::require(found != data.remarks.end(),
                fmt::format("{}: does not say what was tested; begin it with a line \"# test = "
                            "uniaxial\"{}; tests are {}.",
                            name(data), hint, core::any_of(kinds)));
  core::require(
      std::find(kinds.begin(), kinds.end(), found->second) != kinds.end(),
      fmt::format(
          "{}: \"# test = {}\" is no test{} Tests are {}.", name(data), found->second,
          did_you_mean(found->second, kinds).empty() ? "." : did_you_mean(found->second, kinds),
          core::any_of(kinds)));
  return found->second;
}

double read_thickness(TestColumns const& data)
{
  auto const found = data.remarks.find("thickness");
  core::require(found != data.remarks.end(),
                fmt::format("{}: a bulge needs the undeformed thickness: a line \"# thickness = "
                            "0.5 mm\".",
                            name(data)));
  double thickness = 0;
  try {
    thickness = core::parse_quantity(found->second, Dimension::length);
  } catch (core::InputError const& error) {
    throw core::InputError(fmt::format("{}: # thickness: {}", name(data), error.what()));
  }
  core::require(thickness > 0,
                fmt::format("{}: # thickness = {} is not positive.", name(data), found->second));
  return thickness;
}

/// True stress at the pole, a sphere of thickness H / l^2.
std::vector<double> pole_stress(TestColumns const& data, std::vector<double> const& stretch)
{
  double const H = read_thickness(data);
  auto const& pressure = one_of(data, {"pressure"}, "pressure: \"pressure [kPa]\"");
  auto const& radius = one_of(data, {"radius"}, "curvature: \"radius [mm]\"");
  auto const p = values(data, pressure, Dimension::pressure);
  auto const r = values(data, radius, Dimension::length);
  std::vector<double> stress;
  for (std::size_t k = 0; k < p.size(); ++k)
    stress.push_back(p[k] * r[k] * stretch[k] * stretch[k] / (2 * H));
  return stress;
}

TestMode mode_of(std::string const& kind)
{
  return kind == "uniaxial" ? TestMode::uniaxial
         : kind == "planar" ? TestMode::planar
                            : TestMode::equibiaxial;
}

void check_sign(TestColumns const& data, structure::MaterialTest const& test)
{
  double work = 0;
  for (std::size_t k = 0; k < test.stretch.size(); ++k)
    work += test.stress[k] * (test.stretch[k] - 1);
  core::require(work > 0,
                fmt::format("{}: the stress is compressive where the sheet is stretched, or zero "
                            "throughout; tension is positive.",
                            name(data)));
}

}  // namespace

TestFile read_test_file(std::filesystem::path const& path)
{
  auto const data = read_test_columns(path);
  TestFile file{path, read_kind(data), {}, true, {}};
  bool const bulge = file.kind == "bulge";
  auto& test = file.test;
  test.mode = mode_of(file.kind);
  test.stretch = read_stretch(data);
  if (bulge) {
    test.kind = StressKind::true_;
    test.stress = pole_stress(data, test.stretch);
  } else {
    auto const& column =
        one_of(data, stresses, "stress: \"engineering_stress [MPa]\" or \"true_stress [MPa]\"");
    test.kind = column.name == "true_stress" ? StressKind::true_ : StressKind::engineering;
    file.states_stress_kind = column.name != "stress";
    test.stress = values(data, column, Dimension::pressure);
  }
  check_sign(data, test);
  for (auto const& column : data.columns) {
    bool const known =
        column.name == "stretch" || column.name == "strain" ||
        (bulge ? column.name == "pressure" || column.name == "radius"
               : std::find(stresses.begin(), stresses.end(), column.name) != stresses.end());
    if (!known) file.ignored.push_back(column.head);
  }
  return file;
}

}  // namespace velum::cases
