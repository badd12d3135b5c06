#pragma once
#include "core/check.hpp"
#include "core/host_access.hpp"
#include "lbm/bgk.hpp"
#include "lbm/central_moment.hpp"
#include "lbm/collide.hpp"
#include "lbm/cumulant.hpp"
#include "lbm/fluid.hpp"
#include "lbm/recursive_regularised.hpp"
#include "lbm/trt.hpp"

/// The kernel of a step, included by the files that compile it for one lattice and precision each.
namespace velum::lbm {

namespace detail {

using Space = Kokkos::DefaultExecutionSpace;

/// How far ahead of the work, in bytes, cells are prefetched, a vector at a time: beyond the caches
/// the slots of all directions are as many streams of memory, more than a processor follows by
/// itself.
constexpr int prefetch_ahead = 512;

constexpr int team_size = 128;  // threads that share a span on a GPU

/// What the kernel may have beside the populations.
enum class With { nothing, eddy, eddy_and_force };

/// Slots of a span: population i arrives in slot[i], and in place of it leaves the opposite one.
template <class Real, class L, class Stored, With with>
struct Row {
  Stored* slot[L::Q];
  Real unpack[L::Q], pack[L::Q];  // of 16-bit storage
  Real const* force[L::D];
  Real const* eddy;
  std::uint32_t first, step;  // number of the first cell, of the step

  KOKKOS_FORCEINLINE_FUNCTION Row(Fluid<Real, L, Stored> const& fluid, int cell)
      : first(std::uint32_t(cell)), step(fluid.f.step)
  {
    auto const& f = fluid.f;
    core::static_for<L::Q>([&](auto direction) __attribute__((always_inline)) {
      constexpr int i = direction, o = L::opposite(direction);
      slot[i] = f.turned() ? &f.slots(o, cell) - f.shift(i) : &f.slots(i, cell);
      unpack[i] = f.unpack_scale(i);
      pack[i] = 1 / unpack[i];
    });
    for (int a = 0; a < L::D; ++a)
      force[a] = with == With::eddy_and_force ? &fluid.force(a, cell) : nullptr;
    eddy = with == With::nothing ? nullptr : &fluid.eddy_share(cell);
  }

