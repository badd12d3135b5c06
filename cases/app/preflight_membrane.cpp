#include "cases/app/preflight.hpp"

#include "cases/app/geometry.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace velum::cases {
namespace {

std::string finer(double dx) { return fmt::format("lattice.dx <= \"{:.3g} um\"", 1e6 * dx); }

/// Whether a law stands in for the lattice where the seat's gap is narrow.
bool has_closure(Scene const& scene)
{
  return scene.gap.cells > 0 || scene.fidelity == Fidelity::lumped;
}

Row gap_row(Scene const& scene)
{
  double const dx = scene.lattice.dx, gap = initial_gap(scene), cells = gap / dx;
  Row row{"cells in the smallest gap, at first", cells, "", Verdict::ok, ""};
  if (gap < -1e-6 * dx) {
    row.verdict = Verdict::red;
    row.remark =
        fmt::format("the membrane starts {:.3g} um inside the seat: move one of them", -1e6 * gap);
  } else if (has_closure(scene)) {
    row.remark = scene.fidelity == Fidelity::lumped
                     ? "its flow is the closure's"
                     : fmt::format("below {:.3g} its flow is the closure's", scene.gap.cells);
  } else if (gap > 0 && cells < 8) {
    row.verdict = Verdict::warn;
    row.remark =
        "sealing is exact, but flow through the open gap is not resolved: " + finer(gap / 8);
  }
  return row;
}

Row land_row(Scene const& scene)
{
  double const width = land_width(scene);
  Row row{"cells across the seat's land", width / scene.lattice.dx, "", Verdict::ok, ""};
  if (row.value < 2 && !has_closure(scene)) {
    row.verdict = Verdict::warn;
    row.remark = finer(0.5 * width) + " shows the pressure across it";
  }
  return row;
}

Row thickness_row(Scene const& scene, Derived const& d)
{
  Row row{"cells across the membrane", d.thickness / scene.lattice.dx, "", Verdict::ok, ""};
  if (row.value < 2 && scene.coupling.method == CouplingMethod::sharp) {
    row.verdict = row.value < 1 ? Verdict::red : Verdict::warn;
    row.remark = "its inside should hold lattice points: " + finer(0.5 * d.thickness);
  }
  return row;
}

Row mass_row(Scene const& scene, Derived const& d)
{
  // Explicit exchange of wall velocity and force is unstable below about 60 (sharp) at low
  // viscosity; the implicit one was stable from 10 to 0.1.
  Row row{"mass ratio rho_s h / (rho dx)", d.mass_ratio, "", Verdict::ok, ""};
  if (scene.coupling.scheme == CouplingScheme::explicit_ && d.mass_ratio < 60) {
    row.verdict = Verdict::red;
    row.remark = "unstable below about 60: coupling.scheme = \"implicit\"";
  } else if (d.mass_ratio < 0.1) {
    row.verdict = Verdict::warn;
    row.remark = "untried below 0.1: " + finer(scene.lattice.dx * d.mass_ratio / 0.1);
  }
  return row;
}

Row sub_steps_row(Scene const& scene, Derived const& d)
{
  if (d.membrane_scheme.scheme == structure::TimeScheme::implicit)
    return {"steps of the membrane", 1, "", Verdict::ok,
            fmt::format("implicit, in place of {} sub-steps or more", d.sub_steps)};
  Row row{"sub-steps of the membrane", static_cast<double>(d.sub_steps), "", Verdict::ok,
          "more while contact is closed"};
  if (d.sub_steps > 32) {
    row.verdict = Verdict::warn;
    row.remark = fmt::format("costly: membrane.element >= \"{:.3g} um\"",
                             1e6 * scene.membrane->element * d.sub_steps / 32);
  }
  return row;
}

}  // namespace

std::vector<Row> membrane_rows(Scene const& scene, Derived const& d)
{
  if (!scene.membrane) return {};
  std::vector<Row> rows;
  if (scene.contact) rows = {gap_row(scene), land_row(scene)};
  rows.push_back(thickness_row(scene, d));
  rows.push_back(mass_row(scene, d));
  if (auto const& card = scene.materials.at(scene.membrane->material).card)
    rows.push_back({"stretch that the card is fitted to", largest_stretch(card->fitted), "",
                    Verdict::info, tests_in_words(card->fitted) + "; a run warns beyond"});
  rows.push_back({"stable step of the membrane", 1e6 * d.structure_step, "us", Verdict::info,
                  "elements against the wave speed sqrt(4 mu / rho_s)"});
  rows.push_back(sub_steps_row(scene, d));
  if (d.damping_step > 0)
    rows.push_back({"step if beta were explicit", 1e9 * d.damping_step, "ns", Verdict::info,
                    "it is implicit, so this does not bind"});
  return rows;
}

}  // namespace velum::cases
