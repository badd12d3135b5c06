#pragma once
#include "structure/damping.hpp"
#include "structure/enclosure.hpp"
#include "structure/load.hpp"
#include "structure/membrane.hpp"
#include "structure/node_blocks.hpp"
#include "structure/sheet.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>

#include <memory>
#include <span>
#include <variant>
#include <vector>

namespace velum::structure {

/// What the explicit scheme keeps between calls: its matrices and its memory.
struct ExplicitStepper {
  template <class Ordering>
  using Ldlt = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Upper, Ordering>;
  /// A chain's factors fill nothing as its nodes are numbered; those of a mesh would its bandwidth.
  using Solver = std::variant<Ldlt<Eigen::NaturalOrdering<int>>, Ldlt<Eigen::AMDOrdering<int>>>;
  Rayleigh damping;
  Eigen::VectorXd mass;            ///< lumped                        [N]
  Eigen::SparseMatrix<double> K0;  ///< of the reference state
  Eigen::SparseMatrix<double> A;   ///< implicit matrix, pattern of K0
  std::vector<int> diagonal;       ///< entries of A of each node's own block, column by column
  std::unique_ptr<Solver> solver;  ///< pattern analysed once
  Eigen::VectorXd force, rhs, prescribed, mean;  ///< working memory
};

/// Stepper of a body (a Membrane or a Sheet) with the stiffness of its reference state in the
/// damping; with beta = 0 the matrix couples no two nodes.
template <class Body>
ExplicitStepper explicit_stepper(Body const& m, Rayleigh const& damping);

/// The same with the stiffness of a given state: without bending the flat state has no stiffness
/// across, and beta would damp stretching alone.   state: [2N or 3N]
/// @param elastic  loads of the body's own (bending), whose stiffness at rest is damped too
template <class Body>
ExplicitStepper explicit_stepper(Body const& m, Rayleigh const& damping,
                                 Eigen::VectorXd const& state, std::span<Load const> elastic = {});

/// Advances position and velocity by dt in equal sub-steps of length h, symplectic Euler with the
/// damping and the wall block Z implicit in the velocity:
///   (M + h (alpha M + beta K0 + Z)) v' = M v + h (F0 + sum of loads(x) + elastic force(x)),
///   x' = x + h v'.
/// Returns the mean of v' over the sub-steps, vbar: the impulse of the force F0 - Z v on a free
/// node is dt (F0 - Z vbar) exactly. Prescribed components keep their velocity. Stable for
/// h < stable_step().
/// @param F0        force at zero wall velocity
/// @param Z         symmetric positive semi-definite block per node, or empty [N]
/// @param enclosed  volumes whose pressures push the body, found with v' (enclosure.hpp), or null
/// @return          valid until the next call                                 [2N]
/// Throws core::Divergence where the motion is no longer finite.
template <class Body>
Eigen::VectorXd const& advance(ExplicitStepper& stepper, Body& m, Eigen::VectorXd const& F0,
                               std::span<NodeBlock<Body> const> Z, double dt, int substeps,
                               std::span<Load const> loads, Enclosures* enclosed = nullptr);

}  // namespace velum::structure
