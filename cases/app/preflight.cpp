#include "cases/app/preflight.hpp"

#include "cases/app/scene_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace velum::cases {

std::string fidelity_advice(Scene const& scene)
{
  if (symmetry(scene) == core::Symmetry::none)
    return "3d as asked for; axisymmetric or planar, where the scene allows it, costs a hundredth.";
  if (symmetry(scene) == core::Symmetry::planar)
    return "planar: the scene is a plane of unit depth.";
  if (!scene.membrane)
    return "axisymmetric: without a membrane there is nothing for hydrostatic to solve.";
  if (find_chamber(scene, ChamberSide::above) && scene.contact)
    return "lumped, for pressures, lift and flow of a seat whose gap is left to its closure: no "
           "lattice, and 5 % from the finest one's flow in a tenth of its time "
           "(cases/valve_on_off, its chart); axisymmetric for the flow around it; hydrostatic, if "
           "only the closed equilibrium is wanted.";
  bool const steady =
      std::all_of(scene.boundaries.begin(), scene.boundaries.end(), [](Boundary const& b) {
        return is_constant(b.value) && b.kind != BoundaryKind::velocity &&
               b.kind != BoundaryKind::flow_rate;
      });
  if (!steady || scene.membrane->centre)
    return "axisymmetric: boundaries or membrane move in time, so the flow has to be marched.";
  if (!scene.contact)
    return "axisymmetric: without a contact the membrane cannot seal, and fluid may pass it.";
  return "hydrostatic, if only the closed equilibrium is wanted: pressures are constant and the "
         "membrane can seal on its seat (seconds, no fluid); axisymmetric for leak, settling and "
         "the shut inlet.";
}

std::string table(std::vector<Row> const& rows)
{
  constexpr std::array<char const*, 4> verdicts{"", "ok", "warn", "RED"};
  std::size_t width = 0, unit_width = 0;
  for (auto const& row : rows) {
    width = std::max(width, row.name.size());
    unit_width = std::max(unit_width, row.unit.size());
  }
  std::string text;
  for (auto const& row : rows) {
    std::string line =
        fmt::format("  {:<{}}  {:>10.4g} {:<{}}  {:<4}  {}", row.name, width, row.value, row.unit,
                    unit_width, verdicts[static_cast<std::size_t>(row.verdict)], row.remark);
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

}  // namespace velum::cases
