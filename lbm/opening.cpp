#include "lbm/opening.hpp"

#include <cmath>

#include "lbm/formats.hpp"
#include "lbm/moments.hpp"
#include "lbm/pressure.hpp"

namespace velum::lbm {

namespace {

constexpr double relaxation = 0.2;  // of the velocity per step, damps the feedback loop

/// Density less 1 and velocity of a cell, and the part of the velocity into the fluid.
template <int D>
struct Near {
  double rho, inflow;
  core::Vec<double, D> u;
};

template <class Real, class L, class Stored>
KOKKOS_FORCEINLINE_FUNCTION Near<L::D> near(Fluid<Real, L, Stored> const& fluid, int cell,
                                            core::Vec3 const& n)
{
  Real site[L::Q], rho;
  core::Vec<Real, L::D> j;
  for (int d = 0; d < L::Q; ++d) site[d] = fluid.f.outgoing(d, cell);
  density_and_momentum<L>(site, rho, j);
  Near<L::D> at{double(rho), 0, {}};
  for (int a = 0; a < L::D; ++a) {
    at.u[a] = double(j[a]) / (1 + rho);
    at.inflow += at.u[a] * n[a];
  }
  return at;
}

/// Fluid comes in at velocity U: the half-way rule, whatever the distance q. An opening is where
/// the scene puts it, and mass stays exact.
struct Enters {
  static constexpr bool looks_at_cell = false;
  core::Vec3 n;
  double U;

  template <class Real, class L, class Stored>
  KOKKOS_FUNCTION Real back(Fluid<Real, L, Stored> const& fluid, int cell, Link const& l,
                            Near<L::D> const&) const
  {
    Real const out = fluid.f.outgoing(l.dir, cell);
    return out - Real(6 * L::w(l.dir) * l.weight * U * along<L>(l.dir, n));
  }
};

/// Fluid leaves at velocity -U: what comes back is the equilibrium of the cell with U for the part
/// of its velocity through the opening. What goes past must be free to leave: held at zero there,
/// or sent back with all its population, it grows at low viscosity between the opening and the
/// cells before it; so do, in space, differences of the part through it when the half-way rule
/// mirrors them about U.
struct Leaves {
  static constexpr bool looks_at_cell = true;
  core::Vec3 n;
  double U;

  template <class Real, class L, class Stored>
  KOKKOS_FUNCTION Real back(Fluid<Real, L, Stored> const&, int, Link const& l,
                            Near<L::D> const& at) const
  {
    auto u = at.u;
    for (int a = 0; a < L::D; ++a) u[a] += (l.weight * U - at.inflow) * n[a];
    return Real(equilibrium<L>(L::opposite(l.dir), at.rho, u));
  }
};

/// Anti-bounce-back at density rho_b (less 1). Where fluid leaves it is an equilibrium that is sent
/// back: the full population would come back undamped, and at low viscosity a vortex that passes,
/// or mere noise, would grow between the opening and the cells before it.
struct AtPressure {
  static constexpr bool looks_at_cell = true;
  core::Vec3 n;
  double rho_b;
  bool still;  // whether what comes in brings no momentum

