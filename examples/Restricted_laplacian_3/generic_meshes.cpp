// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The same problem on three mesh data structures, with the same function: nothing in the package
// depends on the type of the mesh.

#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#ifdef RESTRICTED_LAPLACIAN_3_WITH_OPENMESH
// OpenMesh copies points that it has not set yet.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
// after OpenMesh itself
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>
#endif

#include <algorithm>
#include <exception>
#include <iostream>
#include <limits>

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
#ifdef RESTRICTED_LAPLACIAN_3_WITH_OPENMESH
struct Open_mesh_traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d; // the default is single precision
};
using Open_mesh = OpenMesh::TriMesh_ArrayKernelT<Open_mesh_traits>;
#endif

// Solves Laplacian u = z, with z the third coordinate without its mean.
template <typename TriangleMesh> void solve(const char* name, const TriangleMesh& mesh) {
  // a property map that works for every mesh
  auto u = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
  const auto z = [](const RL::Surface_point& s) { return s.point.z(); };

  const RL::Solve_report report = RL::solve_poisson(mesh, z, u, params::depth(5));

  double low = std::numeric_limits<double>::infinity(), high = -low;
  for(const auto v : vertices(mesh)) {
    low = std::min(low, get(u, v));
    high = std::max(high, get(u, v));
  }
  std::cout << name << ": u is between " << low << " and " << high << " after " << report.iterations
            << " iterations\n";
}

int main(int argc, char* argv[]) {
  Surface_mesh surface_mesh;
  if(argc != 2 || !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], surface_mesh)) {
    std::cerr << "usage: generic_meshes MESH\n";
    return 1;
  }
  try {
    solve("Surface_mesh", surface_mesh);

    Polyhedron polyhedron;
    CGAL::copy_face_graph(surface_mesh, polyhedron);
    solve("Polyhedron_3", polyhedron);

#ifdef RESTRICTED_LAPLACIAN_3_WITH_OPENMESH
    Open_mesh open_mesh;
    CGAL::copy_face_graph(surface_mesh, open_mesh);
    solve("OpenMesh", open_mesh);
#endif
  } catch(const std::exception& e) {
    std::cerr << "generic_meshes: " << e.what() << '\n';
    return 1;
  }
  return 0;
}
