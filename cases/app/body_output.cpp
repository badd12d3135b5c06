#include "cases/app/body_output.hpp"

#include "structure/internal_force.hpp"
#include "structure/sheet_force.hpp"
#include "structure/volume_control.hpp"

#include <algorithm>
#include <cmath>

namespace velum::cases {
namespace {

core::Field displacement(std::vector<Vec3> const& before, std::vector<Vec3> const& after)
{
  std::vector<double> values;
  for (std::size_t a = 0; a < before.size(); ++a)
    for (int i = 0; i < 3; ++i) values.push_back(after[a][i] - before[a][i]);
  return {"displacement", "m", 3, std::move(values)};
}

void draw(BodyOutput& out, structure::Sheet const& sheet, std::vector<Vec3> const& before,
          std::vector<Vec3> const& after, double at)
{
  core::Surface surface{"body", after, {}, {displacement(before, after)}};
  for (auto const& t : sheet.triangles) surface.triangles.push_back({t[0], t[1], t[2]});
  core::write_fields(out.fields, at, {}, {}, {surface});
}

void draw(BodyOutput& out, structure::Membrane const&, std::vector<Vec3> const& before,
          std::vector<Vec3> const& after, double at)
{
  core::Curve curve{"body", {}, {displacement(before, after)}};
  for (auto const& p : after) curve.nodes.push_back(core::in_plane(p));
  core::write_fields(out.fields, at, {}, {curve});
}

double volume_of(structure::Inflation const& by, structure::Membrane const& m)
{
  return by.volume(m.position);
}
double volume_of(structure::Inflation const& by, structure::Sheet const& s)
{
  return by.volume(s.position) - by.volume(s.reference);
}

/// Deflection along the first axis: of the middle of a disc, which is its first node, else the
/// largest. A mesh may lie any way: its farthest displacement.
template <class Body>
double deflection(BodyScene const& scene, Body const& body)
{
  constexpr int d = Body::dimension;
  Eigen::VectorXd const moved = body.position - body.reference;
  if (scene.body.shape == BodyShape::disc) return moved[0];
  double largest = 0;
  for (Eigen::Index i = 0; i < moved.size(); i += d) {
    double const here = scene.body.shape == BodyShape::mesh ? moved.segment<d>(i).norm() : moved[i];
    if (std::abs(here) > std::abs(largest)) largest = here;
  }
  return largest;
}

/// Nodes of the section, from the axis outwards.
std::vector<std::size_t> section(std::vector<Vec3> const& places, double span)
{
  std::vector<std::size_t> nodes;
  for (std::size_t a = 0; a < places.size(); ++a)
    if (std::abs(places[a][2]) < 1e-9 * span && places[a][1] > -1e-9 * span) nodes.push_back(a);
  std::ranges::sort(nodes, [&](auto a, auto b) { return places[a][1] < places[b][1]; });
  return nodes;
}

}  // namespace

BodyOutput start_output(BodyScene const& scene, std::filesystem::path const& folder)
{
  core::Column const first = scene.march ? core::Column{"time", "s"} : core::Column{"state", "1"};
  return {core::create_fields(folder, {}, body_assumptions(scene)),
          core::start_series(folder / "series.csv",
                             {{"pressure", "Pa"},
                              {"volume", "m3"},
                              {"deflection", "m"},
                              {"deflection_reference", "m"},
                              {"stretch_max", "1"},
                              {"seat_force", "N"},
                              {"contact_area", "m2"},
                              {"contact_pressure_max", "Pa"},
                              {"penetration", "m"},
                              {"iterations", "1"}},
                             first),
          core::start_series(folder / "profile.csv",
                             {{"reference_radius", "m"}, {"radius", "m"}, {"axial", "m"}}, first)};
}

template <class Body>
BodyState state_of(BodyScene const& scene, BodyModel<Body> const& model, double pressure,
                   int iterations, StretchRecord& stretch)
{
  note_stretch(stretch, model.body, material(scene));
  BodyState state{pressure, volume_of(structure::inflation(model.body), model.body),
                  deflection(scene, model.body),
                  structure::largest_stretch(model.body, model.body.position)};
  state.iterations = iterations;
  if (model.contact) {
    auto const seat = seat_figures(model);
    state.force = seat.force;
    state.area = seat.area;
    state.penetration = seat.penetration;
    state.pressure_max = seat.pressure_max;
  }
  return state;
}

template <class Body>
void record(BodyOutput& out, BodyModel<Body> const& model, BodyState const& s, double at)
{
  core::append(out.series, at,
               {s.pressure, s.volume, s.deflection, s.reference, s.stretch_max, s.force, s.area,
                s.pressure_max, s.penetration, double(s.iterations)});
  auto const before = places(model.body, model.body.reference);
  auto const after = places(model.body, model.body.position);
  draw(out, model.body, before, after, at);
  for (std::size_t a : section(before, model.span))
    core::append(out.profile, at, {before[a][1], after[a][1], after[a][0]});
}

template BodyState state_of(BodyScene const&, BodyModel<structure::Membrane> const&, double, int,
                            StretchRecord&);
template BodyState state_of(BodyScene const&, BodyModel<structure::Sheet> const&, double, int,
                            StretchRecord&);
template void record(BodyOutput&, BodyModel<structure::Membrane> const&, BodyState const&, double);
template void record(BodyOutput&, BodyModel<structure::Sheet> const&, BodyState const&, double);

}  // namespace velum::cases
