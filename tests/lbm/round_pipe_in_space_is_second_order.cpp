// problem:   Poiseuille flow through a round pipe in space, driven by a body force, one cell long
//            and periodic, its axis off the grid and along z, x or y; walls at their true distance.
//            TRT with magic 3/16 and central moments, D3Q19 and D3Q27, nu = 0.2, 2 R U / nu = 1
// reference: u = F/(4 rho nu) (R^2 - r^2), with the density that is there: interpolated walls let a
//            little mass through, step by step
// measure:   L2 norm over the section of the error of the velocity along the axis, over that of the
//            velocity; speed across it over the largest; once they change by less than 1e-8 in
//            R^2/nu
// tolerance: order at least 1.8 over R = 6.1, 9.2, 13.6, 20.3; error below 0.2 % at R = 20.3; the
//            three axes the same to 1e-6; across 3e-4
// why:       interpolated walls and the collision are second order; where the wall cuts the links
//            changes with R, so the errors scatter a little about that (2.15 to 2.32 seen). The
//            flow across is D3Q19's, whose third moments are not isotropic: largest with TRT
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/flow.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/order.hpp"

namespace velum {
namespace {

struct Pipe {
  double radius;
  int axis;
  lbm::Collision collision;
};

constexpr double nu = 0.2;

int width(Pipe const& pipe) { return int(2 * pipe.radius) + 4; }

core::Vec3 on_axis(Pipe const& pipe)
{
  core::Vec3 at;
  at[(pipe.axis + 1) % 3] = width(pipe) / 2.0 + 0.17;
  at[(pipe.axis + 2) % 3] = width(pipe) / 2.0 - 0.29;
  return at;
}

double force(Pipe const& pipe) { return 4 * nu * nu / std::pow(pipe.radius, 3); }

template <class L>
auto make_pipe(Pipe const& pipe)
{
  int size[3] = {width(pipe), width(pipe), width(pipe)};
  size[pipe.axis] = 1;
  lbm::Model model{pipe.collision, nu, 3.0 / 16};
  model.body_force[pipe.axis] = force(pipe);
  (pipe.axis == 0 ? model.periodic_x : pipe.axis == 1 ? model.periodic_y : model.periodic_z) = true;
  core::Vec3 const middle = on_axis(pipe);
  core::Vec3 along;
  along[pipe.axis] = 10;
  auto const rock = core::subtract<3>(core::box<3>({-50, -50, -50}, {150, 150, 150}),
                                      core::cylinder(middle - along, middle + along, pipe.radius));
  return tests::make_flow(
      lbm::make_fluid<double, L>(size[0], size[1], {}, core::Symmetry::planar, model, size[2]),
      rock, [](lbm::WallHit const&) { return -1; });
}

struct Error {
  double along = 0, across = 0;
};

template <class L>
Error error(tests::Flow<double, L> const& flow, Pipe const& pipe)
{
  auto const state = lbm::cell_states(flow.fluid);
  auto const middle = on_axis(pipe);
  double const R = pipe.radius, top = force(pipe) / (4 * nu);
  double e2 = 0, u2 = 0;
  Error e;
  for (long n = 0; n < flow.fluid.cells(); ++n) {
    int const i = int(n % flow.fluid.nx), row = int(n / flow.fluid.nx);
    int const j = row % flow.fluid.ny, k = row / flow.fluid.ny;
    if (flow.walls.is_solid(i, j, k)) continue;
    core::Vec3 r = core::Vec3{i + 0.5, j + 0.5, k + 0.5} - middle;
    r[pipe.axis] = 0;
    double const exact = top * (R * R - dot(r, r)) / (1 + state(row, i).rho);
    double u[3] = {state(row, i).ux, state(row, i).uy, state(row, i).uz};
    e2 += std::pow(u[pipe.axis] - exact, 2);
    u2 += exact * exact;
    u[pipe.axis] = 0;
    e.across = std::max(e.across, std::hypot(u[0], u[1], u[2]) / (top * R * R));
  }
  e.along = std::sqrt(e2 / u2);
  return e;
}

template <class L>
Error steady_error(Pipe const& pipe)
{
  auto flow = make_pipe<L>(pipe);
  int const span = int(pipe.radius * pipe.radius / nu / 4);
  Error last{1, 1};
  for (int n = 0; n < 100; ++n) {
    for (int t = 0; t < span; ++t) tests::step(flow);
    Error const now = error<L>(flow, pipe);
    if (std::abs(now.along - last.along) + std::abs(now.across - last.across) < 1e-6) return now;
    last = now;
  }
  ADD_FAILURE() << "not steady, R " << pipe.radius;
  return last;
}

template <class L>
void expect_second_order()
{
  for (auto collision : {lbm::Collision::trt, lbm::Collision::central_moments}) {
    SCOPED_TRACE(testing::Message() << "D3Q" << L::Q << ", collision " << int(collision));
    std::vector<double> h, along;
    for (double R : {6.1, 9.2, 13.6, 20.3}) {
      auto const e = steady_error<L>({R, 2, collision});
      h.push_back(1 / R);
      along.push_back(e.along);
      EXPECT_LT(e.across, 3e-4) << R;
      std::printf("D3Q%d collision %d R %4.1f: error %.3e, across %.1e\n", L::Q, int(collision), R,
                  e.along, e.across);
    }
    std::printf("order %.2f\n", tests::order(h, along));
    EXPECT_GT(tests::order(h, along), 1.8);
    EXPECT_LT(along.back(), 2e-3);
  }
}

TEST(RoundPipe, IsSecondOrderOnD3Q19) { expect_second_order<lbm::D3Q19>(); }
TEST(RoundPipe, IsSecondOrderOnD3Q27) { expect_second_order<lbm::D3Q27>(); }

TEST(RoundPipe, IsTheSameAlongEveryAxis)
{
  for (auto collision : {lbm::Collision::trt, lbm::Collision::central_moments}) {
    double const z = steady_error<lbm::D3Q19>({6.1, 2, collision}).along;
    for (int axis : {0, 1})
      EXPECT_NEAR(steady_error<lbm::D3Q19>({6.1, axis, collision}).along / z, 1, 1e-6) << axis;
  }
}

}  // namespace
}  // namespace velum
