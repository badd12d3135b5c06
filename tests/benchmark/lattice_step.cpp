// MLUPS of the lattice step per collision and precision, and of the coupled step of a small valve.
// Compare rows of one run with one another; the rate of a shared machine is no constant.
#include <benchmark/benchmark.h>

#include "tests/support/piston.hpp"

namespace velum {
namespace {

template <class Real>
void lattice_step(benchmark::State& state, lbm::Collision collision, core::Symmetry symmetry)
{
  int const n = static_cast<int>(state.range(0));
  auto fluid = lbm::make_fluid<Real>(n, n, {0, 0}, symmetry, {collision, 1e-3, 1.0 / 8});
  for (auto _ : state) {
    lbm::stream_and_collide(fluid);
    Kokkos::fence();
  }
  double const updates = double(state.iterations()) * n * n;
  state.counters["MLUPS"] = benchmark::Counter(1e-6 * updates, benchmark::Counter::kIsRate);
}

void coupled_step(benchmark::State& state)
{
  int const n = static_cast<int>(state.range(0));
  auto scene = tests::make_piston({.nx = n,
                                   .ny = n,
                                   .symmetry = core::Symmetry::axisymmetric,
                                   .place = 0.6 * n,
                                   .thickness = 4});
  for (auto _ : state) {
    ibm::step(scene);
    Kokkos::fence();
  }
  double const updates = double(state.iterations()) * n * n;
  state.counters["MLUPS"] = benchmark::Counter(1e-6 * updates, benchmark::Counter::kIsRate);
}

void add_lattice_steps()
{
  struct Named {
    char const* name;
    lbm::Collision collision;
  };
  for (auto const& [name, collision] : {Named{"bgk", lbm::Collision::bgk},
                                        Named{"trt", lbm::Collision::trt},
                                        Named{"central_moments", lbm::Collision::central_moments}})
    for (auto symmetry : {core::Symmetry::planar, core::Symmetry::axisymmetric}) {
      auto const title = [&, n = name](char const* real) {
        return std::string("lattice_step/") + n +
               (symmetry == core::Symmetry::planar ? "/planar/" : "/axisymmetric/") + real;
      };
      benchmark::RegisterBenchmark(title("double").c_str(), lattice_step<double>, collision,
                                   symmetry)
          ->Arg(256)
          ->Arg(1024)
          ->UseRealTime();
      benchmark::RegisterBenchmark(title("single").c_str(), lattice_step<float>, collision,
                                   symmetry)
          ->Arg(256)
          ->Arg(1024)
          ->UseRealTime();
    }
  benchmark::RegisterBenchmark("coupled_step/sharp/axisymmetric/double", coupled_step)
      ->Arg(100)
      ->UseRealTime();
}

}  // namespace
}  // namespace velum

int main(int argc, char** argv)
{
  Kokkos::ScopeGuard const kokkos(argc, argv);
  velum::add_lattice_steps();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
}
