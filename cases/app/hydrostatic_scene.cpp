#include "cases/app/hydrostatic_scene.hpp"

#include "cases/app/geometry.hpp"
#include "contact/penalty.hpp"
#include "structure/mass.hpp"
#include "structure/spring.hpp"
#include "structure/stable_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace velum::cases {

namespace {

double pressure_of(Scene const& scene, std::string const& name, double time)
{
  Boundary const* boundary = find_boundary(scene, name);
  return boundary && imposes_pressure(boundary->kind) ? value_at(boundary->value, time) : 0;
}

structure::Membrane lattice_membrane(Scene const& scene, Derived const& d)
{
  auto const& sheet = *scene.membrane;
  auto const& material = scene.materials.at(sheet.material);
  double const dx = d.units.dx;
  return structure::flat_membrane(
      {.symmetry = symmetry(scene),
       .from = sheet.from / dx,
       .to = sheet.to / dx,
       .element_size = sheet.element / dx,
       .thickness = [thickness = sheet.thickness,
                     dx](double y) { return value_at(thickness, y * dx) / dx; },
       .material = structure::scaled(material.rubber, core::to_lattice_pressure(d.units, 1)),
       .density = core::to_lattice_density(d.units, material.density),
       .axial = sheet.position / dx});
}

/// Least mass per area of what can come to the seat: nodes that lie, in the flat membrane, at most
/// an eighth of its span farther from it than the nearest one. A thin ring at the rim would
/// otherwise make the seat of a thick middle soft.
double lightest_on_seat(structure::Membrane const& m, ibm::SeatContact const& seat,
                        Eigen::VectorXd const& areal_mass)
{
  auto const& markers = seat.markers;
  double const span = m.reference[2 * node_count(m) - 1] - m.reference[1];
  std::vector<double> gap;
  for (std::size_t a = 0; a < markers.X.size(); ++a)
    gap.push_back(contact::gap(seat.contact, markers, a));
  double const near = *std::min_element(gap.begin(), gap.end()) + span / 8;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < gap.size(); ++a)
    if (gap[a] <= near) least = std::min(least, areal_mass[static_cast<Eigen::Index>(a)]);
  return least;
}

/// The stop, once the valve is closed: it must be clear of it.
void add_stop(HydrostaticScene& s, Scene const& scene, Derived const& d)
{
  double const face = structure::highest_face(s.membrane, *s.stop);
  if (face > s.stop->position)
    reject(scene, "membrane.stop.position",
           fmt::format("= {:.4g} mm lies in the closed valve, whose face comes up to {:.4g} mm "
                       "within that radius; raise it, or make membrane.stop.radius smaller.",
                       1e3 * scene.membrane->stop->position, 1e3 * d.units.dx * face));
  s.loads.push_back(structure::stop_load(s.membrane, *s.stop));
}

/// Sub-steps that the membrane takes where it is, closed.
int substeps_of(HydrostaticScene const& s, Eigen::VectorXd const& position)
{
  Eigen::VectorXd const mass = structure::lumped_mass(s.membrane);
  double const stable =
      structure::stable_step(s.membrane, mass, position, s.bending, s.contact_stiffness);
  return structure::substeps_for(1.0, stable);
}

}  // namespace

double inlet_pressure(Scene const& scene, double time) { return pressure_of(scene, "inlet", time); }
double outlet_pressure(Scene const& scene, double time)
{
  return pressure_of(scene, "outlet", time);
}

double pressure_above(Scene const& scene)
{
  ChamberSection const* const chamber = find_chamber(scene, ChamberSide::above);
  return chamber && chamber->initial ? *chamber->initial : inlet_pressure(scene, 0);
}

