#pragma once
#include <Eigen/Core>
#include <vector>

#include "core/vec.hpp"

namespace velum::ibm {

/// What the fluid says to the structure in one step, lattice units.
struct Exchange {
  Eigen::VectorXd force;                 // F0, at wall velocity zero              [2N]
  std::vector<Eigen::Matrix2d> block;    // Z: the force is F0 - Z v                [N]
  std::vector<core::Vec2> link_area[2];  // per side: sum of 6 w c ring over links  [N]
  std::vector<double> pressure[2];       // per side: mean over the node's links    [N]
  std::vector<double> samples[2];        // weight of that mean, 0 = no link        [N]
  int link_count = 0;                    // links, or markers, that took part
};

/// Makes ready for the links of a new step.
inline void reset(Exchange& e, std::size_t nodes)
{
  e.force.setZero(static_cast<Eigen::Index>(2 * nodes));
  e.block.assign(nodes, Eigen::Matrix2d::Zero());
  for (int side : {0, 1}) {
    e.link_area[side].assign(nodes, {});
    e.pressure[side].assign(nodes, 0);
    e.samples[side].assign(nodes, 0);
  }
}

}  // namespace velum::ibm
