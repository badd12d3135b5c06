// problem:    planar strip (unit depth) of uneven thickness, clamped, pulled or pushed in its plane
// reference:  incompressible plane strain: force per depth T = mu H (l - l^-3), the same everywhere
// measure:    reaction at the far end; stretch of each of the two parts
// tolerance:  1e-10 relative
// why:        constant stretch is in the space of linear elements: exact but for the solver's 1e-10
#include "structure/internal_force.hpp"
#include "structure/line_element.hpp"
#include "structure/membrane.hpp"
#include "structure/static_solve.hpp"

#include <gtest/gtest.h>

namespace velum::structure {
namespace {

TEST(Strip, follows_the_plane_strain_law)
{
  double const mu = 2, H1 = 0.1, H2 = 0.3;
  auto m = flat_membrane({core::Symmetry::planar, -1, 1, 0.1,
                          [&](double y) { return y < 0 ? H1 : H2; }, neo_hookean_rubber(mu), 1});
  for (double const end : {1.2, 2.0, 3.5}) {
    int const last = 2 * node_count(m) - 1;
    m.position[last] = end;
    static_solve(m, {});
    Eigen::VectorXd force = Eigen::VectorXd::Zero(m.position.size());
    add_elastic_force(m, m.position, force);
    double const thin = line_element(m, m.position, 0).l1;
    double const thick = line_element(m, m.position, element_count(m) - 1).l1;
    auto const T = [&](double H, double l) { return mu * H * (l - 1 / (l * l * l)); };
    EXPECT_NEAR(thin + thick, end + 1, 1e-10);
    EXPECT_NEAR(-force[last], T(H1, thin), 1e-9);
    EXPECT_NEAR(-force[last], T(H2, thick), 1e-9);
    EXPECT_GT(thin, thick);
  }
}

}  // namespace
}  // namespace velum::structure