HydrostaticScene make_membrane_scene(Scene const& scene, Derived const& d)
{
  HydrostaticScene s;
  s.membrane = lattice_membrane(scene, d);
  auto const& sheet = *scene.membrane;
  double const dx = d.units.dx;
  s.bending = s.loads = bending_of(sheet, s.membrane);
  if (sheet.centre) {
    s.driven = structure::nodes_within(s.membrane, sheet.centre->radius / dx);
    for (int a : s.driven) s.membrane.fixed[2 * a] = s.membrane.fixed[2 * a + 1] = 1;
  }
  if (sheet.spring) {
    auto const& spring = *sheet.spring;
    s.loads.push_back(structure::spring_load(
        s.membrane, {core::to_lattice_stiffness(d.units, symmetry(scene), spring.stiffness),
                     spring.free_length / dx, spring.installed_length / dx, spring.radius / dx}));
  }
  Eigen::VectorXd const mass = structure::lumped_mass(s.membrane);
  s.contact_stiffness = Eigen::VectorXd::Zero(mass.size());
  if (scene.contact) {
    Eigen::VectorXd const area = structure::nodal_area(s.membrane);
    Eigen::VectorXd const areal_mass = mass.array() / area.array();
    s.seat = std::make_shared<ibm::SeatContact>(ibm::make_seat_contact(
        core::transformed(solid(scene, scene.contact->seat), 1 / dx, {0, 0}), 0, s.membrane));
    ibm::press(*s.seat, s.membrane.position);
    double const lightest = lightest_on_seat(s.membrane, *s.seat, areal_mass);
    // per length and area: pressure / dx
    double const k = scene.contact->stiffness
                         ? core::to_lattice_pressure(d.units, *scene.contact->stiffness * dx)
                         : contact::stable_stiffness(lightest, 1);
    s.seat->contact.stiffness = k;
    for (int a = 0; a < mass.size(); ++a)
      if (areal_mass[a] >= lightest) s.contact_stiffness[a] = k * area[a];
    if (sheet.stop) {
      s.stop = structure::LiftStop{
          sheet.stop->position / dx, sheet.stop->radius / dx, {s.seat, &s.seat->contact.stiffness}};
      for (int a : structure::nodes_within(s.membrane, s.stop->radius))
        s.contact_stiffness[a] = k * area[a];
    }
  }
  s.substeps = substeps_of(s, s.membrane.reference);
  return s;
}

void find_equilibrium(HydrostaticScene& s, Scene const& scene, Derived const& d)
{
  if (!s.seat)
    reject(scene, "contact",
           "is needed for a hydrostatic state: it is the seat that parts regions");
  bool const augment = scene.contact->method == ContactMethod::augmented_lagrangian;
  s.load.lip = scene.contact->lip_pressure == LipPressure::none ? contact::LipPressure::none
                                                                : contact::LipPressure::linear;
  ibm::hydrostatic_equilibrium(s.membrane, s.seat, s.loads, s.load, augment);
  if (!contact::touches(contact::contact_patch(s.seat->contact, s.seat->markers)))
    reject(scene, "membrane", "does not reach its seat under the spring alone: nothing is sealed");
  s.load.outside = core::to_lattice_pressure(d.units, inlet_pressure(scene, 0));
  s.load.above = core::to_lattice_pressure(d.units, pressure_above(scene));
  s.load.inside = core::to_lattice_pressure(d.units, outlet_pressure(scene, 0));
  s.report = ibm::hydrostatic_equilibrium(s.membrane, s.seat, s.loads, s.load, augment);
  if (s.stop) add_stop(s, scene, d);
  // other laws than the neo-Hookean one may stiffen as they are stretched
  if (scene.materials.at(scene.membrane->material).card)
    s.substeps = std::max(s.substeps, substeps_of(s, s.membrane.position));
}

structure::Rayleigh membrane_damping(Scene const& scene, Derived const& d)
{
  auto const& material = scene.materials.at(scene.membrane->material);
  return {core::to_lattice_frequency(d.units, material.damping_mass),
          core::to_lattice_time(d.units, material.damping_stiffness)};
}

structure::Stepper membrane_stepper(Scene const& scene, Derived const& d,
                                    HydrostaticScene const& start)
{
  if (d.membrane_scheme.scheme == structure::TimeScheme::implicit)
    return structure::implicit_stepper(start.membrane, membrane_damping(scene, d),
                                       start.membrane.position, start.bending);
  return structure::explicit_stepper(start.membrane, membrane_damping(scene, d),
                                     start.membrane.position, start.bending);
}

}  // namespace velum::cases
