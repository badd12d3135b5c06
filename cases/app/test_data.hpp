#pragma once
#include "structure/material_test.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace velum::cases {

/// A file of one material test, read.
struct TestFile {
  std::filesystem::path path;
  std::string kind;                  // "uniaxial", "equibiaxial", "planar" or "bulge"
  structure::MaterialTest test;      // Pa
  bool states_stress_kind;           // or takes the default, engineering
  std::vector<std::string> ignored;  // columns
};

/// Reads comma-separated values under a header of names with units, such as
///     # test = uniaxial
///     stretch, engineering_stress [MPa]
///     1.05, 0.134
/// The test is "uniaxial", "equibiaxial", "planar" or "bulge". Deformation is `stretch` or
/// `strain [%]` (engineering strain; `strain [1]` as a plain number). Stress is
/// `engineering_stress`, `true_stress` or plain `stress`, which is engineering. A bulge has
/// `pressure` and the `radius` of curvature at its pole instead and a line
///     # thickness = 0.5 mm
/// of the undeformed sheet; the true stress there is p r l^2 / 2H, equibiaxial. Other columns are
/// left alone.
/// @throws core::InputError  file, line, what is wrong and what is allowed: also where the stretch
///     turns back, does not spread or is not positive, or the stress has the wrong sign
TestFile read_test_file(std::filesystem::path const& path);

}  // namespace velum::cases