  template <class Real, class L, class Stored>
  KOKKOS_FUNCTION Real back(Fluid<Real, L, Stored> const& fluid, int cell, Link const& l,
                            Near<L::D> const& at) const
  {
    int const o = L::opposite(l.dir);
    if (at.inflow <= 0) return Real(equilibrium<L>(o, 2 * rho_b - at.rho, at.u));
    if (still) return Real(equilibrium<L>(o, rho_b, core::Vec<double, L::D>{}));
    return Real(equilibrium<L>(o, rho_b, at.u) + equilibrium<L>(l.dir, rho_b, at.u)) -
           fluid.f.outgoing(l.dir, cell);
  }
};

/// What comes in through an opening in a step, and its area as the profile weighs it.
struct Passage {
  double mass = 0, momentum = 0, area = 0;
  double convected = 0;  // momentum that the velocity of the cells carries through, where the
                         // rule looks at them
};

/// Sends back along every link what the rule says.
/// @param write  false: only sums what would come in
template <class Real, class L, class Stored, class Rule>
Passage send_back(Fluid<Real, L, Stored>& fluid, Opening const& opening, Rule const& rule,
                  bool write = true)
{
  Fluid<Real, L, Stored> const to = fluid;
  auto const links = opening.links.links;
  Passage sum;
  Kokkos::parallel_reduce(
      "velum::lbm::opening", opening.links.size,
      KOKKOS_LAMBDA(int k, double& mass, double& momentum, double& area, double& convected) {
        Link const l = links(k);
        int const cell = to.cell(l.i, l.j, l.k);
        double const cn = along<L>(l.dir, rule.n);
        Near<L::D> at{};
        if constexpr (Rule::looks_at_cell) at = near(to, cell, rule.n);
        Real const out = to.f.outgoing(l.dir, cell);
        Real const back = rule.back(to, cell, l, at);
        if (write) to.f.set_arriving(L::opposite(l.dir), cell, back);
        double const ring = link_ring<L>(to.symmetry, to.origin[1] + l.j + 0.5, l.dir);
        mass += ring * double(back - out);
        momentum -= ring * cn * double(back + out);
        double const part = -ring * 6 * L::w(l.dir) * l.weight * cn;
        area += part;
        convected += part * at.inflow * at.inflow;
      },
      sum.mass, sum.momentum, sum.area, sum.convected);
  return sum;
}

template <class Real, class L, class Stored>
void impose_velocity(Fluid<Real, L, Stored>& fluid, Opening& opening, double U)
{
  Passage sum;
  if (U >= 0) {
    sum = send_back(fluid, opening, Enters{opening.normal, U});
  } else {
    // the equilibrium leaves out a little mass; it is shared out so that the sum is as imposed
    auto const first = send_back(fluid, opening, Leaves{opening.normal, U}, false);
    double const lost = first.area > 0 ? U - first.mass / first.area : 0;
    sum = send_back(fluid, opening, Leaves{opening.normal, U + lost});
  }
  opening.velocity = U;
  opening.mass_flow = sum.mass;
  opening.traction = sum.momentum / opening.area - U * U;
}

template <class Real, class L, class Stored>
void impose_pressure(Fluid<Real, L, Stored>& fluid, Opening& opening, bool outflow)
{
  AtPressure rule{opening.normal, 3 * opening.pressure, outflow};
  if (!outflow) {
    auto const first = send_back(fluid, opening, rule, false);
    rule.rho_b += 3 * (opening.pressure - (first.momentum - first.convected) / first.area);
  }
  auto const sum = send_back(fluid, opening, rule);
  opening.mass_flow = sum.mass;
  opening.velocity = sum.mass / opening.area;
  opening.traction = (sum.momentum - sum.convected) / opening.area;
}

}  // namespace

template <class Real, class L, class Stored>
double opening_area(Fluid<Real, L, Stored> const& fluid, std::vector<Link> const& links,
                    core::Vec3 normal)
{
  double area = 0;
  for (Link const& l : links)
    area += 6 * L::w(l.dir) * std::abs(along<L>(l.dir, normal)) *
            link_ring<L>(fluid.symmetry, fluid.origin[1] + l.j + 0.5, l.dir);
  return area;
}

template <class Real, class L, class Stored>
double pressure_before(Fluid<Real, L, Stored> const& fluid, Opening const& opening)
{
  auto const from = fluid;
  auto const links = opening.links.links;
  core::Vec3 const n = opening.normal;
  double area = 0, force = 0;
  Kokkos::parallel_reduce(
      "velum::lbm::pressure_before", opening.links.size,
      KOKKOS_LAMBDA(int k, double& area, double& force) {
        Link const l = links(k);
        double const ring = link_ring<L>(from.symmetry, from.origin[1] + l.j + 0.5, l.dir);
        double const part = -ring * 6 * L::w(l.dir) * l.weight * along<L>(l.dir, n);
        auto const at = near(from, from.cell(l.i, l.j, l.k), n);
        area += part;
        force += part * pressure_of(from, at.rho, from.origin[1] + l.j + 0.5, at.u[1]) / 3;
      },
      area, force);
  return area > 0 ? force / area : 0;
}

template <class Real, class L, class Stored>
void apply(Fluid<Real, L, Stored>& fluid, Opening& opening, double target)
{
  switch (opening.kind) {
    case OpeningKind::velocity:
      return impose_velocity(fluid, opening, target);
    case OpeningKind::flow_rate:
      return impose_velocity(fluid, opening, target / opening.area);
    case OpeningKind::traction: {
      // the mean of two steps: at the lattice's own period of two steps the bare answer of
      // traction to velocity is so large that the loop would run away
      double const wanted = (target - (opening.traction + opening.last_traction) / 2) / sound;
      opening.last_traction = opening.traction;
      opening.integral += opening.gain * wanted;
      double const U = opening.velocity;
      return impose_velocity(fluid, opening, U + relaxation * (opening.integral + wanted - U));
    }
    case OpeningKind::pressure:
      opening.pressure = target;
      return impose_pressure(fluid, opening, false);
    case OpeningKind::outflow: {
      // outgoing velocity above its slow mean raises the pressure as a passing wave would
      double const wave = sound * (opening.slow_velocity - opening.velocity);
      opening.pressure += relaxation * (target + wave - opening.pressure);
      impose_pressure(fluid, opening, true);
      opening.slow_velocity += (opening.velocity - opening.slow_velocity) / opening.memory;
      return;
    }
  }
}

#define VELUM_INSTANTIATE(Real, L, Stored)                                              \
  template double opening_area(Fluid<Real, L, Stored> const&, std::vector<Link> const&, \
                               core::Vec3);                                             \
  template double pressure_before(Fluid<Real, L, Stored> const&, Opening const&);       \
  template void apply(Fluid<Real, L, Stored>&, Opening&, double);
VELUM_EACH_FLUID(VELUM_INSTANTIATE)
#undef VELUM_INSTANTIATE

}  // namespace velum::lbm
