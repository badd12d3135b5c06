#include "cases/app/test_stretch.hpp"

#include "core/check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace velum::cases {
namespace {

constexpr double largest_stretch = 20;  // no rubber goes farther; percent taken for a number does
constexpr double least_spread = 0.01;   // of the stretch

std::string at(TestColumns const& data, std::size_t row)
{
  return fmt::format("{}:{}", data.table.path.string(), data.table.lines[row]);
}

/// Every stretch is one.
void check_values(TestColumns const& data, TestColumn const& column,
                  std::vector<double> const& stretch)
{
  bool const strain = column.name == "strain";
  for (std::size_t row = 0; row < stretch.size(); ++row) {
    core::require(stretch[row] > 0,
                  fmt::format("{}: a stretch of {:.4g} in column \"{}\" is none: it is positive, "
                              "and 1 at rest{}.",
                              at(data, row), stretch[row], column.head,
                              strain ? "" : "; a strain goes in a column \"strain [%]\""));
    core::require(stretch[row] <= largest_stretch,
                  fmt::format("{}: a stretch of {:.4g} in column \"{}\" is beyond any rubber; if "
                              "it is in percent, write \"{} [%]\".",
                              at(data, row), stretch[row], column.head, column.name));
  }
}

/// They spread, along the way out alone: on the way back rubber is softer.
void check_way(TestColumns const& data, std::vector<double> const& stretch)
{
  auto const [least, most] = std::minmax_element(stretch.begin(), stretch.end());
  core::require(*most - *least >= least_spread,
                fmt::format("{}: the stretch goes from {:.4g} to {:.4g} only; a law takes a spread "
                            "of at least {:.2g}.",
                            data.table.path.string(), *least, *most, least_spread));
  double const way = *most - 1 >= 1 - *least ? 1 : -1;
  for (std::size_t row = 1; row < stretch.size(); ++row)
    core::require(way * (stretch[row] - stretch[row - 1]) >= 0,
                  fmt::format("{}: the stretch turns back, from {:.4g} to {:.4g}; give the loading "
                              "branch alone, sorted.",
                              at(data, row), stretch[row - 1], stretch[row]));
}

}  // namespace

std::vector<double> read_stretch(TestColumns const& data)
{
  auto const& column =
      one_of(data, {"stretch", "strain"}, "deformation: \"stretch\" or \"strain [%]\"");
  bool const strain = column.name == "strain";
  auto stretch = values(data, column, core::Dimension::dimensionless, strain ? "" : "1");
  if (strain)
    for (double& l : stretch) l += 1;
  check_values(data, column, stretch);
  check_way(data, stretch);
  return stretch;
}

}  // namespace velum::cases
