#include "cases/app/dump.hpp"

#include "lbm/formats.hpp"

namespace velum::cases {

template <class Real, class L, class Stored>
std::vector<core::Field> fluid_fields(lbm::Fluid<Real, L, Stored> const& fluid,
                                      core::Units const& units)
{
  auto const cells = lbm::cell_states(fluid);
  auto const active = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), fluid.active);
  std::vector<float> pressure, density;
  std::vector<core::Vec<double, L::D>> velocity;
  std::vector<std::int32_t> side;
  for (int row = 0; row < fluid.nz * fluid.ny; ++row)
    for (int i = 0; i < fluid.nx; ++i) {
      auto const& c = cells(row, i);
      double const u[] = {c.ux, c.uy, c.uz};
      pressure.push_back(float(core::to_si_pressure(units, c.rho / 3)));
      density.push_back(float(core::to_si_density(units, 1 + c.rho)));
      auto& v = velocity.emplace_back();
      for (int a = 0; a < L::D; ++a) v[a] = core::to_si_velocity(units, u[a]);
      side.push_back(active(fluid.cell(i, row % fluid.ny, row / fluid.ny)));
    }
  return {{"pressure", "Pa", 1, pressure},
          {"density", "kg/m3", 1, density},
          core::vector_field("velocity", "m/s", velocity),
          {"side", "1", 1, side}};
}

template <class Real, template <class> class Body>
std::vector<core::Curve> membrane_curves(CoupledScene<Real, Body> const& s)
{
  auto const& units = s.derived.units;
  auto const& membrane = s.state.membrane;
  auto const& faces = s.state.body.surface.faces;
  auto const metres = [&](std::vector<core::Vec2> points) {
    for (auto& p : points) p = units.dx * p;
    return points;
  };
  std::vector<core::Vec2> middle, velocity;
  std::vector<double> thickness;
  for (int a = 0; a < structure::node_count(membrane); ++a) {
    middle.push_back(structure::node(membrane.position, a));
    velocity.push_back((units.dx / units.dt) * structure::node(membrane.velocity, a));
    thickness.push_back(units.dx * faces.thickness[static_cast<std::size_t>(a)]);
  }
  auto const face_pressure = [&](int side) {
    std::vector<double> p = s.state.pressure.p[side];
    p.resize(middle.size(), 0);
    for (double& value : p) value = core::to_si_pressure(units, value);
    return core::Field{"pressure", "Pa", 1, p};
  };
  return {{"membrane",
           metres(middle),
           {core::vector_field("velocity", "m/s", velocity), {"thickness", "m", 1, thickness}}},
          {"plus_face", metres(faces.plus), {face_pressure(0)}},
          {"minus_face", metres(faces.minus), {face_pressure(1)}}};
}

#define VELUM_INSTANTIATE(Real, L, Stored)                                                \
  template std::vector<core::Field> fluid_fields(lbm::Fluid<Real, lbm::L, Stored> const&, \
                                                 core::Units const&);
VELUM_EACH_FLUID(VELUM_INSTANTIATE)
#undef VELUM_INSTANTIATE

template std::vector<core::Curve> membrane_curves(CoupledScene<float, ibm::Sharp> const&);
template std::vector<core::Curve> membrane_curves(CoupledScene<double, ibm::Sharp> const&);
template std::vector<core::Curve> membrane_curves(CoupledScene<float, ibm::Diffuse> const&);
template std::vector<core::Curve> membrane_curves(CoupledScene<double, ibm::Diffuse> const&);

}  // namespace velum::cases
