#include "cases/app/network_columns.hpp"

namespace velum::cases {

std::vector<core::Column> valve_columns(Scene const& scene, std::vector<core::Column> const& own)
{
  std::vector<core::Column> columns = {{"pressure_above", "Pa"},  {"pressure_outside", "Pa"},
                                       {"pressure_inside", "Pa"}, {"centre", "m"},
                                       {"penetration", "m"},      {"seat_force", "N"}};
  columns.insert(columns.end(), own.begin(), own.end());
  for (auto const& c : scene.chambers) columns.push_back({"pressure_" + c.name, "Pa"});
  for (auto const& o : scene.orifices) {
    columns.push_back({"flow_" + o.name, "m3/s"});
    if (o.seat) columns.push_back({"lift_" + o.name, "m"});
  }
  if (scene.membrane->stop) columns.push_back({"stop_force", "N"});
  return columns;
}

void add_stop(std::vector<double>& row, std::optional<structure::LiftStop> const& stop,
              structure::Membrane const& membrane, Derived const& d)
{
  if (stop)
    row.push_back(core::to_si_force(d.units, membrane.symmetry,
                                    structure::stop_force(membrane, *stop, membrane.position)));
}

std::vector<double> network_row(ibm::Network const& network, NetworkKey const& key,
                                Scene const& scene, Derived const& d, double time)
{
  std::vector<double> row;
  for (std::size_t k = 0; k < scene.chambers.size(); ++k)
    row.push_back(core::to_si_pressure(d.units, network.chambers[k].pressure));
  for (std::size_t k = 0; k < scene.orifices.size(); ++k) {
    row.push_back(core::to_si_flow_rate(d.units, symmetry(scene), network.passages[k].flow));
    if (scene.orifices[k].seat) row.push_back(lift_at(scene.orifices[k], key.lift[k], time));
  }
  return row;
}

}  // namespace velum::cases
