// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What solve_poisson() does, one step at a time: for several right-hand sides, for the function
// between the vertices, and for its gradient.

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh.h>

namespace RL = CGAL::Restricted_laplacian_3;

int main(int argc, char* argv[]) {
  CGAL::Surface_mesh<RL::Point_3> mesh;
  if(argc != 2 || !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "usage: laplacian_steps MESH\n";
    return 1;
  }
  // 1. The space of functions. Its size depends on the depth, not on the number of faces.
  const RL::Spline_space_3 space(mesh, RL::parameters::depth(5));
  const double area = space.surface().area();
  std::cout << space.dimension() << " functions on a surface of area " << area << '\n';

  // 2. Matrices, as those of Eigen. The functions sum to 1, hence the entries of the mass matrix
  //    sum to the area, and the stiffness matrix annihilates constants.
  const RL::Operators operators = RL::assemble_operators(space);
  std::cout << "entries of the mass matrix sum to " << operators.mass.sum() << '\n';

  // 3. Right-hand sides: the integral of each function times a coordinate. Laplacian u = f is
  //    (stiffness matrix) (coefficients of u) = -(integrals of f).
  Eigen::MatrixXd right_hand_sides(space.dimension(), 3);
  for(int axis = 0; axis < 3; ++axis)
    right_hand_sides.col(axis) =
        -RL::assemble_load(space, [axis](const RL::Surface_point& s) { return s.point[axis]; });

  // 4. One solver for all of them.
  const RL::Poisson_solver solver(space, operators);
  Eigen::MatrixXd coefficients;
  const RL::Solve_report report = solver.solve(right_hand_sides, coefficients);
  std::cout << report.iterations << " iterations, relative residual " << report.relative_residual
            << '\n';

  // 5. A solution is a function on the whole surface: here in the middle of the first triangle.
  const RL::Surface_location middle = {0, {1. / 3, 1. / 3, 1. / 3}};
  for(int axis = 0; axis < 3; ++axis) {
    const Eigen::VectorXd x = coefficients.col(axis);
    const RL::Spline_function_3 u(space, x);
    std::cout << "u" << axis << " = " << u.value(middle) << ", gradient " << u.gradient(middle)
              << ", Dirichlet energy " << x.dot(operators.stiffness * x) << '\n';
  }
}
