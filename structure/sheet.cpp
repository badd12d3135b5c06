#include "structure/sheet.hpp"

#include "core/check.hpp"
#include "structure/triangle_element.hpp"

#include <fmt/format.h>

namespace velum::structure {

Sheet make_sheet(TriangleMesh const& mesh, double thickness, MooneyRivlin const& material,
                 double density)
{
  core::require(thickness > 0,
                fmt::format("The thickness of a sheet is {}; it must be above 0.", thickness));
  core::require(shear_modulus(material) > 0,
                fmt::format("The shear modulus of a sheet at rest, 2 (c10 + c01), is {}; it must "
                            "be above 0.",
                            shear_modulus(material)));
  core::require(density > 0,
                fmt::format("The density of a sheet is {}; it must be above 0.", density));
  Sheet s{
      .triangles = mesh.triangles,
      .reference = mesh.points,
      .position = mesh.points,
      .velocity = Eigen::VectorXd::Zero(mesh.points.size()),
      .thickness = Eigen::VectorXd::Constant(static_cast<int>(mesh.triangles.size()), thickness),
      .material = material,
      .density = density,
      .fixed = std::vector<char>(static_cast<std::size_t>(mesh.points.size()), 0)};
  for (int e = 0; e < element_count(s); ++e)
    core::require(triangle_shape(s, e).area > 0,
                  fmt::format("Triangle {} of a sheet has no area.", e));
  return s;
}

void clamp(Sheet& s, int node)
{
  for (int i = 0; i < 3; ++i) s.fixed[static_cast<std::size_t>(3 * node + i)] = 1;
}

}  // namespace velum::structure
