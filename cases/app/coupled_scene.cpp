#include "cases/app/coupled_scene.hpp"

#include "cases/app/geometry.hpp"
#include "ibm/sharp.hpp"

namespace velum::cases {

namespace {

ibm::SeatGapCells seat_gap_cells(Scene const& scene, HydrostaticScene const& start)
{
  if (scene.gap.cells == 0 || !start.seat) return {};
  return {start.seat->contact.obstacle, scene.gap.cells};
}

template <class Real>
auto make_body(std::type_identity<ibm::Sharp<Real>>, LatticeScene<Real>& l,
               structure::Membrane const& membrane, double divide, bool dry_plus,
               ibm::SeatGapCells const& gap)
{
  return ibm::make_sharp(l.fluid, l.walls, l.wall_hits, membrane, divide, dry_plus, gap);
}

template <class Real>
auto make_body(std::type_identity<ibm::Diffuse<Real>>, LatticeScene<Real>& l,
               structure::Membrane const& membrane, double divide, bool, ibm::SeatGapCells const&)
{
  return ibm::make_diffuse(l.fluid, l.walls, l.wall_hits, membrane, divide);
}

/// The passage that stands for the gap of the seat, and the openings at its edges.
template <class Real, template <class> class Body>
void add_gap(CoupledScene<Real, Body>& s, Scene const& scene, ibm::Chambers& c)
{
  ibm::GapFlow gap{
      {{1, s.derived.viscosity}, scene.gap.discharge, scene.gap.seals_at / s.derived.units.dx},
      static_cast<int>(c.network.passages.size()),
      {}};
  auto const first = static_cast<int>(c.network.ports.size());
  for (int side : {0, 1}) {
    lbm::Opening edge;
    edge.kind = lbm::OpeningKind::flow_rate;
    edge.normal = {0, side == 0 ? 1.0 : -1.0, 0};
    gap.opening[side] = s.state.openings.size();
    s.state.openings.push_back(edge);
    s.boundary.push_back("");
    c.ports.push_back({{gap.opening[side]}, first + side, true});
    c.network.ports.push_back({});
  }
  auto const node = static_cast<int>(c.network.chambers.size()) + first;
  c.network.passages.push_back({node, node + 1, std::nullopt});
  c.gap = gap;
}

/// The network of the scene, its ports tied to the openings of their boundaries.
template <class Real, template <class> class Body>
void add_chambers(CoupledScene<Real, Body>& s, Scene const& scene)
{
  auto made = make_network(scene, s.derived);
  ibm::Chambers c;
  c.network = std::move(made.network);
  c.above = made.key.above;
  s.key = std::move(made.key);
  for (std::size_t b = 0; b < scene.boundaries.size(); ++b) {
    if (scene.boundaries[b].kind != BoundaryKind::port) continue;
    ibm::LatticePort port{{}, static_cast<int>(b)};
    for (std::size_t k = 0; k < s.boundary.size(); ++k)
      if (s.boundary[k] == scene.boundaries[b].name) port.openings.push_back(k);
    c.ports.push_back(std::move(port));
  }
  if (scene.gap.cells > 0) add_gap(s, scene, c);
  fill(c.network);
  s.state.chambers = std::move(c);
}

/// Pressure of the first opening that faces each zone, lattice units.
template <class Real, template <class> class Body>
void fill_at_rest(CoupledScene<Real, Body>& s, std::vector<PatchOpening> const& openings)
{
  auto& fluid = s.state.fluid;
  auto const active = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), fluid.active);
  double pressure[4] = {};
  bool known[4] = {};
  for (std::size_t k = 0; k < openings.size(); ++k) {
    auto const kind = openings[k].opening.kind;
    if (kind == lbm::OpeningKind::velocity || kind == lbm::OpeningKind::flow_rate) continue;
    lbm::Link const& l = openings[k].links.front();
    auto const z = static_cast<int>(s.zone(active(fluid.cell(l.i, l.j)), l.j));
    if (!known[z]) pressure[z] = s.state.targets[k];
    known[z] = true;
  }
  lbm::CellStates state("rest", fluid.ny, fluid.nx);
  for (int j = 0; j < fluid.ny; ++j)
    for (int i = 0; i < fluid.nx; ++i) {
      auto const z = static_cast<int>(s.zone(active(fluid.cell(i, j)), j));
      state(j, i) = {3 * pressure[z], 0, 0};
    }
  lbm::set_equilibrium(fluid, state);
}

}  // namespace

