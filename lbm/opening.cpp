#include "lbm/opening.hpp"

#include <cmath>

#include "lbm/formats.hpp"
#include "lbm/moments.hpp"

namespace velum::lbm {

namespace {

constexpr double sound = 0.57735026918962576;  // 1/sqrt(3)
constexpr double relaxation = 0.2;             // of the velocity per step, damps the feedback loop
constexpr double integral_gain = 2e-4;  // per step; below c_s / 4L for chambers up to 700 cells

/// Velocity of the opening imposed by the half-way rule, whatever the distance q: an opening is
/// where the scene puts it, and mass stays exact.
template <class Real, class L, class Stored>
void impose_velocity(Fluid<Real, L, Stored>& fluid, Opening& opening, double U)
{
  Fluid<Real, L, Stored> const to = fluid;
  auto const links = opening.links.links;
  auto const n = opening.normal;
  double mass = 0, momentum = 0;
  Kokkos::parallel_reduce(
      "velum::lbm::opening_velocity", opening.links.size,
      KOKKOS_LAMBDA(int k, double& m, double& p) {
        Link const l = links(k);
        int const cell = to.cell(l.i, l.j, l.k);
        double const cn = along<L>(l.dir, n);
        Real const out = to.f.outgoing(l.dir, cell);
        Real const back = out - Real(6 * L::w(l.dir) * l.weight * U * cn);
        to.f.set_arriving(L::opposite(l.dir), cell, back);
        double const ring = link_ring<L>(to.symmetry, to.origin[1] + l.j + 0.5, l.dir);
        m += ring * double(back - out);
        p -= ring * cn * double(back + out);
      },
      mass, momentum);
  opening.velocity = U;
  opening.mass_flow = mass;
  opening.traction = momentum / opening.area - U * U;
}

/// Anti-bounce-back at the pressure opening.pressure. Of an outflow it is an equilibrium that is
/// sent back: the full population would come back undamped, and at low viscosity a vortex that
/// passes, or mere noise, would grow between the opening and the cells before it.
template <class Real, class L, class Stored>
void impose_pressure(Fluid<Real, L, Stored>& fluid, Opening& opening, bool outflow)
{
  Fluid<Real, L, Stored> const to = fluid;
  auto const links = opening.links.links;
  auto const n = opening.normal;
  double const rho_b = 3 * opening.pressure;
  double mass = 0, momentum = 0;
  Kokkos::parallel_reduce(
      "velum::lbm::opening_pressure", opening.links.size,
      KOKKOS_LAMBDA(int k, double& m, double& p) {
        Link const l = links(k);
        int const cell = to.cell(l.i, l.j, l.k), o = L::opposite(l.dir);
        Real site[L::Q], rho;
        core::Vec<Real, L::D> j;
        for (int d = 0; d < L::Q; ++d) site[d] = to.f.outgoing(d, cell);
        density_and_momentum<L>(site, rho, j);
        core::Vec<double, L::D> u;
        double inflow = 0, u2 = 0;
        for (int a = 0; a < L::D; ++a) {
          u[a] = double(j[a]) / (1 + rho);
          inflow += u[a] * n[a];
        }
        if (outflow && inflow > 0) u = {};
        for (int a = 0; a < L::D; ++a) u2 += u[a] * u[a];
        double const cu = along<L>(l.dir, u);
        double const kinetic = 4.5 * cu * cu - 1.5 * u2;
        Real const out = site[l.dir];
        Real back = -out + Real(2 * L::w(l.dir) * (rho_b + (1 + rho_b) * kinetic));
        if (outflow)
          back = Real(equilibrium<L>(o, inflow > 0 ? rho_b : 2 * rho_b - double(rho), u));
        to.f.set_arriving(o, cell, back);
        double const ring = link_ring<L>(to.symmetry, to.origin[1] + l.j + 0.5, l.dir);
        m += ring * double(back - out);
        p -= ring * along<L>(l.dir, n) * double(back + out);
      },
      mass, momentum);
  opening.mass_flow = mass;
  opening.velocity = mass / opening.area;
  opening.traction = momentum / opening.area - opening.velocity * opening.velocity;
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
      opening.integral += integral_gain * wanted;
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
  template void apply(Fluid<Real, L, Stored>&, Opening&, double);
VELUM_EACH_FLUID(VELUM_INSTANTIATE)
#undef VELUM_INSTANTIATE

}  // namespace velum::lbm
