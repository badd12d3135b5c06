#pragma once
#include "structure/load.hpp"
#include "structure/membrane.hpp"
#include "structure/sheet.hpp"

#include <Eigen/SparseCore>

#include <span>

namespace velum::structure {

/// Rayleigh damping: force -(alpha M + beta K0) v. Rayleigh, The Theory of Sound (1877),
/// section 81.
struct Rayleigh {
  double alpha = 0;  ///< 1 / time
  double beta = 0;   ///< time
};

/// Stiffness at the positions x, made symmetric positive semi-definite element by element: where an
/// element is compressed, its negative eigenvalues (buckling) are left out, so that damping never
/// feeds energy. K0 of the law is that of the flat, unloaded state: pass m.reference.   [2N][2N]
Eigen::SparseMatrix<double> damping_stiffness(Membrane const& m, Eigen::VectorXd const& x);
Eigen::SparseMatrix<double> damping_stiffness(Sheet const& s, Eigen::VectorXd const& x);

/// The same with the stiffness at rest of the body's own loads (bending).
template <class Body>
Eigen::SparseMatrix<double> damping_stiffness(Body const& m, Eigen::VectorXd const& x,
                                              std::span<Load const> elastic);

}  // namespace velum::structure
