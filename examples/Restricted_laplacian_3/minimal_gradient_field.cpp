// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Restricted_laplacian_3/integrate_gradient_field.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using Mesh = CGAL::Surface_mesh<RL::Point_3>;
using Values = std::array<double, 3>;

int main(int argc, char* argv[]) try {
  Mesh mesh;
  if(argc != 2 || !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "usage: minimal_gradient_field MESH\n";
    return 1;
  }
  // three functions, known at the vertices, and their gradients on the triangles
  auto known = mesh.add_property_map<Mesh::Vertex_index, Values>("v:known").first;
  for(Mesh::Vertex_index v : vertices(mesh)) {
    const RL::Point_3& p = mesh.point(v);
    known[v] = {std::sin(2 * p.x()), std::sin(2 * p.y()), p.x() * p.z()};
  }
  const auto gradients = RL::vertex_gradients(mesh, known);

  // Back to the functions. A weight of 1e-3 / area pulls them to the known values, which is just
  // enough for their means.
  auto found = mesh.add_property_map<Mesh::Vertex_index, Values>("v:found").first;
  const auto np = params::depth(5).target(known).alpha(1e-3 / RL::read_surface(mesh).area());
  // with what is smaller than the cells of the splines, and without
  for(const bool details : {false, true}) {
    const RL::Gradient_report report =
        RL::integrate_gradient_field(mesh, gradients, found, np.details(details));
    if(!report.converged)
      return 1;
    double largest = 0;
    for(Mesh::Vertex_index v : vertices(mesh))
      for(std::size_t k = 0; k < 3; ++k)
        largest = std::max(largest, std::abs(found[v][k] - known[v][k]));
    std::cout << (details ? "with details" : "splines") << ": largest error " << largest
              << " after " << report.iterations << " iterations\n";
  }
  return 0;
} catch(const std::exception& e) {
  std::cerr << "minimal_gradient_field: " << e.what() << '\n';
  return 1;
}
