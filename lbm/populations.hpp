#pragma once
#include <Kokkos_Core.hpp>
#include <cstdint>
#include <type_traits>

#include "lbm/lattice/lattice.hpp"

namespace velum::lbm {

/// A number from -1/2 to 1/2 by chance, of a cell in a step.
KOKKOS_FORCEINLINE_FUNCTION float dither(std::uint32_t cell, std::uint32_t step)
{
  std::uint32_t h = cell ^ (step * 0x9e3779b9u);
  h = (h ^ (h >> 16)) * 0x85ebca6bu;
  h = (h ^ (h >> 13)) * 0xc2b2ae35u;
  return float(std::int32_t(h ^ (h >> 16))) * 0x1p-32f;
}

/// Populations less their rest values, f_i - w_i, of all cells, stored once and streamed in place
/// (the AA pattern of Bailey, Myre, Walsh, Lilja & Saar, ICPP 2009, doi:10.1109/ICPP.2009.38).
///
/// Between steps every population stands in the slot of a cell and a direction. After an even
/// number of steps that of direction i on its way to cell c lies in slot (i, c):
/// it has arrived. After an odd number (turned()) it lies where its own cell left it, turned
/// round, in slot (opposite i, c - c_i). A step reads what arrives at a cell and writes what leaves
/// it into the very same slots, so no cell touches another's and one copy is enough. Who goes
/// through outgoing() and arriving() need not know which it is.
///
/// 16-bit storage holds  (f_i - w_i) / (w_i range)  as a fixed-point number in [-1, 1]. What a
/// collision leaves is rounded up or down at random, with the odds that make the mean right: a
/// force or a stress that changes a population by less than half a unit a step would have no effect
/// if it were always rounded to the nearest.
/// @tparam Real    in registers
/// @tparam Stored  in memory: Real, or std::int16_t
template <class Real, class L, class Stored>
struct Populations {
  Kokkos::View<Stored**, Kokkos::LayoutRight> slots;  // [Q][cells]
  int pitch = 0, plane = 0;  // cells from a row to the next, from a plane to the next
  std::uint32_t step = 0;    // number of the coming step
  float range = 1;           // of 16-bit storage

  KOKKOS_FORCEINLINE_FUNCTION bool turned() const { return step % 2 == 1; }

  static constexpr bool fixed_point = std::is_integral_v<Stored>;
  static constexpr std::int32_t largest = 32767;

  KOKKOS_FORCEINLINE_FUNCTION int shift(int dir) const
  {
    int s = L::c(dir, 0) + pitch * L::c(dir, 1);
    if constexpr (L::D == 3) s += plane * L::c(dir, 2);
    return s;
  }

  KOKKOS_FORCEINLINE_FUNCTION Real load(int slot, int cell) const
  {
    return from_stored(slots(slot, cell), unpack_scale(slot));
  }
  KOKKOS_FORCEINLINE_FUNCTION void store(int slot, int cell, Real value) const
  {
    slots(slot, cell) = to_stored(value, 1 / unpack_scale(slot));
  }

  /// Population that left the cell along dir in the last step.
  KOKKOS_FORCEINLINE_FUNCTION Real outgoing(int dir, int cell) const
  {
    return turned() ? load(L::opposite(dir), cell) : load(dir, cell + shift(dir));
  }
  KOKKOS_FORCEINLINE_FUNCTION void set_outgoing(int dir, int cell, Real value) const
  {
    turned() ? store(L::opposite(dir), cell, value) : store(dir, cell + shift(dir), value);
  }
  /// Population that arrives at the cell along dir in the coming step.
  KOKKOS_FORCEINLINE_FUNCTION Real arriving(int dir, int cell) const
  {
    return turned() ? load(L::opposite(dir), cell - shift(dir)) : load(dir, cell);
  }
  KOKKOS_FORCEINLINE_FUNCTION void set_arriving(int dir, int cell, Real value) const
  {
    turned() ? store(L::opposite(dir), cell - shift(dir), value) : store(dir, cell, value);
  }

  /// Factor between a stored number and the population; 1 where they are the same.
  KOKKOS_FORCEINLINE_FUNCTION Real unpack_scale(int slot) const
  {
    return fixed_point ? Real(range) * Real(L::w(slot)) / largest : Real(1);
  }
  KOKKOS_FORCEINLINE_FUNCTION static Real from_stored(Stored s, Real scale)
  {
    if constexpr (fixed_point) return scale * Real(std::int32_t(s));
    return Real(s);
  }
  /// @param dither  of this cell in this step; none rounds to the nearest
  KOKKOS_FORCEINLINE_FUNCTION static Stored to_stored(Real value, Real inverse_scale,
                                                      Real dither = 0)
  {
    if constexpr (fixed_point) {
      // The sum with 3/2 2^23 is the nearest whole number in its low bits, and what is too large
      // for it, or no number, is out of range there too: the guard finds what reaches the limit.
      constexpr Real shift = 3 << 22;
      auto const bits = __builtin_bit_cast(std::uint32_t, value * inverse_scale + dither + shift) -
                        __builtin_bit_cast(std::uint32_t, shift);
      auto const n = std::int32_t(bits);
      std::int32_t const low = n < largest ? n : largest;
      return Stored(low > -largest ? low : -largest);
    }
    return Stored(value);
  }
};

}  // namespace velum::lbm
