#include "cases/app/body_march.hpp"

#include "cases/app/body_words.hpp"
#include "cases/app/chosen_scheme.hpp"
#include "core/check.hpp"
#include "structure/explicit_step.hpp"
#include "structure/implicit_step.hpp"
#include "structure/mass.hpp"
#include "structure/sheet_force.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cmath>
#include <functional>

namespace velum::cases {
namespace {

/// The scene's scheme, or the cheaper one.
template <class Body>
structure::SchemeChoice choose(BodyScene const& scene, BodyModel<Body> const& model,
                               structure::Rayleigh const& damping)
{
  auto const& march = *scene.march;
  double const stable = structure::stable_step(model.body, structure::lumped_mass(model.body),
                                               model.body.reference, model.loads);
  return chosen_scheme(march.scheme, march.step, stable,
                       structure::typical_cost_ratio(model.body, damping));
}

/// What takes the body a step further; returns the linear solves that it took.
template <class Body>
std::function<int()> stepper(BodyScene const& scene, BodyModel<Body>& model,
                             structure::SchemeChoice const& choice,
                             structure::Rayleigh const& damping)
{
  double const dt = scene.march->step;
  std::vector<structure::Load> elastic;
  if (!model.bending.empty()) elastic.push_back(structure::bending_load(model.bending));
  if (choice.scheme == structure::TimeScheme::implicit) {
    auto const s = std::make_shared<structure::ImplicitStepper>(
        structure::implicit_stepper(model.body, damping, model.body.reference, elastic));
    return
        [&model, s, dt] { return structure::advance(*s, model.body, dt, model.loads).iterations; };
  }
  auto const s = std::make_shared<structure::ExplicitStepper>(
      structure::explicit_stepper(model.body, damping, model.body.reference, elastic));
  Eigen::VectorXd const none = Eigen::VectorXd::Zero(model.body.position.size());
  return [&model, s, dt, none, substeps = choice.substeps] {
    structure::advance(*s, model.body, none, {}, dt, substeps, model.loads);
    return 0;
  };
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
  auto const step = stepper(scene, model, choice, damping);
  auto const steps = static_cast<long>(std::ceil(m.end / m.step - 1e-9));
  long const sample = std::max<long>(1, steps / m.samples);
  BodyResult result;
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
    model.set_pressure(scene.load.side, value_at(m.pressure, time + m.step / 2));
    try {
      iterations += step();
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
