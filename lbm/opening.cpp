#include "lbm/opening.hpp"

#include <cmath>

#include "lbm/moments.hpp"

namespace velum::lbm {

namespace {

constexpr double sound = 0.57735026918962576;  // 1/sqrt(3)
constexpr double relaxation = 0.2;             // of the velocity per step, damps the feedback loop
constexpr double integral_gain = 2e-4;  // per step; below c_s / 4L for chambers up to 700 cells
constexpr double slow_steps = 5000;     // memory of the outflow's mean velocity

/// Velocity of the opening imposed by the half-way rule, whatever the distance q: an opening is
/// where the scene puts it, and mass stays exact.
template <class Real>
void impose_velocity(Fluid<Real>& fluid, Opening& opening, double U)
{
  auto const f = fluid.f;
  auto const links = opening.links.links;
  auto const symmetry = fluid.symmetry;
  auto const n = opening.normal;
  double const y0 = fluid.origin[1];
  double mass = 0, momentum = 0;
  Kokkos::parallel_reduce(
      "velum::lbm::opening_velocity", opening.links.size,
      KOKKOS_LAMBDA(int k, double& m, double& p) {
        Link const l = links(k);
        int const o = D2Q9::opposite(l.dir), cx = D2Q9::cx(l.dir), cy = D2Q9::cy(l.dir);
        double const cn = cx * n[0] + cy * n[1];
        Real const out = f(l.dir, l.j + 1, l.i + 1);
        Real const back = out - Real(6 * D2Q9::w(l.dir) * l.weight * U * cn);
        f(o, l.j + 1 + cy, l.i + 1 + cx) = back;
        double const ring = link_ring(symmetry, y0 + l.j + 0.5, l.dir);
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
template <class Real>
void impose_pressure(Fluid<Real>& fluid, Opening& opening, bool outflow)
{
  auto const f = fluid.f;
  auto const links = opening.links.links;
  auto const symmetry = fluid.symmetry;
  auto const n = opening.normal;
  double const y0 = fluid.origin[1], rho_b = 3 * opening.pressure;
  double mass = 0, momentum = 0;
  Kokkos::parallel_reduce(
      "velum::lbm::opening_pressure", opening.links.size,
      KOKKOS_LAMBDA(int k, double& m, double& p) {
        Link const l = links(k);
        int const o = D2Q9::opposite(l.dir), cx = D2Q9::cx(l.dir), cy = D2Q9::cy(l.dir);
        Real site[9], rho, jx, jy;
        for (int d = 0; d < 9; ++d) site[d] = f(d, l.j + 1, l.i + 1);
        density_and_momentum(site, rho, jx, jy);
        double ux = double(jx) / (1 + rho), uy = double(jy) / (1 + rho);
        double const inflow = ux * n[0] + uy * n[1];
        if (outflow && inflow > 0) ux = uy = 0;
        double const cu = cx * ux + cy * uy;
        double const kinetic = 4.5 * cu * cu - 1.5 * (ux * ux + uy * uy);
        Real const out = site[l.dir];
        Real back = -out + Real(2 * D2Q9::w(l.dir) * (rho_b + (1 + rho_b) * kinetic));
        if (outflow)
          back = equilibrium<Real>(o, inflow > 0 ? Real(rho_b) : Real(2 * rho_b) - rho, Real(ux),
                                   Real(uy));
        f(o, l.j + 1 + cy, l.i + 1 + cx) = back;
        double const ring = link_ring(symmetry, y0 + l.j + 0.5, l.dir);
        m += ring * double(back - out);
        p -= ring * (cx * n[0] + cy * n[1]) * double(back + out);
      },
      mass, momentum);
  opening.mass_flow = mass;
  opening.velocity = mass / opening.area;
  opening.traction = momentum / opening.area - opening.velocity * opening.velocity;
}

}  // namespace

template <class Real>
double opening_area(Fluid<Real> const& fluid, std::vector<Link> const& links, core::Vec2 normal)
{
  double area = 0;
  for (Link const& l : links)
    area += 6 * D2Q9::w(l.dir) *
            std::abs(D2Q9::cx(l.dir) * normal[0] + D2Q9::cy(l.dir) * normal[1]) *
            link_ring(fluid.symmetry, fluid.origin[1] + l.j + 0.5, l.dir);
  return area;
}

template <class Real>
void apply(Fluid<Real>& fluid, Opening& opening, double target)
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
      opening.slow_velocity += (opening.velocity - opening.slow_velocity) / slow_steps;
      return;
    }
  }
}

template double opening_area(Fluid<float> const&, std::vector<Link> const&, core::Vec2);
template double opening_area(Fluid<double> const&, std::vector<Link> const&, core::Vec2);
template void apply(Fluid<float>&, Opening&, double);
template void apply(Fluid<double>&, Opening&, double);

}  // namespace velum::lbm
