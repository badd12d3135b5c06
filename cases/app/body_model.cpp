#include "cases/app/body_model.hpp"

#include "cases/app/geometry.hpp"
#include "contact/augmented_lagrangian.hpp"
#include "contact/penalty.hpp"
#include "ibm/sheet_contact.hpp"
#include "structure/faces.hpp"
#include "structure/sheet_mesh.hpp"
#include "structure/sheet_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace velum::cases {
namespace {

int parts(double length, double element)
{
  return std::max(2, static_cast<int>(std::ceil(length / element - 1e-6)));
}

structure::TriangleMesh mesh_of(SoftBody const& b)
{
  using namespace structure;
  auto const across = graded(b.inner, b.outer, parts(b.outer - b.inner, b.element));
  switch (b.shape) {
    case BodyShape::disc:
      return disc_mesh(across);
    case BodyShape::annulus:
      return annulus_mesh(across, parts(2 * std::numbers::pi * b.outer, b.element));
    case BodyShape::tube:
      return tube_mesh(b.outer, graded(0, b.length, parts(b.length, b.element)),
                       parts(2 * std::numbers::pi * b.outer, b.element));
    case BodyShape::mesh:
      return b.mesh.mesh;
    case BodyShape::strip:
      break;
  }
  return strip_mesh(across, graded(-b.length / 2, b.length / 2, parts(b.length, b.element)));
}

/// Where along its thickness curve a triangle lies.
double along_thickness(SoftBody const& b, Eigen::Vector3d const& middle)
{
  switch (b.shape) {
    case BodyShape::tube:
      return middle[0];
    case BodyShape::strip:
      return middle[1];
    default:
      return std::hypot(middle[1], middle[2]);
  }
}

/// Points that are held: the groups that the scene names, or the whole rim.
std::vector<int> held_points(SoftBody const& b, structure::TriangleMesh const& mesh)
{
  if (b.clamps.empty()) return structure::rim_points(mesh);
  std::vector<int> held;
  for (auto const& name : b.clamps) {
    auto const& group = b.mesh.groups.at(name);
    held.insert(held.end(), group.begin(), group.end());
  }
  return held;
}

void make_body(BodyScene const& scene, structure::Sheet& sheet)
{
  auto const& b = scene.body;
  auto mesh = mesh_of(b);
  for (int a = 0; a < mesh.points.size(); a += 3) mesh.points[a] += b.position;
  auto const& rubber = material(scene);
  sheet =
      structure::make_sheet(mesh, largest_magnitude(b.thickness), rubber.rubber, rubber.density);
  for (int e = 0; e < element_count(sheet); ++e) {
    auto const& t = sheet.triangles[static_cast<std::size_t>(e)];
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (int corner : t) middle += structure::node3(sheet.reference, corner) / 3;
    middle[0] -= b.position;
    sheet.thickness[e] = value_at(b.thickness, along_thickness(b, middle));
  }
  for (int node : held_points(b, mesh)) structure::clamp(sheet, node);
}

void make_body(BodyScene const& scene, structure::Membrane& line)
{
  auto const& b = scene.body;
  auto const& rubber = material(scene);
  line = structure::flat_membrane({.symmetry = b.shape == BodyShape::disc
                                                   ? core::Symmetry::axisymmetric
                                                   : core::Symmetry::planar,
                                   .from = b.inner,
                                   .to = b.outer,
                                   .element_size = b.element,
                                   .thickness = [&b](double y) { return value_at(b.thickness, y); },
                                   .material = rubber.rubber,
                                   .density = rubber.density,
                                   .axial = b.position});
}

auto bending_of(structure::Sheet const& s, structure::Rim rim)
{
  return structure::sheet_bending(s, rim);
}
auto bending_of(structure::Membrane const& m, structure::Rim rim)
{
  return structure::line_bending(m, rim);
}

Solid const& seat_of(BodyScene const& scene)
{
  return *std::ranges::find_if(scene.solids,
                               [&](Solid const& s) { return s.name == scene.contact->seat; });
}

auto contact_of(BodyScene const& scene, structure::Sheet const& sheet)
{
  return ibm::make_sheet_contact(sheet, placed_in_space(seat_of(scene)), penalty(scene));
}
auto contact_of(BodyScene const& scene, structure::Membrane const& line)
{
  return ibm::make_seat_contact(placed(seat_of(scene)), penalty(scene), line);
}

}  // namespace

