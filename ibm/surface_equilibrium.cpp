#include "ibm/surface_equilibrium.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "core/check.hpp"
#include "ibm/sheet_contact.hpp"
#include "ibm/sheet_to_sheet.hpp"

namespace velum::ibm {
namespace {

/// Which triangles have held a point, and which one does.
struct Held {
  std::map<int, std::vector<int>> now;
  std::map<int, std::set<int>> left;
};

/// A point over a valley would go from one of its triangles to the other and back, round after
/// round: one that comes back to a triangle that it has left stays where it is. So each leaves a
/// triangle once at most, and the rounds have an end.
void end_cycles(contact::SurfaceContact& c, Held& held)
{
  auto before = std::move(held.now);
  held.now.clear();
  for (auto& part : c.list.near) {
    if (part.held < 0) continue;
    auto const first = c.list.triangles.begin() + part.first;
    auto const last = c.list.triangles.begin() + part.last;
    for (int const old : before[part.point]) {
      if (old == part.held || std::find(first, last, old) == last) continue;
      if (held.left[part.point].contains(part.held))
        part.held = old;
      else
        held.left[part.point].insert(old);
    }
    held.now[part.point].push_back(part.held);
  }
}

}  // namespace

SurfaceEquilibrium static_solve(structure::Sheet& sheet,
                                std::shared_ptr<contact::SurfaceContact> const& contact,
                                std::span<structure::Load const> loads,
                                SurfaceEquilibriumOptions const& options)
{
  std::vector<structure::Load> all(loads.begin(), loads.end());
  all.push_back(contact_load(contact));
  double const thinnest = sheet.thickness.minCoeff();
  contact->hold = true;
  SurfaceEquilibrium report;
  Held held;
  while (report.rounds < options.rounds) {
    Eigen::VectorXd const before = sheet.position;
    follow(*contact, node_places(sheet.position));
    end_cycles(*contact, held);
    report.iterations += structure::static_solve(sheet, all, options.solve).iterations;
    ++report.rounds;
    report.moved = (sheet.position - before).cwiseAbs().maxCoeff() / thinnest;
    if (report.moved <= options.moved) return report;
  }
  throw core::Divergence(fmt::format(
      "the sheet's contact does not come to rest: {} rounds of search and solution, of which the "
      "last still moved a node by {:.2e} of the thickness; a softer contact or smaller triangles "
      "may",
      report.rounds, report.moved));
}

}  // namespace velum::ibm
