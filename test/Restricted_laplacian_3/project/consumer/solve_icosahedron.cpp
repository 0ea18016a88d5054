// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Restricted_laplacian_3/solve_poisson.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

namespace RL = CGAL::Restricted_laplacian_3;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main() {
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1.);
  const auto f = mesh.add_property_map<Mesh::Vertex_index, double>("f").first;
  const auto u = mesh.add_property_map<Mesh::Vertex_index, double>("u").first;
  for(const Mesh::Vertex_index v : mesh.vertices())
    f[v] = mesh.point(v).z();

  const auto report = RL::solve_poisson(mesh, f, u, RL::parameters::depth(3));

  // Laplacian u = z has, by the symmetry of the icosahedron, a solution that is odd in z and of
  // the opposite sign.
  double product = 0;
  for(const Mesh::Vertex_index v : mesh.vertices())
    product += f[v] * u[v];
  return report.converged && product < 0 ? 0 : 1;
}
