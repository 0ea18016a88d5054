// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Matrices of Eigen in, vectors out: a row of V is a vertex, a row of F a face. There is no mesh
// data structure.

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/input/vertex_functions.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>

#include <iostream>

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;

// Solves Laplacian u = f, with f and u at the vertices. Rows are a range of points, or faces.
Eigen::VectorXd solve(const Eigen::MatrixXd& V, const Eigen::MatrixXi& F,
                      const Eigen::VectorXd& f) {
  Eigen::VectorXd u(V.rows());
  const RL::Solve_report report =
      RL::solve_poisson(RL::soup(V.rowwise(), F.rowwise()), CGAL::make_property_map(f.data()),
                        CGAL::make_property_map(u.data()), params::depth(5));
  std::cout << to_string(report.status) << '\n';
  return u;
}

// One implicit step of the heat flow, (M + time S) eta = load, with the matrices in sight. Their
// rows belong to splines: vertices come in with the load, and out with the values at the end.
Eigen::VectorXd diffuse(const Eigen::MatrixXd& V, const Eigen::MatrixXi& F,
                        const Eigen::VectorXd& f, double time) {
  const RL::Spline_space_3 space(RL::soup(V.rowwise(), F.rowwise()), params::depth(5));
  const RL::Operators operators = RL::assemble_operators(space);
  std::cout << V.rows() << " vertices; S has " << operators.stiffness.rows() << " rows\n";
  const auto function = RL::vertex_function(space.surface(), CGAL::make_property_map(f.data()));
  const Eigen::VectorXd load = RL::assemble_load(space, function);
  const RL::Poisson_solver solver(space, operators, 1 / time);
  Eigen::VectorXd eta;
  std::cout << to_string(solver.solve(load / time, eta).status) << '\n';
  const std::vector<double> values = RL::Spline_function_3(space, eta).values_at_vertices();
  return Eigen::Map<const Eigen::VectorXd>(values.data(), V.rows());
}

int main() {
  const int n = 40; // the unit square, divided into n x n squares
  Eigen::MatrixXd V((n + 1) * (n + 1), 3);
  for(int v = 0; v < V.rows(); ++v)
    V.row(v) << double(v / (n + 1)) / n, double(v % (n + 1)) / n, 0;
  Eigen::MatrixXi F(n * n, 4);
  for(int i = 0; i < F.rows(); ++i)
    F.row(i) << i + i / n, i + i / n + n + 1, i + i / n + n + 2, i + i / n + 1;
  // an eigenfunction: its Laplacian is -pi^2 f, and it does not change across the boundary
  const Eigen::VectorXd f = (CGAL_PI * V.col(0).array()).cos();
  const Eigen::VectorXd u = solve(V, F, f), g = diffuse(V, F, f, 0.1);
  std::cout << "largest error of u: " << (u + f / (CGAL_PI * CGAL_PI)).cwiseAbs().maxCoeff()
            << "\nlargest error after a step: "
            << (g - f / (1 + 0.1 * CGAL_PI * CGAL_PI)).cwiseAbs().maxCoeff() << '\n';
}
