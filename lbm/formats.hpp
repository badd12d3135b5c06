#pragma once
#include <cstdint>

#include "lbm/lattice/d2q9.hpp"
#include "lbm/lattice/d3q19.hpp"
#include "lbm/lattice/d3q27.hpp"

/// The fluids that velum is compiled for: calls the macro X(Real, L, Stored) for each. A file that
/// defines a function of any fluid instantiates it so.
#define VELUM_EACH_FLUID(X)     \
  X(double, D2Q9, double)       \
  X(float, D2Q9, float)         \
  X(float, D2Q9, std::int16_t)  \
  X(double, D3Q19, double)      \
  X(float, D3Q19, float)        \
  X(float, D3Q19, std::int16_t) \
  X(double, D3Q27, double)      \
  X(float, D3Q27, float)        \
  X(float, D3Q27, std::int16_t)
