#include "ibm/region_mass.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "ibm/swept_volume.hpp"

namespace velum::ibm {

using lbm::D2Q9;

namespace {

/// Density below which a surplus waits: no sum over a region is known better.
constexpr double least_taken = 1e-14;

/// A view of at least so many numbers, which only grows.
void make_room(Kokkos::View<double*>& view, char const* name, std::size_t size)
{
  if (view.extent(0) < size) view = Kokkos::View<double*>(std::string(name), size * 5 / 4 + 64);
}

int region_of(RegionMass const& mass, Cells const& cells, int i, int j)
{
  return mass.regions.of[static_cast<std::size_t>(j * cells.labels.nx + i)];
}

/// Region before a point of a face, or -1: of the first fluid cell on its side within a cell and a
/// half along the normal.
int region_before(RegionMass const& mass, Cells const& cells, std::uint8_t side, core::Vec2 p,
                  core::Vec2 normal)
{
  for (double reach : {0.5, 1.0, 1.5}) {
    core::Vec2 const at = p + reach * normal - cells.labels.origin;
    int const i = static_cast<int>(std::floor(at[0])), j = static_cast<int>(std::floor(at[1]));
    if (i < 0 || i >= cells.labels.nx || j < 0 || j >= cells.labels.ny) continue;
    if (cells.at(i, j) == side) return region_of(mass, cells, i, j);
  }
  return -1;
}

}  // namespace

template <class Real>
void find_regions(RegionMass& mass, lbm::Fluid<Real> const& fluid, Cells const& cells)
{
  Regions before = std::move(mass.regions);
  if (!before.of.empty())
    for (CellChange const& c : cells.changes)
      before.of[static_cast<std::size_t>(c.j * cells.labels.nx + c.i)] = -1;
  std::vector<double> const surplus = std::move(mass.surplus);
  mass.regions = connected_regions(fluid, cells);
  auto const count = static_cast<std::size_t>(mass.regions.count);
  mass.surplus.assign(count, 0);
  // cells that stayed fluid, of each old region in each new one
  std::vector<std::vector<long>> stayed(surplus.size(), std::vector<long>(count, 0));
  for (std::size_t k = 0; k < before.of.size(); ++k)
    if (before.of[k] >= 0 && mass.regions.of[k] >= 0)
      ++stayed[static_cast<std::size_t>(before.of[k])]
              [static_cast<std::size_t>(mass.regions.of[k])];
  mass.runs = Kokkos::View<Regions::Run*>("runs", mass.regions.runs.size());
  Kokkos::View<Regions::Run const*, Kokkos::HostSpace, Kokkos::MemoryUnmanaged> const host(
      mass.regions.runs.data(), mass.regions.runs.size());
  Kokkos::deep_copy(mass.runs, host);
  for (std::size_t r = 0; r < surplus.size(); ++r) {
    long all = 0;
    for (long n : stayed[r]) all += n;
    for (std::size_t s = 0; s < count && all > 0; ++s)
      mass.surplus[s] += surplus[r] * double(stayed[r][s]) / double(all);
  }
}

template <class Real>
void add_changed_cells(RegionMass& mass, lbm::Fluid<Real> const& fluid, Cells const& cells,
                       double sign)
{
  std::size_t const count = cells.changes.size();
  make_room(mass.parts, "parts", count);
  Kokkos::View<int*> list("changed_cells", count);
  auto const list_host = Kokkos::create_mirror_view(list);
  for (std::size_t k = 0; k < count; ++k)
    list_host(k) = fluid.cell(cells.changes[k].i, cells.changes[k].j);
  Kokkos::deep_copy(list, list_host);
  lbm::Fluid<Real> const from = fluid;
  auto const content = mass.parts;
  Kokkos::parallel_for(
      "velum::ibm::content_of_cells", int(count), KOKKOS_LAMBDA(int k) {
        int const cell = list(k);
        double const y = from.origin[1] + cell / from.f.pitch - 1 + 0.5;
        double sum = 0;
        for (int d = 0; d < D2Q9::Q; ++d)
          sum += lbm::link_ring(from.symmetry, y, d) * double(from.f.outgoing(d, cell));
        content(k) = sum;
      });
  auto const host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), content);
  for (std::size_t k = 0; k < count; ++k) {
    int const region = region_of(mass, cells, cells.changes[k].i, cells.changes[k].j);
    if (region >= 0) mass.surplus[static_cast<std::size_t>(region)] += sign * host(k);
  }
}