  /// The same cells from number `from` on, their populations in a buffer.
  template <int cells>
  Row(Row<Real, L, std::int16_t, with> const& packed, int from, Real (&buffer)[L::Q][cells])
      : first(packed.first + std::uint32_t(from)), step(packed.step)
  {
    core::static_for<L::Q>([&](auto i) __attribute__((always_inline)) {
      slot[i] = buffer[i];
      unpack[i] = pack[i] = 1;
    });
    for (int a = 0; a < L::D; ++a) force[a] = packed.force[a] + from;
    eddy = packed.eddy + from;
  }
};

/// One cell of a row: gather, collide, scatter.
template <bool Axisymmetric, With with, class Real, class L, class Stored, class Rule>
KOKKOS_FORCEINLINE_FUNCTION void update_cell(Row<Real, L, Stored, with> const& row, int x,
                                             Rule const& rule, Surroundings<Real, L::D> around)
{
  using P = Populations<Real, L, Stored>;
  Real f[L::Q];
  core::static_for<L::Q>([&](auto i) __attribute__((always_inline)) {
    f[i] = P::from_stored(row.slot[i][x], row.unpack[i]);
  });
  if constexpr (with == With::eddy_and_force)
    core::static_for<L::D>([&](auto a) __attribute__((always_inline)) {
      around.force[a] += row.force[a][x];
    });
  if constexpr (with != With::nothing) around.smagorinsky_squared *= row.eddy[x];
  collide<L, Axisymmetric, with != With::nothing, with == With::eddy_and_force>(f, rule, around);
  Real chance = 0;
  if constexpr (P::fixed_point) chance = dither(row.first + std::uint32_t(x), row.step);
  core::static_for<L::Q>([&](auto i) __attribute__((always_inline)) {
    row.slot[L::opposite(i)][x] = P::to_stored(f[i], row.pack[i], chance);
  });
}

template <class L, class Row>
KOKKOS_FORCEINLINE_FUNCTION void prefetch(Row const& row, int x)
{
  core::static_for<L::Q>([&](auto i) __attribute__((always_inline)) {
    auto const* p = reinterpret_cast<char const*>(row.slot[i] + x) + prefetch_ahead;
    constexpr int bytes = vector_cells * int(sizeof(*row.slot[0]));
    for (int line = 0; line < bytes; line += 64) __builtin_prefetch(p + line, 1, 3);
  });
}

/// A span, vector by vector. Everything is inlined (flatten), and what comes by reference is copied
/// to the stack: calls, and what a store might alias, keep a loop from being vectorised.
template <bool Axisymmetric, With with, class Real, class L, class Stored, class Rule>
[[gnu::flatten]] inline void update_span(Row<Real, L, Stored, with> const& row, int length,
                                         bool ahead, Rule const& rule,
                                         Surroundings<Real, L::D> const& around)
{
  Row<Real, L, Stored, with> const r = row;
  Rule const k = rule;
  Surroundings<Real, L::D> const a = around;
  for (int from = 0; from < length; from += vector_cells) {
    if (ahead) prefetch<L>(r, from);
#pragma GCC ivdep
    for (int x = from; x < from + vector_cells; ++x) update_cell<Axisymmetric, with>(r, x, k, a);
  }
}

/// A span of 16-bit storage, a few vectors at a time unpacked into a buffer, updated, and packed
/// again: in one loop the two widths of number would need twice the registers there are.
template <bool Axisymmetric, With with, class Real, class L, class Rule>
[[gnu::flatten]] inline void update_span(Row<Real, L, std::int16_t, with> const& row, int length,
                                         bool ahead, Rule const& rule,
                                         Surroundings<Real, L::D> const& around)
{
  using P = Populations<Real, L, std::int16_t>;
  constexpr int most = 4 * vector_cells;
  alignas(64) Real buffer[L::Q][most], chance[most];
  for (int from = 0; from < length; from += most) {
    int const cells = length - from < most ? length - from : most;
    for (int i = 0; i < L::Q; ++i) {
      std::int16_t const* const slot = row.slot[i] + from;
      Real const scale = row.unpack[i];
      for (int x = 0; x < cells; ++x) buffer[i][x] = P::from_stored(slot[x], scale);
    }
    Row<Real, L, Real, with> const unpacked(row, from, buffer);
    update_span<Axisymmetric, with, Real, L, Real>(unpacked, cells, false, rule, around);
    for (int x = 0; x < cells; ++x)
      chance[x] = dither(row.first + std::uint32_t(from + x), row.step);
    for (int i = 0; i < L::Q; ++i) {
      std::int16_t* const slot = row.slot[i] + from;
      Real const scale = row.pack[i];
      for (int x = 0; x < cells; ++x) slot[x] = P::to_stored(buffer[i][x], scale, chance[x]);
      if (ahead)
        for (int x = 0; x < cells; x += 32)
          __builtin_prefetch(slot + x + prefetch_ahead / int(sizeof(*slot)), 1, 3);
    }
  }
}

/// One thread takes a span; the loop over it is vectorised.
template <bool Axisymmetric, With with, class Real, class L, class Stored, class Rule>
void update_on_host(Fluid<Real, L, Stored> const& fluid, Rule const& rule,
                    Surroundings<Real, L::D> const& constant)
{
  auto const spans = fluid.spans;
  double const y0 = fluid.origin[1];
  // beyond the caches only: within them prefetching costs a little and brings nothing
  bool const ahead = fluid.f.slots.size() * sizeof(Stored) > (32u << 20);
  Kokkos::parallel_for("velum::lbm::update_spans", Kokkos::RangePolicy<Space>(0, spans.extent(0)),
                       [=](int s) {
                         Span const span = spans(s);
                         Row<Real, L, Stored, with> const row(fluid, span.cell);
                         Surroundings<Real, L::D> around = constant;
                         around.inv_y = Axisymmetric ? Real(1 / (y0 + span.row + 0.5)) : Real(0);
                         update_span<Axisymmetric, with>(row, span.length, ahead, rule, around);
                       });
}

/// A team of threads takes a span, each thread a cell: neighbours read neighbouring addresses.
template <bool Axisymmetric, With with, class Real, class L, class Stored, class Rule>
void update_on_device(Fluid<Real, L, Stored> const& fluid, Rule const& rule,
                      Surroundings<Real, L::D> const& constant)
{
  using Team = Kokkos::TeamPolicy<Space>;
  auto const spans = fluid.spans;
  double const y0 = fluid.origin[1];
  Fluid<Real, L, Stored> const copy = fluid;
  Kokkos::parallel_for(
      "velum::lbm::update_teams", Team(static_cast<int>(spans.extent(0)), team_size),
      KOKKOS_LAMBDA(typename Team::member_type const& team) {
        Span const span = spans(team.league_rank());
        Surroundings<Real, L::D> around = constant;
        around.inv_y = Axisymmetric ? Real(1 / (y0 + span.row + 0.5)) : Real(0);
        Row<Real, L, Stored, with> const row(copy, span.cell);
        Kokkos::parallel_for(Kokkos::TeamThreadRange(team, span.length),
                             [&](int x) { update_cell<Axisymmetric, with>(row, x, rule, around); });
      });
}

template <bool Axisymmetric, With with, class Real, class L, class Stored, class Rule>
void update(Fluid<Real, L, Stored> const& fluid, Rule const& rule)
{
  Surroundings<Real, L::D> constant;
  for (int a = 0; a < L::D; ++a) constant.force[a] = Real(fluid.model.body_force[a]);
  constant.smagorinsky_squared = Real(fluid.model.smagorinsky * fluid.model.smagorinsky);
  if constexpr (core::on_host)
    update_on_host<Axisymmetric, with>(fluid, rule, constant);
  else
    update_on_device<Axisymmetric, with>(fluid, rule, constant);
}

template <bool Axisymmetric, class Real, class L, class Stored, class Rule>
void update_with(Fluid<Real, L, Stored> const& fluid, Rule const& rule)
{
  if (fluid.force.extent(0) > 0) return update<Axisymmetric, With::eddy_and_force>(fluid, rule);
  core::require(core::norm(fluid.model.body_force) == 0, "A body force needs use_force_field().");
  if (fluid.model.smagorinsky * fluid.model.smagorinsky > 0)
    return update<Axisymmetric, With::eddy>(fluid, rule);
  update<Axisymmetric, With::nothing>(fluid, rule);
}

template <class Real, class L, class Stored, class Rule>
void update_rule(Fluid<Real, L, Stored> const& fluid, Rule const& rule)
{
  if constexpr (L::D == 2)
    if (fluid.symmetry == core::Symmetry::axisymmetric) return update_with<true>(fluid, rule);
  update_with<false>(fluid, rule);
}

}  // namespace detail

template <class Real, class L, class Stored>
void stream_and_collide(Fluid<Real, L, Stored>& fluid)
{
  Real const omega = Real(fluid.model.omega());
  switch (fluid.model.collision) {
    case Collision::bgk:
      detail::update_rule(fluid, Bgk<Real>{omega});
      break;
    case Collision::trt:
      detail::update_rule(fluid, Trt<Real>{omega, Real(fluid.model.magic)});
      break;
    case Collision::recursive_regularised:
      detail::update_rule(fluid, RecursiveRegularised<Real>{omega});
      break;
    case Collision::cumulant:
      if constexpr (is_defined(Collision::cumulant, L::Q))
        detail::update_rule(fluid, Cumulant<Real>{omega});
      else
        throw core::InputError("The cumulant collision needs the lattice d3q27.");
      break;
    case Collision::central_moments:
      detail::update_rule(fluid, CentralMoment<Real>{omega, Real(fluid.model.magic)});
      break;
  }
  ++fluid.f.step;
}

}  // namespace velum::lbm