double penalty(BodyScene const& scene)
{
  return scene.contact->stiffness.value_or(100 * structure::shear_modulus(material(scene).rubber) /
                                           largest_magnitude(scene.body.thickness));
}

template <class Body>
BodyModel<Body>::BodyModel(BodyScene const& scene) : span(cases::span(scene.body))
{
  make_body(scene, body);
  set_pressure(scene.load.side, 0);
  loads.push_back(structure::pressure_load(body, pressure));
  if (has_bending(scene.body)) {
    bending = bending_of(body, scene.body.rim);
    loads.push_back(structure::bending_load(bending));
  }
  if (scene.contact) {
    contact = std::make_shared<ContactOf>(contact_of(scene, body));
    loads.push_back(ibm::contact_load(contact));
  }
}

template <class Body>
void BodyModel<Body>::set_pressure(Side side, double p)
{
  if constexpr (in_space)
    pressure = Eigen::VectorXd::Constant(element_count(body), side == Side::plus ? p : -p);
  else
    pressure = structure::uniform_pressure(body, side, p);
}

template struct BodyModel<structure::Membrane>;
template struct BodyModel<structure::Sheet>;

SeatFigures seat_figures(BodyModel<structure::Sheet> const& model)
{
  auto const sum = contact::sum_up(*model.contact, ibm::node_places(model.body.position));
  return {std::abs(sum.force[0]), sum.area, sum.penetration, sum.largest};
}

SeatFigures seat_figures(BodyModel<structure::Membrane> const& model)
{
  auto& seat = *model.contact;
  ibm::press(seat, model.body.position);
  auto const patch = contact::contact_patch(seat.contact, seat.markers);
  SeatFigures figures{std::abs(patch.resultant[0]), 0, patch.penetration, 0};
  for (std::size_t a = 0; a < seat.markers.X.size(); ++a) {
    double const t =
        contact::traction(seat.contact.stiffness, contact::gap(seat.contact, seat.markers, a),
                          contact::multiplier_of(seat.contact, a));
    if (t > 0) figures.area += seat.markers.area[a];
    figures.pressure_max = std::max(figures.pressure_max, t);
  }
  return figures;
}

double update_multipliers(BodyModel<structure::Sheet>& model)
{
  return contact::update_multipliers(*model.contact, ibm::node_places(model.body.position));
}

double update_multipliers(BodyModel<structure::Membrane>& model)
{
  auto& seat = *model.contact;
  ibm::press(seat, model.body.position);
  return contact::update_multipliers(seat.contact, seat.markers);
}

std::ptrdiff_t unknowns(BodyScene const& scene)
{
  auto const free = [](std::vector<char> const& fixed) { return std::ranges::count(fixed, 0); };
  return scene.body.elements == Elements::lines
             ? free(BodyModel<structure::Membrane>(scene).body.fixed)
             : free(BodyModel<structure::Sheet>(scene).body.fixed);
}

std::vector<Vec3> places(structure::Sheet const&, Eigen::VectorXd const& x)
{
  return ibm::node_places(x);
}

std::vector<Vec3> places(structure::Membrane const& body, Eigen::VectorXd const& x)
{
  std::vector<Vec3> all;
  for (int a = 0; a < node_count(body); ++a) {
    auto const p = structure::node(x, a);
    all.push_back({p[0], p[1], 0});
  }
  return all;
}

}  // namespace velum::cases