template <class Real>
void add_gain(RegionMass& mass, lbm::Fluid<Real> const& fluid, lbm::LinkList const& resting)
{
  make_room(mass.parts, "parts", static_cast<std::size_t>(resting.size));
  lbm::Fluid<Real> const from = fluid;
  auto const links = resting.links;
  auto const gain = mass.parts;
  Kokkos::parallel_for(
      "velum::ibm::gain_parts", resting.size, KOKKOS_LAMBDA(int k) {
        lbm::Link const l = links(k);
        int const cell = from.cell(l.i, l.j);
        gain(k) = lbm::link_ring(from.symmetry, from.origin[1] + l.j + 0.5, l.dir) *
                  (double(from.f.arriving(D2Q9::opposite(l.dir), cell)) -
                   double(from.f.outgoing(l.dir, cell)));
      });
  auto const host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), gain);
  auto const list = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), links);
  for (int k = 0; k < resting.size; ++k)
    mass.surplus[static_cast<std::size_t>(list(k).region)] += host(k);
}

void subtract_swept(RegionMass& mass, Cells const& cells, std::uint8_t side, FaceLine const& before,
                    FaceLine const& after, core::Symmetry symmetry)
{
  double const sign = side == fluid_plus ? 1 : -1, low = cells.labels.origin[1];
  Rows const rows = {low, low + cells.labels.ny};
  for (std::size_t s = 0; s + 1 < after.points.size(); ++s) {
    double const volume = swept_volume(before, after, s, rows, symmetry);
    if (volume == 0) continue;
    core::Vec2 const a = before.points[s], along = before.points[s + 1] - a;
    // the middle, or what is nearest to it in a row of cells
    auto const in_rows = [&](double y) {
      return std::clamp(y, rows.lowest + 0.5, rows.highest - 0.5);
    };
    double const t = along[1] != 0
                         ? std::clamp((in_rows(a[1] + along[1] / 2) - a[1]) / along[1], 0.0, 1.0)
                         : 0.5;
    core::Vec2 const at = {a[0] + t * along[0], in_rows(a[1] + t * along[1])};
    core::Vec2 const normal = (sign / norm(along)) * core::Vec2{along[1], -along[0]};
    int const region = region_before(mass, cells, side, at, normal);
    if (region >= 0) mass.surplus[static_cast<std::size_t>(region)] -= sign * volume;
  }
}

template <class Real>
void take_back(RegionMass& mass, lbm::Fluid<Real>& fluid)
{
  auto const& runs = mass.regions.runs;
  auto const ring = [&](Regions::Run const& r) {
    return core::ring(fluid.symmetry, fluid.origin[1] + r.row + 0.5);
  };
  std::vector<double> per_volume = mass.surplus, volume(mass.surplus.size(), 0);
  for (auto const& r : runs)
    volume[static_cast<std::size_t>(r.region)] += ring(r) * (r.last - r.first + 1);
  for (std::size_t r = 0; r < volume.size(); ++r) {
    per_volume[r] /= volume[r];
    if (std::abs(per_volume[r]) < least_taken) per_volume[r] = 0;
  }

  make_room(mass.parts, "parts", runs.size());
  auto const parts = Kokkos::create_mirror_view(mass.parts);
  for (std::size_t k = 0; k < runs.size(); ++k)
    parts(k) = per_volume[static_cast<std::size_t>(runs[k].region)];
  Kokkos::deep_copy(mass.parts, parts);
  lbm::Fluid<Real> const to = fluid;
  auto const list = mass.runs;
  auto const share = mass.parts;  // in: to take per volume; out: taken, of all cells
  Kokkos::parallel_for(
      "velum::ibm::take_back", int(runs.size()), KOKKOS_LAMBDA(int k) {
        Regions::Run const r = list(k);
        double taken = 0;
        for (int i = r.first; i <= r.last; ++i) {
          int const cell = to.cell(i, r.row);
          Real const before = to.f.outgoing(0, cell), after = before - Real(share(k));
          to.f.set_outgoing(0, cell, after);
          taken += double(before) - double(after);
        }
        share(k) = taken;
      });
  Kokkos::deep_copy(parts, mass.parts);
  for (std::size_t k = 0; k < runs.size(); ++k)
    mass.surplus[static_cast<std::size_t>(runs[k].region)] -= ring(runs[k]) * parts(k);
}

#define VELUM_INSTANTIATE(Real)                                                                \
  template void find_regions(RegionMass&, lbm::Fluid<Real> const&, Cells const&);              \
  template void add_changed_cells(RegionMass&, lbm::Fluid<Real> const&, Cells const&, double); \
  template void add_gain(RegionMass&, lbm::Fluid<Real> const&, lbm::LinkList const&);          \
  template void take_back(RegionMass&, lbm::Fluid<Real>&);
VELUM_INSTANTIATE(float)
VELUM_INSTANTIATE(double)
#undef VELUM_INSTANTIATE

}  // namespace velum::ibm
