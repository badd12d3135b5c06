#include "structure/merge_sheets.hpp"

#include "core/check.hpp"

namespace velum::structure {
namespace {

Eigen::VectorXd joined(Eigen::VectorXd const& a, Eigen::VectorXd const& b)
{
  Eigen::VectorXd both(a.size() + b.size());
  both << a, b;
  return both;
}

}  // namespace

Sheet merge_sheets(Sheet const& first, Sheet const& second)
{
  core::require(first.material == second.material && first.density == second.density,
                "Sheets that are merged must have the same material and density; their thickness "
                "may differ.");
  Sheet s = first;
  int const nodes = node_count(first);
  for (auto const& [a, b, c] : second.triangles)
    s.triangles.push_back({a + nodes, b + nodes, c + nodes});
  s.reference = joined(first.reference, second.reference);
  s.position = joined(first.position, second.position);
  s.velocity = joined(first.velocity, second.velocity);
  s.thickness = joined(first.thickness, second.thickness);
  s.fixed.insert(s.fixed.end(), second.fixed.begin(), second.fixed.end());
  return s;
}

}  // namespace velum::structure
