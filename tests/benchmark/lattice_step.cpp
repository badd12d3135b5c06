// MLUPS of the lattice step per lattice, collision, storage and eddy viscosity, and of the coupled
// step of a small valve. Compare rows of one run with one another; the rate of a shared machine is
// no constant.
#include <benchmark/benchmark.h>

#include "lbm/formats.hpp"
#include "tests/support/piston.hpp"

namespace velum {
namespace {

template <class Real, class L, class Stored>
void lattice_step(benchmark::State& state, lbm::Model const& model, core::Symmetry symmetry)
{
  int const n = static_cast<int>(state.range(0));
  auto fluid = lbm::make_fluid<Real, L, Stored>(n, n, {}, symmetry, model, L::D == 3 ? n : 1);
  for (auto _ : state) {
    lbm::stream_and_collide(fluid);
    Kokkos::fence();
  }
  double const updates = double(state.iterations()) * double(fluid.cells());
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

struct Named {
  char const* name;
  lbm::Collision collision;
};
constexpr Named collisions[] = {{"bgk", lbm::Collision::bgk},
                                {"trt", lbm::Collision::trt},
                                {"recursive_regularised", lbm::Collision::recursive_regularised},
                                {"central_moments", lbm::Collision::central_moments},
                                {"cumulant", lbm::Collision::cumulant}};

template <class Real, class L, class Stored>
void add_lattice_steps(std::string const& lattice, core::Symmetry symmetry, char const* storage,
                       std::vector<std::int64_t> const& sides)
{
  for (auto const& [name, collision] : collisions)
    for (double constant : {0.0, 0.1}) {
      if (!lbm::is_defined(collision, L::Q)) continue;
      lbm::Model const model{.collision = collision, .viscosity = 1e-3, .smagorinsky = constant};
      std::string const title =
          "lattice_step/" + lattice + "/" + name + "/" + storage + (constant > 0 ? "/les" : "");
      auto* const b = benchmark::RegisterBenchmark(title.c_str(), lattice_step<Real, L, Stored>,
                                                   model, symmetry);
      for (std::int64_t side : sides) b->Arg(side);
      b->UseRealTime();
    }
}

template <class L>
void add_storages(std::string const& lattice, core::Symmetry symmetry,
                  std::vector<std::int64_t> const& sides)
{
  add_lattice_steps<double, L, double>(lattice, symmetry, "double", sides);
  add_lattice_steps<float, L, float>(lattice, symmetry, "single", sides);
  add_lattice_steps<float, L, std::int16_t>(lattice, symmetry, "half", sides);
}

void add_all()
{
  add_storages<lbm::D2Q9>("d2q9/planar", core::Symmetry::planar, {256, 1024});
  add_storages<lbm::D2Q9>("d2q9/axisymmetric", core::Symmetry::axisymmetric, {256, 1024});
  add_storages<lbm::D3Q19>("d3q19", core::Symmetry::planar, {64, 128});
  add_storages<lbm::D3Q27>("d3q27", core::Symmetry::planar, {64, 128});
  benchmark::RegisterBenchmark("coupled_step/sharp/axisymmetric/double", coupled_step)
      ->Arg(100)
      ->UseRealTime();
}

}  // namespace
}  // namespace velum

int main(int argc, char** argv)
{
  Kokkos::ScopeGuard const kokkos(argc, argv);
  velum::add_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
}
