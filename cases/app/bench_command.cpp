#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "cases/app/bandwidth.hpp"
#include "cases/app/commands.hpp"
#include "cases/app/scene_words.hpp"
#include "cases/app/time_steps.hpp"
#include "lbm/lattice/d3q19.hpp"
#include "lbm/lattice/d3q27.hpp"

namespace velum::cases {
namespace {

struct Row {
  std::string lattice, collision, precision;
  bool les;
  long cells;
  int bytes_per_update;
  double mlups;
  double ceiling;  // bytes per second in place over as many streams

  double share() const { return 1e6 * mlups * bytes_per_update / ceiling; }
};

/// The step and its ceiling in turn, for the speed of a shared machine drifts: medians of three.
template <class Real, class L, class Stored>
Row measure(std::string const& name, lbm::Model const& model, core::Symmetry symmetry, int n,
            Streams const& streams)
{
  auto fluid = lbm::make_fluid<Real, L, Stored>(n, n, {}, symmetry, model, L::D == 3 ? n : 1);
  std::array<double, 3> mlups, ceiling;
  for (std::size_t i = 0; i < mlups.size(); ++i) {
    mlups[i] = time_steps(fluid);
    ceiling[i] = streams.speed();
  }
  std::ranges::sort(mlups);
  std::ranges::sort(ceiling);
  std::string const precision = std::is_integral_v<Stored> ? "half"
                                : sizeof(Real) == 4        ? "single"
                                                           : "double";
  bool const round = symmetry == core::Symmetry::axisymmetric;
  return {fmt::format("d{}q{}{}", L::D, L::Q, round ? " axisymmetric" : ""),
          name,
          precision,
          model.smagorinsky > 0,
          fluid.cells(),
          2 * L::Q * int(sizeof(Stored)),
          mlups[1],
          ceiling[1]};
}

std::string json(Row const& r)
{
  return fmt::format(
      R"({{"lattice": "{}", "collision": "{}", "precision": "{}", "les": {}, "cells": {}, )"
      R"("bytes_per_update": {}, "mlups": {:.1f}, "ceiling": {:.4g}, "share_of_ceiling": {:.3f}}})",
      r.lattice, r.collision, r.precision, r.les, r.cells, r.bytes_per_update, r.mlups, r.ceiling,
      r.share());
}

std::string line(Row const& r)
{
  return fmt::format("{:18} {:22} {:7} {:4} {:>10} {:>6} {:>9.1f} {:>6.1f} {:>7.0f} %", r.lattice,
                     r.collision, r.precision, r.les ? "on" : "off", r.cells, r.bytes_per_update,
                     r.mlups, r.ceiling / 1e9, 100 * r.share());
}

}  // namespace

void bench_command(Options const& options)
{
  int const n = options.cells > 0 ? options.cells : 128;
  int const plane = static_cast<int>(std::lround(std::pow(n, 1.5)));
  auto const memory = measure_bandwidth(std::size_t(n) * n * n * 19 * sizeof(float));
  if (options.json)
    fmt::print(
        "{{\"threads\": {},\n \"bandwidth\": {{\"in_place\": {:.4g}, \"copy\": {:.4g}, "
        "\"triad\": {:.4g}, \"unit\": \"B/s\"}},\n \"runs\": [",
        Kokkos::DefaultExecutionSpace().concurrency(), memory.in_place, memory.copy, memory.triad);
  else
    fmt::print(
        "{} threads; memory moves {:.1f} GB/s in place, {:.1f} copying, {:.1f} as triad; GB/s: in "
        "place over as many streams\n"
        "lattice            collision              storage LES       cells  B/upd     MLUPS   GB/s "
        " of it\n",
        Kokkos::DefaultExecutionSpace().concurrency(), memory.in_place / 1e9, memory.copy / 1e9,
        memory.triad / 1e9);
  bool first = true;
  auto const show = [&](Row const& r) {
    if (options.json)
      fmt::print("{}\n  {}", first ? "" : ",", json(r));
    else
      fmt::print("{}\n", line(r));
    std::fflush(stdout);
    first = false;
  };
  auto const sweep = [&]<class Real, class L, class Stored>(int side) {
    double const cells = std::pow(side, L::D);
    Streams const streams(L::Q, static_cast<std::size_t>(cells) * sizeof(Stored));
    for (auto const& [name, collision] : words(lbm::Collision{})) {
      if (!lbm::is_defined(collision, L::Q)) continue;
      if (options.quick && collision != lbm::Collision::central_moments) continue;
      for (auto symmetry : {core::Symmetry::planar, core::Symmetry::axisymmetric})
        for (double constant : {0.0, 0.1}) {
          if (symmetry == core::Symmetry::axisymmetric && L::D == 3) continue;
          lbm::Model const model{
              .collision = collision, .viscosity = 1e-3, .smagorinsky = constant};
          show(measure<Real, L, Stored>(name, model, symmetry, side, streams));
        }
    }
  };
  auto const lattice = [&]<class L>(int side) {
    sweep.template operator()<double, L, double>(side);
    sweep.template operator()<float, L, float>(side);
    sweep.template operator()<float, L, std::int16_t>(side);
  };
  lattice.template operator()<lbm::D2Q9>(plane);
  lattice.template operator()<lbm::D3Q19>(n);
  lattice.template operator()<lbm::D3Q27>(n);
  if (options.json) fmt::print("\n ]}}\n");
}

}  // namespace velum::cases
