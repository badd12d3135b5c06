#pragma once
#include "core/output/fields.hpp"

#include <string>
#include <vector>

namespace velum::tests {

/// A run to write: 5 x 3 cells whose pressure is 100 n + 10 j + i at dump n, and a membrane with
/// one wet face that move by a cell along the axis from dump to dump.
struct SampleRun {
  core::Grid grid{5, 3, 0.5, {-1, 0.25}, core::Symmetry::axisymmetric};

  std::vector<core::Field> fluid(int dump) const
  {
    std::vector<double> pressure;
    std::vector<float> density;
    std::vector<std::int32_t> label;
    std::vector<core::Vec2> velocity;
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i) {
        pressure.push_back(100 * dump + 10 * j + i);
        density.push_back(998.25f);
        label.push_back(i - 2);
        velocity.push_back({1.0 * i, -2.0 * j});
      }
    return {{"pressure", "Pa", 1, pressure},
            core::vector_field("velocity", "m/s", velocity),
            {"density", "kg/m3", 1, density},
            {"label", "1", 1, label}};
  }

  std::vector<core::Curve> bodies(int dump) const
  {
    double const x = 0.5 * dump;
    std::vector<core::Vec2> const middle = {{x, 0.25}, {x, 0.75}, {x + 0.1, 1.25}, {x, 1.75}};
    std::vector<core::Vec2> const face = {{x + 0.2, 0.25}, {x + 0.2, 1.75}};
    std::vector<double> const thickness = {1e-4, 2e-4, 3e-4, 4e-4};
    return {{"membrane", middle, {{"thickness", "m", 1, thickness}}}, {"membrane_face", face, {}}};
  }

  /// Writes the dumps 0 ... n-1 at the times 0, 0.001, ...
  core::FieldsFile write(std::filesystem::path const& folder, int n) const
  {
    auto file = core::create_fields(folder, grid, {{"outlet", "free of traction"}});
    for (int dump = 0; dump < n; ++dump)
      core::write_fields(file, 0.001 * dump, fluid(dump), bodies(dump));
    return file;
  }
};

}  // namespace velum::tests
