#pragma once
#include "cases/app/scene.hpp"
#include "structure/pressure_load.hpp"
#include "structure/scheme.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

/// The words by which a scene file names a choice.
namespace velum::cases {

template <class Choice>
using Words = std::vector<std::pair<std::string, Choice>>;

inline Words<Fidelity> words(Fidelity)
{
  return {{"hydrostatic", Fidelity::hydrostatic},
          {"lumped", Fidelity::lumped},
          {"axisymmetric", Fidelity::axisymmetric},
          {"planar", Fidelity::planar},
          {"3d", Fidelity::space},
          {"structure", Fidelity::structure}};
}
inline Words<Collision> words(Collision)
{
  return {{"bgk", Collision::bgk},
          {"trt", Collision::trt},
          {"recursive_regularised", Collision::recursive_regularised},
          {"central_moments", Collision::central_moments},
          {"cumulant", Collision::cumulant}};
}
inline Words<lbm::WallRule> words(lbm::WallRule)
{
  return {{"quadratic", lbm::WallRule::quadratic},
          {"linear", lbm::WallRule::linear},
          {"half_way", lbm::WallRule::half_way}};
}
inline Words<structure::FitModel> words(structure::FitModel)
{
  using structure::FitModel;
  return {{"neo_hookean", FitModel::neo_hookean},
          {"mooney_rivlin_2", FitModel::mooney_rivlin_2},
          {"mooney_rivlin_5", FitModel::mooney_rivlin_5}};
}
inline Words<structure::TestMode> words(structure::TestMode)
{
  using structure::TestMode;
  return {{"uniaxial", TestMode::uniaxial},
          {"planar", TestMode::planar},
          {"equibiaxial", TestMode::equibiaxial}};
}
inline Words<structure::TimeScheme> words(structure::TimeScheme)
{
  return {{"explicit", structure::TimeScheme::explicit_substeps},
          {"implicit", structure::TimeScheme::implicit}};
}
inline Words<structure::Side> words(structure::Side)
{
  return {{"minus", structure::Side::minus}, {"plus", structure::Side::plus}};
}
inline Words<Precision> words(Precision)
{
  return {
      {"double", Precision::double_}, {"single", Precision::single_}, {"half", Precision::half}};
}
inline Words<Stencil> words(Stencil)
{
  return {{"d2q9", Stencil::d2q9}, {"d3q19", Stencil::d3q19}, {"d3q27", Stencil::d3q27}};
}
inline Words<LesModel> words(LesModel)
{
  return {{"auto", LesModel::auto_},
          {"off", LesModel::off},
          {"smagorinsky", LesModel::smagorinsky},
          {"vreman", LesModel::vreman}};
}
inline Words<SolidShape> words(SolidShape)
{
  return {{"box", SolidShape::box},           {"disc", SolidShape::disc},
          {"profile", SolidShape::profile},   {"sphere", SolidShape::sphere},
          {"cylinder", SolidShape::cylinder}, {"stl", SolidShape::stl}};
}
inline Words<Operation> words(Operation)
{
  return {{"add", Operation::add}, {"subtract", Operation::subtract}};
}
inline Words<BoundaryKind> words(BoundaryKind)
{
  return {{"traction", BoundaryKind::traction},      {"pressure", BoundaryKind::pressure},
          {"velocity", BoundaryKind::velocity},      {"flow_rate", BoundaryKind::flow_rate},
          {"outflow", BoundaryKind::outflow},        {"port", BoundaryKind::port},
          {"moving_wall", BoundaryKind::moving_wall}};
}
inline Words<ChamberSide> words(ChamberSide)
{
  return {{"none", ChamberSide::none}, {"above", ChamberSide::above}};
}
inline Words<Axis> words(Axis) { return {{"x", Axis::x}, {"y", Axis::y}, {"z", Axis::z}}; }
inline Words<VelocityProfile> words(VelocityProfile)
{
  return {{"uniform", VelocityProfile::uniform}, {"parabolic", VelocityProfile::parabolic}};
}
inline Words<InitialKind> words(InitialKind)
{
  return {{"rest", InitialKind::rest},
          {"uniform", InitialKind::uniform},
          {"taylor_green", InitialKind::taylor_green},
          {"shear_layer", InitialKind::shear_layer}};
}
inline Words<ProbeKind> words(ProbeKind)
{
  return {{"point", ProbeKind::point},
          {"force", ProbeKind::force},
          {"pressure_difference", ProbeKind::pressure_difference},
          {"kinetic_energy", ProbeKind::kinetic_energy}};
}
inline Words<ReferenceKind> words(ReferenceKind)
{
  return {{"points", ReferenceKind::points},
          {"taylor_green", ReferenceKind::taylor_green},
          {"pipe", ReferenceKind::pipe},
          {"body", ReferenceKind::body},
          {"dissipation", ReferenceKind::dissipation},
          {"figure", ReferenceKind::figure}};
}
inline Words<MembraneShape> words(MembraneShape)
{
  return {{"disc", MembraneShape::disc}, {"strip", MembraneShape::strip}};
}
inline Words<Rim> words(Rim) { return {{"clamped", Rim::clamped}, {"hinged", Rim::hinged}}; }
inline Words<Bending> words(Bending)
{
  return {{"auto", Bending::auto_}, {"on", Bending::on}, {"off", Bending::off}};
}
inline Words<Feedback> words(Feedback)
{
  return {{"two_way", Feedback::two_way}, {"one_way", Feedback::one_way}};
}
inline Words<ContactMethod> words(ContactMethod)
{
  return {{"penalty", ContactMethod::penalty},
          {"augmented_lagrangian", ContactMethod::augmented_lagrangian}};
}
inline Words<LipPressure> words(LipPressure)
{
  return {{"none", LipPressure::none}, {"linear", LipPressure::linear}};
}
inline Words<CouplingMethod> words(CouplingMethod)
{
  return {{"sharp", CouplingMethod::sharp}, {"diffuse", CouplingMethod::diffuse}};
}
inline Words<CouplingScheme> words(CouplingScheme)
{
  return {{"implicit", CouplingScheme::implicit}, {"explicit", CouplingScheme::explicit_}};
}
inline Words<MembraneScheme> words(MembraneScheme)
{
  return {{"auto", MembraneScheme::auto_},
          {"explicit", MembraneScheme::explicit_},
          {"implicit", MembraneScheme::implicit}};
}

/// The word for a choice.
template <class Choice>
std::string word(Choice choice)
{
  auto const all = words(choice);
  return std::find_if(all.begin(), all.end(), [&](auto const& w) { return w.second == choice; })
      ->first;
}

}  // namespace velum::cases
