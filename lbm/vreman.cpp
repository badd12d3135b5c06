#include "lbm/vreman.hpp"

#include "core/check.hpp"
#include "lbm/formats.hpp"
#include "lbm/moments.hpp"

namespace velum::lbm {

namespace {

using Space = Kokkos::DefaultExecutionSpace;
constexpr bool on_host =
    Kokkos::SpaceAccessibility<Kokkos::HostSpace, Space::memory_space>::accessible;

/// Largest nu_t / (C_V |S|); set_vreman_share() says why there is one.
constexpr int largest_ratio = 10;

/// Reads the populations of a row of cells and writes velocities and sides.
template <class Real, class L, class Stored>
struct VelocityRow {
  using P = Populations<Real, L, Stored>;

  Stored const* slot[L::Q];
  Real unpack[L::Q], half_force[L::D];
  std::uint8_t const* active;
  Real* u[L::D];
  std::uint8_t* side;

  KOKKOS_FORCEINLINE_FUNCTION VelocityRow(Fluid<Real, L, Stored> const& fluid,
                                          Vreman<Real> const& to, int cell)
      : active(&fluid.active(cell)), side(&to.side(cell))
  {
    auto const& f = fluid.f;
    for (int i = 0; i < L::Q; ++i) {
      slot[i] = f.turned() ? &f.slots(L::opposite(i), cell) : &f.slots(i, cell + f.shift(i));
      unpack[i] = f.unpack_scale(i);
    }
    for (int a = 0; a < L::D; ++a) {
      u[a] = &to.velocity(a, cell);
      half_force[a] = Real(fluid.model.body_force[a] / 2);
    }
  }

  KOKKOS_FORCEINLINE_FUNCTION void operator()(int x) const
  {
    Real f[L::Q];
    core::static_for<L::Q>([&](auto i) __attribute__((always_inline)) {
      f[i] = P::from_stored(slot[i][x], unpack[i]);
    });
    Moments<L, Real> const m = moments<L>(f);
    Real const volume = 1 / (1 + m.rho());
    core::static_for<L::D>([&](auto a) __attribute__((always_inline)) {
      u[a][x] = volume * (m.j(a) - half_force[a]);
    });
    side[x] = active[x];
  }
};

/// Sum of the squares of all 2 x 2 minors.
template <class Real, int D>
KOKKOS_FORCEINLINE_FUNCTION Real minors_squared(Real const (&a)[D][D])
{
  Real sum = 0;
  core::static_for<D>([&](auto i) __attribute__((always_inline)) {
    core::static_for<i>([&](auto j) __attribute__((always_inline)) {
      core::static_for<D>([&](auto k) __attribute__((always_inline)) {
        core::static_for<k>([&](auto l) __attribute__((always_inline)) {
          Real const minor = a[i][k] * a[j][l] - a[i][l] * a[j][k];
          sum += minor * minor;
        });
      });
    });
  });
  return sum;
}

/// |S|^2 = 2 S:S of the deviator of the strain rate.
template <class Real, int D>
KOKKOS_FORCEINLINE_FUNCTION Real strain_squared(Real const (&a)[D][D])
{
  Real sum = 0, trace = 0;
  core::static_for<D>([&](auto i) __attribute__((always_inline)) { trace += a[i][i]; });
  core::static_for<D>([&](auto i) __attribute__((always_inline)) {
    Real const own = a[i][i] - trace / D;
    sum += 2 * own * own;
    core::static_for<i>([&](auto j) __attribute__((always_inline)) {
      Real const twice = a[i][j] + a[j][i];
      sum += twice * twice;
    });
  });
  return sum;
}

/// nu_t / (C_V |S|), dx = 1. What is not a number compares false and gives zero.
template <class Real, int D>
KOKKOS_FORCEINLINE_FUNCTION Real viscosity_ratio(Real const (&a)[D][D])
{
  using std::sqrt;
  Real gradient = 0;
  core::static_for<D>([&](auto i) __attribute__((always_inline)) {
    core::static_for<D>([&](auto j)
                            __attribute__((always_inline)) { gradient += a[i][j] * a[i][j]; });
  });
  Real const strain = strain_squared(a);
  // both far above the smallest number of single precision, as their product is
  bool const flows = (gradient > Real(1e-14)) & (strain > Real(1e-20));
  Real const squared = minors_squared(a) / (gradient * strain);
  constexpr Real most = largest_ratio * largest_ratio;
  return flows ? sqrt(squared < most ? squared : most) : Real(0);
}

/// Reads the velocities around a row of cells and writes the factor on the eddy viscosity.
template <class Real, class L, class Stored>
struct ShareRow {
  Real const* u[L::D];
  std::uint8_t const* side;
  Real* share;
  int stride[L::D];
  Real scale;  // C_V / C^2

  KOKKOS_FORCEINLINE_FUNCTION ShareRow(Fluid<Real, L, Stored> const& fluid,
                                       Vreman<Real> const& from, int cell)
      : side(&from.side(cell)), share(&fluid.eddy_share(cell))
  {
    for (int a = 0; a < L::D; ++a) {
      u[a] = &from.velocity(a, cell);
      stride[a] = a == 0 ? 1 : a == 1 ? fluid.f.pitch : fluid.f.plane;
    }
    scale = Real(from.constant / (fluid.model.smagorinsky * fluid.model.smagorinsky));
  }

