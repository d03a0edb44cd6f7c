// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>

namespace roomatlas::test {

using VectorFunction = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// Central differences; the error is of the order of step^2.
inline Eigen::MatrixXd numeric_jacobian(const VectorFunction& function, const Eigen::VectorXd& at,
                                        double step = 1e-6) {
  Eigen::MatrixXd jacobian(function(at).size(), at.size());
  for (Eigen::Index i = 0; i < at.size(); ++i) {
    Eigen::VectorXd above = at;
    Eigen::VectorXd below = at;
    above(i) += step;
    below(i) -= step;
    jacobian.col(i) = (function(above) - function(below)) / (2.0 * step);
  }
  return jacobian;
}

}  // namespace roomatlas::test
