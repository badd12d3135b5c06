#pragma once
#include "structure/enclosure.hpp"
#include "structure/newton_matrix.hpp"

#include <Eigen/LU>

namespace velum::structure {

/// Enclosed volumes in an implicit step of length h: their pressures at its end,
///   (C/h + G) p' = C/h p + q - A^T vbar,   vbar = (x' - x) / h,
/// push with A p'. Newton's matrix gains A (C + h G)^-1 A^T, which is left out of its factors and
/// put back by Woodbury's formula.
struct EnclosedNewton {
  Enclosures* volumes = nullptr;  // none
  Eigen::VectorXd pressure;       // p', of the last call of push()
  Eigen::MatrixXd answer;         // matrix^-1 A on the free components   [dN][m]
  Eigen::PartialPivLU<Eigen::MatrixXd> small;
  Eigen::MatrixXd area;  // A on the free components
};

/// Adds A p' for a mean velocity.
inline void push(EnclosedNewton& e, Eigen::VectorXd const& mean, double h, Eigen::VectorXd& force)
{
  if (!e.volumes) return;
  Enclosures const& v = *e.volumes;
  Eigen::MatrixXd matrix = v.conductance;
  matrix.diagonal() += v.compliance / h;
  Eigen::VectorXd const given =
      v.compliance.cwiseProduct(v.pressure) / h + v.inflow - v.area.transpose() * mean;
  e.pressure = matrix.partialPivLu().solve(given);
  force += v.area * e.pressure;
}

/// After the matrix has been factorised for a step of length h.
inline void prepare(EnclosedNewton& e, NewtonMatrix const& newton, std::vector<char> const& fixed,
                    double h)
{
  if (!e.volumes) return;
  e.area = e.volumes->area;
  for (Eigen::Index i = 0; i < e.area.rows(); ++i)
    if (fixed[static_cast<std::size_t>(i)]) e.area.row(i).setZero();
  e.answer.resize(e.area.rows(), e.area.cols());
  for (Eigen::Index k = 0; k < e.area.cols(); ++k) e.answer.col(k) = solve(newton, e.area.col(k));
  Eigen::MatrixXd matrix = h * e.volumes->conductance + e.area.transpose() * e.answer;
  matrix.diagonal() += e.volumes->compliance;
  e.small.compute(matrix);
}

/// The correction for a residual, the volumes' stiffness included.
inline Eigen::VectorXd correction(EnclosedNewton const& e, NewtonMatrix const& newton,
                                  Eigen::VectorXd const& residual)
{
  Eigen::VectorXd x = solve(newton, residual);
  if (e.volumes) x -= e.answer * e.small.solve(e.area.transpose() * x);
  return x;
}

}  // namespace velum::structure