  KOKKOS_FORCEINLINE_FUNCTION void operator()(int x) const
  {
    Real gradient[L::D][L::D];
    std::uint8_t const here = side[x];
    bool whole = here != 0;
    core::static_for<L::D>([&](auto a) __attribute__((always_inline)) {
      int const before = x - stride[a], after = x + stride[a];
      whole = whole & (side[before] == here) & (side[after] == here);
      core::static_for<L::D>([&](auto b) __attribute__((always_inline)) {
        gradient[a][b] = (u[b][after] - u[b][before]) / 2;
      });
    });
    Real const ratio = viscosity_ratio(gradient);
    share[x] = whole ? Real(scale * ratio) : Real(0);
  }
};

/// A row on one thread. The copy, and inlining, let the loop be vectorised.
template <class Row>
[[gnu::flatten]] inline void sweep(Row const& of, int length)
{
  Row const row = of;
#pragma GCC ivdep
  for (int x = 0; x < length; ++x) row(x);
}

/// Applies Row to each row of the box.
template <class Row, class Real, class L, class Stored>
void rows_on_host(Fluid<Real, L, Stored> const& fluid, Vreman<Real> const& vreman)
{
  int const rows = fluid.ny * fluid.nz, ny = fluid.ny;
  Kokkos::parallel_for("velum::lbm::vreman_rows", Kokkos::RangePolicy<Space>(0, rows), [=](int r) {
    sweep(Row(fluid, vreman, fluid.cell(0, r % ny, r / ny)), fluid.nx);
  });
}

template <class Row, class Real, class L, class Stored>
void rows_on_device(Fluid<Real, L, Stored> const& fluid, Vreman<Real> const& vreman)
{
  using Team = Kokkos::TeamPolicy<Space>;
  Fluid<Real, L, Stored> const box = fluid;
  Vreman<Real> const scratch = vreman;
  Kokkos::parallel_for(
      "velum::lbm::vreman_teams", Team(fluid.ny * fluid.nz, 128),
      KOKKOS_LAMBDA(typename Team::member_type const& team) {
        int const r = team.league_rank();
        Row const row(box, scratch, box.cell(0, r % box.ny, r / box.ny));
        Kokkos::parallel_for(Kokkos::TeamThreadRange(team, box.nx), [&](int x) { row(x); });
      });
}

template <class Row, class Real, class L, class Stored>
void each_row(Fluid<Real, L, Stored> const& fluid, Vreman<Real> const& vreman)
{
  if constexpr (on_host)
    rows_on_host<Row>(fluid, vreman);
  else
    rows_on_device<Row>(fluid, vreman);
}

/// Fills the ring beyond one side of the box: from the layer within it where it mirrors, else from
/// the layer at the other side.
template <class Real, class L, class Stored>
void fill_ring(Fluid<Real, L, Stored> const& fluid, Vreman<Real> const& vreman, int axis,
               bool upper, bool image)
{
  Fluid<Real, L, Stored> const box = fluid;
  Vreman<Real> const to = vreman;
  int const size[3] = {fluid.nx, fluid.ny, fluid.nz};
  int const stride = axis == 0 ? 1 : axis == 1 ? fluid.f.pitch : fluid.f.plane;
  int const layer = upper ? size[axis] - 1 : 0, out = upper ? stride : -stride;
  int const back = image ? 0 : (size[axis] - 1) * out;
  int const m0 = axis == 0 ? size[1] : size[0];
  Kokkos::parallel_for(
      "velum::lbm::vreman_ring", fluid.cells() / size[axis], KOKKOS_LAMBDA(int n) {
        int const p = n % m0, q = n / m0;
        int const i = axis == 0 ? layer : p;
        int const j = axis == 0 ? p : axis == 1 ? layer : q;
        int const k = axis == 2 ? layer : q;
        int const cell = box.cell(i, j, k), from = cell - back;
        for (int a = 0; a < L::D; ++a) {
          Real const u = to.velocity(a, from);
          to.velocity(a, cell + out) = image && a == axis ? -u : u;
        }
        to.side(cell + out) = to.side(from);
      });
}

template <class Real, class L, class Stored>
void fill_rings(Fluid<Real, L, Stored> const& fluid, Vreman<Real> const& vreman)
{
  for (int axis = 0; axis < L::D; ++axis)
    for (bool upper : {false, true}) {
      bool const periodic = fluid.model.periodic(axis);
      bool const mirrors = (fluid.model.mirrors & mirror(axis, upper)) != 0 ||
                           (axis == 1 && !upper && fluid.has_axis());
      if (periodic || mirrors) fill_ring(fluid, vreman, axis, upper, !periodic);
    }
}

}  // namespace

template <class Real, class L, class Stored>
Vreman<Real> make_vreman(Fluid<Real, L, Stored> const& fluid, double constant)
{
  core::require(fluid.eddy_share.extent(0) > 0 && fluid.model.smagorinsky > 0,
                "Vreman's eddy viscosity needs a Smagorinsky constant above zero to act through.");
  std::size_t const cells = fluid.eddy_share.extent(0);
  return {constant, Kokkos::View<Real**, Kokkos::LayoutRight>("vreman_velocity", L::D, cells),
          CellMask("vreman_side", cells)};
}

template <class Real, class L, class Stored>
void set_vreman_share(Fluid<Real, L, Stored>& fluid, Vreman<Real> const& vreman)
{
  each_row<VelocityRow<Real, L, Stored>>(fluid, vreman);
  fill_rings(fluid, vreman);
  each_row<ShareRow<Real, L, Stored>>(fluid, vreman);
}

#define VELUM_INSTANTIATE(Real, L, Stored)                                  \
  template Vreman<Real> make_vreman(Fluid<Real, L, Stored> const&, double); \
  template void set_vreman_share(Fluid<Real, L, Stored>&, Vreman<Real> const&);
VELUM_EACH_FLUID(VELUM_INSTANTIATE)
#undef VELUM_INSTANTIATE

}  // namespace velum::lbm