template <class Real, template <class> class Body>
CoupledScene<Real, Body> make_coupled_scene(Scene const& scene, HydrostaticScene const& hydrostatic,
                                            double smagorinsky)
{
  auto lattice = make_lattice_scene<Real>(scene, smagorinsky);
  CoupledScene<Real, Body> s;
  s.derived = lattice.derived;
  if (contact::touches(hydrostatic.report.patch)) {
    auto const& patch = hydrostatic.report.patch;
    // where the face touches, not the mid-surface: on a rounded edge they lie well apart
    structure::Faces faces;
    structure::locate_faces(hydrostatic.membrane, hydrostatic.membrane.position, 1.0, faces);
    double const middle = (patch.begin + patch.end) / 2;
    auto const a = std::min(static_cast<std::size_t>(middle), faces.minus.size() - 2);
    s.divide =
        faces.minus[a][1] + (middle - double(a)) * (faces.minus[a + 1][1] - faces.minus[a][1]);
  }
  auto& state = s.state;
  state.membrane = hydrostatic.membrane;
  state.body = make_body(std::type_identity<Body<Real>>{}, lattice, state.membrane, s.divide,
                         find_chamber(scene, ChamberSide::above) != nullptr,
                         seat_gap_cells(scene, hydrostatic));
  state.fluid = lattice.fluid;
  state.loads = hydrostatic.loads;
  state.seat = hydrostatic.seat;
  if (state.seat) state.loads.push_back(ibm::contact_load(state.seat));
  state.walls = core::transformed(all_solids(scene), 1 / lattice.derived.units.dx, {0, 0});
  state.pressure.lip = hydrostatic.load.lip;
  state.substeps = hydrostatic.substeps;
  state.scheme = scene.coupling.scheme == CouplingScheme::implicit ? ibm::Scheme::implicit
                                                                   : ibm::Scheme::explicit_;
  state.stepper = membrane_stepper(scene, s.derived, hydrostatic);
  state.one_way = scene.coupling.feedback == Feedback::one_way;
  s.driven = hydrostatic.driven;
  s.stop = hydrostatic.stop;
  for (PatchOpening const& o : lattice.openings) {
    state.openings.push_back(o.opening);
    s.boundary.push_back(o.boundary);
  }
  if (!scene.chambers.empty() || scene.gap.cells > 0) add_chambers(s, scene);
  set_targets(s, scene, 0, false);
  // the state at rest carries the targets already: the controls have nothing to correct yet
  for (std::size_t k = 0; k < state.openings.size(); ++k)
    state.openings[k].traction = state.openings[k].last_traction = state.openings[k].pressure =
        state.targets[k];
  fill_at_rest(s, lattice.openings);
  return s;
}

template <class Real, template <class> class Body>
void set_targets(CoupledScene<Real, Body>& s, Scene const& scene, double time, bool shut)
{
  s.state.targets.resize(s.state.openings.size());
  for (std::size_t k = 0; k < s.state.openings.size(); ++k) {
    if (s.boundary[k].empty()) continue;  // an edge of the gap
    Boundary const& boundary = *find_boundary(scene, s.boundary[k]);
    if (boundary.kind == BoundaryKind::port) continue;  // both are the network's own
    s.state.targets[k] = lattice_target(scene, s.derived, boundary, time);
    if (shut && boundary.name == "inlet") {
      s.state.openings[k].kind = lbm::OpeningKind::velocity;
      s.state.targets[k] = 0;
    }
  }
  if (s.state.chambers) set_network(s.state.chambers->network, s.key, scene, s.derived, time, shut);
}

template <class Real, template <class> class Body>
void drive(CoupledScene<Real, Body>& s, Scene const& scene, double time)
{
  auto& m = s.state.membrane;
  for (int a : s.driven) {
    double const to = m.reference[2 * a] +
                      value_at(scene.membrane->centre->displacement, time) / s.derived.units.dx;
    m.velocity[2 * a] = to - m.position[2 * a];  // of one step
    m.velocity[2 * a + 1] = 0;
  }
}

template <class Real, template <class> class Body>
double mean_pressure(CoupledScene<Real, Body> const& s, Zone zone)
{
  auto const& fluid = s.state.fluid;
  auto const cells = lbm::cell_states(fluid);
  auto const active = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), fluid.active);
  double sum = 0, weight = 0;
  for (int j = 0; j < fluid.ny; ++j) {
    double const ring = core::ring(fluid.symmetry, fluid.origin[1] + j + 0.5);
    for (int i = 0; i < fluid.nx; ++i)
      if (s.zone(active(fluid.cell(i, j)), j) == zone) {
        sum += ring * cells(j, i).rho / 3;
        weight += ring;
      }
  }
  return weight > 0 ? sum / weight : 0;
}

template CoupledScene<float, ibm::Sharp> make_coupled_scene(Scene const&, HydrostaticScene const&,
                                                            double);
template void set_targets(CoupledScene<float, ibm::Sharp>&, Scene const&, double, bool);
template void drive(CoupledScene<float, ibm::Sharp>&, Scene const&, double);
template double mean_pressure(CoupledScene<float, ibm::Sharp> const&, Zone);
template CoupledScene<float, ibm::Diffuse> make_coupled_scene(Scene const&, HydrostaticScene const&,
                                                              double);
template void set_targets(CoupledScene<float, ibm::Diffuse>&, Scene const&, double, bool);
template void drive(CoupledScene<float, ibm::Diffuse>&, Scene const&, double);
template double mean_pressure(CoupledScene<float, ibm::Diffuse> const&, Zone);
template CoupledScene<double, ibm::Sharp> make_coupled_scene(Scene const&, HydrostaticScene const&,
                                                             double);
template void set_targets(CoupledScene<double, ibm::Sharp>&, Scene const&, double, bool);
template void drive(CoupledScene<double, ibm::Sharp>&, Scene const&, double);
template double mean_pressure(CoupledScene<double, ibm::Sharp> const&, Zone);
template CoupledScene<double, ibm::Diffuse> make_coupled_scene(Scene const&,
                                                               HydrostaticScene const&, double);
template void set_targets(CoupledScene<double, ibm::Diffuse>&, Scene const&, double, bool);
template void drive(CoupledScene<double, ibm::Diffuse>&, Scene const&, double);
template double mean_pressure(CoupledScene<double, ibm::Diffuse> const&, Zone);

}  // namespace velum::cases
