#include "cases/app/assumptions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "cases/app/fluid_scene.hpp"
#include "cases/app/geometry.hpp"
#include "cases/app/material_range.hpp"
#include "cases/app/scene_words.hpp"

namespace velum::cases {

namespace {

std::string mirrors_in_words(Scene const& scene)
{
  std::vector<std::string> sides;
  for (auto const& name : side_names(dimensions(scene)))
    if (is_mirror(scene, *box_side(name))) sides.push_back(name);
  return fmt::format("mirror images beyond {}; forces are those on whole bodies",
                     fmt::join(sides, ", "));
}

std::string les_in_words(Scene const& scene, double smagorinsky)
{
  if (smagorinsky == 0) return "off";
  if (scene.les.model == LesModel::vreman)
    return fmt::format("Vreman, constant {:.3g}, set anew every {} steps, none next to walls",
                       scene.les.constant, vreman_every);
  return fmt::format("Smagorinsky, constant {:.3g}, but for the two cells next to walls",
                     smagorinsky);
}

std::string gap_law_in_words(GapSection const& gap)
{
  return fmt::format(
      "a closure: lubrication and the velocity head over Cd^2, Cd {:.3g}, at the narrowest place; "
      "sealed below {:.3g} um; its pressure acts on the membrane",
      gap.discharge, 1e6 * gap.seals_at);
}

std::string orifice_in_words(OrificeSection const& o)
{
  std::string text = fmt::format("from {} to {}: {:.4g} mm2, Cd {:.3g} / sqrt(1 + {:.3g} / Re)",
                                 o.from, o.to, 1e6 * o.area, o.discharge, o.transition);
  if (o.length > 0) text += fmt::format(", inertia of {:.3g} mm", 1e3 * o.length);
  if (!o.seat) return text;
  text += fmt::format("; in series a gap {:.3g} mm long on a ring of {:.3g} mm, Cd {:.3g}",
                      1e3 * o.seat->land, 1e3 * o.seat->diameter, o.seat->discharge);
  if (o.member)
    text += fmt::format(
        ", which an elastic membrane of {:.3g} mm lifts off, at rest under what moves its boss",
        2e3 * o.member->radius);
  return text;
}

}  // namespace

std::string bending_in_words(Bending asked, bool on, double slenderness, std::string const& rim)
{
  std::string const why = asked == Bending::auto_
                              ? fmt::format("thickness over span is {:.3g}, {} {:.3g}", slenderness,
                                            on ? "not below" : "below", bending_from)
                              : "as the scene says";
  return on ? fmt::format("on ({}): rotation-free, D = mu H^3 / 3, rim {}", why, rim)
            : fmt::format(
                  "off ({}): a membrane without stiffness in bending, whose rim turns "
                  "freely",
                  why);
}

double smagorinsky_constant(Scene const& scene, bool sealed)
{
  if (scene.les.model == LesModel::off) return 0;
  if (scene.les.model == LesModel::auto_ && sealed) return 0;
  // the closure sets the factor on C^2 so that C cancels
  if (scene.les.model == LesModel::vreman) return std::sqrt(scene.les.constant / 2.5);
  return scene.les.constant;
}

core::Assumptions assumptions(Scene const& scene, Derived const& d, double smagorinsky)
{
  core::Assumptions a;
  a["fidelity"] = word(scene.fidelity);
  if (scene.fidelity == Fidelity::lumped) {
    a["time step"] = fmt::format("{:.4g} s", d.units.dt);
    a["compressibility"] = "none below the membrane; that of the chambers";
    a["gap"] = gap_law_in_words(scene.gap);
  } else if (scene.fidelity != Fidelity::hydrostatic) {
    a["time step"] =
        fmt::format("{:.4g} s, from Mach {:.3g} at {:.4g} m/s", d.units.dt, d.mach, d.velocity);
    a["compressibility"] = fmt::format(
        "the lattice fluid is {:.3g} % denser under {:.4g} kPa (sound speed {:.4g} m/s)",
        100 * d.density_jump, d.pressure / 1e3, d.sound_speed);
    a["collision"] =
        fmt::format("{} on {}, {} walls, tau - 1/2 = {:.3g}, {} precision",
                    word(scene.lattice.collision), word(scene.lattice.stencil),
                    word(scene.lattice.wall_rule), d.tau_minus_half, word(scene.lattice.precision));
    a["les"] = les_in_words(scene, smagorinsky);
    if (scene.membrane)
      a["gap"] = scene.gap.cells > 0
                     ? fmt::format("resolved down to {:.3g} cells; below that {}", scene.gap.cells,
                                   gap_law_in_words(scene.gap))
                     : "resolved down to half a cell; below that a film that carries pressure and "
                       "no flow";
    if (symmetry(scene) != core::Symmetry::none)
      a["axial symmetry"] = symmetry(scene) == core::Symmetry::axisymmetric
                                ? "no swirl; eddies are rings, so LES is damping and no more"
                                : "none: unit depth";
    if (scene.lattice.mirrors != 0) a["symmetry"] = mirrors_in_words(scene);
  }
  if (scene.membrane) {
    auto const& m = scene.materials.at(scene.membrane->material);
    a["membrane"] = material_in_words(m);
    a["bending"] = bending_in_words(scene.membrane->bending, has_bending(*scene.membrane),
                                    slenderness(*scene.membrane), word(scene.membrane->rim));
    if (scene.membrane->centre)
      a["centre"] = fmt::format("moved as given out to {:.4g} mm from the axis",
                                1e3 * scene.membrane->centre->radius);
    if (auto const& stop = scene.membrane->stop)
      a["lift stop"] = fmt::format(
          "a rigid plane at axial {:.4g} mm, out to {:.4g} mm from the axis, by the penalty of the "
          "seat; no liquid squeezed out in front of it",
          1e3 * stop->position, 1e3 * stop->radius);
    a["damping"] = fmt::format(
        "alpha = {:.3g} 1/s, beta = {:.3g} s on the stiffness of the state the march starts from{}",
        m.damping_mass, m.damping_stiffness,
        has_bending(*scene.membrane)
            ? ""
            : " (the flat membrane, without bending, would have none across)");
    a["scheme of the membrane"] = d.membrane_scheme.sentence;
    a["coupling"] =
        scene.coupling.feedback == Feedback::one_way
            ? fmt::format("{}, one way: the membrane drives the fluid and does not feel it",
                          word(scene.coupling.method))
            : fmt::format("{}, {}", word(scene.coupling.method), word(scene.coupling.scheme));
  }
  for (auto const& c : scene.chambers)
    a["chamber " + c.name] = fmt::format(
        "one pressure, {:.4g} mm3 of bulk modulus {:.3g} GPa{}", 1e9 * c.volume,
        1e-9 * c.bulk_modulus, c.side == ChamberSide::above ? ", above the membrane" : "");
  for (auto const& o : scene.orifices) a["orifice " + o.name] = orifice_in_words(o);
  if (scene.contact) {
    a["contact"] = fmt::format("frictionless, {}", word(scene.contact->method));
    a["pressure under the lip"] = word(scene.contact->lip_pressure);
  }
  return a;
}

}  // namespace velum::cases
