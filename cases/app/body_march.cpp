#include "cases/app/body_march.hpp"

#include "cases/app/body_words.hpp"
#include "cases/app/chosen_scheme.hpp"
#include "core/check.hpp"
#include "ibm/contact_march.hpp"
#include "ibm/contact_step.hpp"
#include "structure/explicit_step.hpp"
#include "structure/implicit_step.hpp"
#include "structure/mass.hpp"
#include "structure/sheet_force.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace velum::cases {
namespace {

/// Loads but for the contact, which comes last.
template <class Body>
std::span<structure::Load const> without_contact(BodyModel<Body> const& model)
{
  return std::span(model.loads).first(model.loads.size() - (model.contact ? 1 : 0));
}

/// Stable step of the explicit scheme at rest; one of a body that may touch lets it bounce well.
template <class Body>
double stable_at_rest(BodyModel<Body> const& model)
{
  constexpr double margin = 0.8;  // that substeps_for() leaves, and contact_step() has left
  auto const mass = structure::lumped_mass(model.body);
  if (!model.contact)
    return structure::stable_step(model.body, mass, model.body.reference, model.loads);
  return ibm::contact_step(model.body, mass, *model.contact, without_contact(model)) / margin;
}

/// The scene's scheme, or the cheaper one.
template <class Body>
structure::SchemeChoice choose(BodyScene const& scene, BodyModel<Body> const& model,
                               structure::Rayleigh const& damping)
{
  auto const& march = *scene.march;
  auto choice = chosen_scheme(march.scheme, march.step, stable_at_rest(model),
                              structure::typical_cost_ratio(model.body, damping));
  if (model.contact)
    choice.sentence += choice.scheme == structure::TimeScheme::implicit
                           ? "; cut where it would pass the seat"
                           : "; more where it is fast beside the seat, or stretched";
  return choice;
}

/// Notes the most that the seat carried in a step. A body whose middle comes to the seat's face is
/// about to go through.
void note(BodyScene const& scene, ibm::ContactSteps const& step, BodyResult& result)
{
  result.seat_force_max = std::max(result.seat_force_max, step.force);
  result.penetration_max = std::max(result.penetration_max, step.penetration);
  if (step.penetration > std::ranges::min(scene.body.thickness.value) / 2)
    throw core::Divergence(
        fmt::format("the body has gone {:.3g} mm into its seat, more than half its thickness; "
                    "contact.stiffness must be above {:.3g} Pa/m, four times so to halve the depth "
                    "of a fast body",
                    1e3 * step.penetration, penalty(scene)));
}

/// What takes the body a step further; notes in the result what its seat carried, and returns the
/// linear solves that it took.
struct Stepper {
  std::function<int()> advance;
  double time_of_pressure = 0.5;  // where in the step it is to be taken, share of it
};

template <class Body>
Stepper stepper(BodyScene const& scene, BodyModel<Body>& model,
                structure::SchemeChoice const& choice, structure::Rayleigh const& damping,
                BodyResult& result)
{
  double const dt = scene.march->step;
  auto const in_contact = [&scene, &model, &result, dt](auto const& s) {
    return [&scene, &model, &result, dt, s] {
      auto const step =
          ibm::advance_in_contact(*s, model.body, model.contact, dt, without_contact(model));
      note(scene, step, result);
      return step.iterations;
    };
  };
  std::vector<structure::Load> elastic;
  if (!model.bending.empty()) elastic.push_back(structure::bending_load(model.bending));
  if (choice.scheme == structure::TimeScheme::implicit) {
    auto const s = std::make_shared<structure::ImplicitStepper>(
        structure::implicit_stepper(model.body, damping, model.body.reference, elastic));
    double const at = structure::time_of_loads(*s);
    if (model.contact) return {in_contact(s), at};
    return {
        [&model, s, dt] { return structure::advance(*s, model.body, dt, model.loads).iterations; },
        at};
  }
  auto const s = std::make_shared<structure::ExplicitStepper>(
      structure::explicit_stepper(model.body, damping, model.body.reference, elastic));
  if (model.contact) return {in_contact(s)};
  Eigen::VectorXd const none = Eigen::VectorXd::Zero(model.body.position.size());
  return {[&model, s, dt, none, substeps = choice.substeps] {
    structure::advance(*s, model.body, none, {}, dt, substeps, model.loads);
    return 0;
  }};
}

}  // namespace

template <class Body>
BodyResult march(BodyScene const& scene, BodyModel<Body>& model, BodyOutput& out,
                 StretchRecord& stretch, std::string& said)
{
  auto const& m = *scene.march;
  structure::Rayleigh const damping{material(scene).damping_mass,
                                    material(scene).damping_stiffness};
  auto const choice = choose(scene, model, damping);
  said = choice.sentence;
  spdlog::info("scheme: {}", said);
  BodyResult result;
  auto const step = stepper(scene, model, choice, damping, result);
  auto const steps = static_cast<long>(std::ceil(m.end / m.step - 1e-9));
  long const sample = std::max<long>(1, steps / m.samples);
  int iterations = 0;
  for (long n = 0; n <= steps; ++n) {
    double const time = double(n) * m.step;
    if (n % sample == 0 || n == steps) {
      auto const state = state_of(scene, model, value_at(m.pressure, time), iterations, stretch);
      result.states.push_back(state);
      record(out, model, state, time);
      iterations = 0;
    }
    if (n == steps) break;
    model.set_pressure(scene.load.side,
                       value_at(m.pressure, time + step.time_of_pressure * m.step));
    try {
      iterations += step.advance();
    } catch (core::Divergence const& failure) {
      throw core::Divergence(fmt::format("At t = {:.6g} s: {}", time, failure.what()));
    }
  }
  return result;
}

template BodyResult march(BodyScene const&, BodyModel<structure::Membrane>&, BodyOutput&,
                          StretchRecord&, std::string&);
template BodyResult march(BodyScene const&, BodyModel<structure::Sheet>&, BodyOutput&,
                          StretchRecord&, std::string&);

}  // namespace velum::cases
