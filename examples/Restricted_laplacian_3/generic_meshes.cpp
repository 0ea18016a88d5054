// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The same problem on three mesh data structures, with the same function: nothing in the package
// depends on the type of the mesh.

#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <algorithm>

#ifdef RESTRICTED_LAPLACIAN_3_WITH_OPENMESH
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
// after OpenMesh itself
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

struct Open_mesh_traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d; // the default is single precision
};
using Open_mesh = OpenMesh::TriMesh_ArrayKernelT<Open_mesh_traits>;
#endif

namespace RL = CGAL::Restricted_laplacian_3;

// Solves Laplacian u = z, with z the third coordinate without its mean.
template <typename Mesh> void solve(const char* name, const Mesh& mesh) {
  // a property map that works for every mesh
  auto u = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
  const auto z = [](const RL::Surface_point& s) { return s.point.z(); };
  const RL::Solve_report report = RL::solve_poisson(mesh, z, u, RL::parameters::depth(5));
  double largest = 0;
  for(auto v : vertices(mesh))
    largest = std::max(largest, get(u, v));
  std::cout << name << ": u is at most " << largest << " after " << report.iterations
            << " iterations\n";
}

int main(int argc, char* argv[]) {
  CGAL::Surface_mesh<RL::Point_3> surface_mesh;
  if(argc != 2 || !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], surface_mesh)) {
    std::cerr << "usage: generic_meshes MESH\n";
    return 1;
  }
  solve("Surface_mesh", surface_mesh);

  CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>> polyhedron;
  CGAL::copy_face_graph(surface_mesh, polyhedron);
  solve("Polyhedron_3", polyhedron);

#ifdef RESTRICTED_LAPLACIAN_3_WITH_OPENMESH
  Open_mesh open_mesh;
  CGAL::copy_face_graph(surface_mesh, open_mesh);
  solve("OpenMesh", open_mesh);
#endif
}
