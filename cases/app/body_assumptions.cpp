#include "cases/app/assumptions.hpp"
#include "cases/app/body_model.hpp"
#include "cases/app/body_run.hpp"
#include "cases/app/body_words.hpp"
#include "cases/app/material_range.hpp"

#include <fmt/format.h>

namespace velum::cases {

core::Assumptions body_assumptions(BodyScene const& scene)
{
  auto const& body = scene.body;
  core::Assumptions a;
  a["fidelity"] =
      scene.march
          ? "structure: a body alone, set in motion by a given pressure; no fluid"
          : "structure: a body alone, in equilibrium under given loads; no fluid, no inertia";
  a["elements"] = body.elements == Elements::lines
                      ? "line elements, two nodes"
                      : "flat triangles of constant strain, three nodes, in space";
  a["material"] = material_in_words(material(scene)) + "; plane stress, thickness follows";
  a["bending"] =
      bending_in_words(body.bending, has_bending(body), slenderness(body), word(body.rim));
  if (!scene.march)
    a["scheme"] = scene.load.volumes.empty()
                      ? "static: Newton with the exact tangent, loads raised in steps where needed"
                      : "static: Newton with the exact tangent; from the first given volume on the "
                        "pressure is an unknown, which passes the limit point";
  if (scene.march)
    a["damping"] = fmt::format("alpha = {:.3g} 1/s, beta = {:.3g} s on the stiffness at rest",
                               material(scene).damping_mass, material(scene).damping_stiffness);
  if (scene.contact)
    a["contact"] = fmt::format(
        "frictionless, {}, {:.3g} Pa/m{}; the face lies half the undeformed thickness off",
        word(scene.contact->method), penalty(scene),
        scene.contact->stiffness ? "" : " (100 mu / H)");
  return a;
}

}  // namespace velum::cases
