// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The default constructor of OpenMesh's vectors leaves the coordinates open, and its property
// arrays copy such vectors; GCC reports that where it is inlined, so for the whole file.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include "mesh_types.h"

#include <CGAL/Restricted_laplacian_3/input/read_surface.h>

#include <array>
#include <vector>

namespace {

using namespace mesh_types;

struct Double_traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};

} // namespace

TEMPLATE_TEST_CASE("solution_does_not_depend_on_the_type_of_the_openmesh_mesh", "[mesh_types]",
                   OpenMesh::TriMesh_ArrayKernelT<>, OpenMesh::PolyMesh_ArrayKernelT<>,
                   OpenMesh::TriMesh_ArrayKernelT<Double_traits>,
                   OpenMesh::PolyMesh_ArrayKernelT<Double_traits>) {
  TestType mesh = converted<TestType>(shapes::mesh(surface()));
  check_mesh_type(mesh);

  // removed elements do not count before, nor after the collection of garbage
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_face_status();
  std::vector<typename TestType::VertexHandle> corners;
  for(const auto& p : {std::array<float, 3>{9, 0, 0}, {0, 9, 0}, {0, 0, 9}})
    corners.push_back(mesh.add_vertex(typename TestType::Point(p[0], p[1], p[2])));
  mesh.delete_face(mesh.add_face(corners[0], corners[1], corners[2]), true);
  check_mesh_type(mesh);
  mesh.garbage_collection();
  check_mesh_type(mesh);
}

TEST_CASE("square_of_an_openmesh_mesh_is_divided", "[mesh_types]") {
  OpenMesh::PolyMesh_ArrayKernelT<> mesh =
      converted<OpenMesh::PolyMesh_ArrayKernelT<>>(shapes::mesh(surface()));
  const std::size_t number_of_faces = mesh.n_faces();
  std::vector<OpenMesh::VertexHandle> corners;
  for(const auto& p : {std::array<float, 2>{0, 0}, {1, 0}, {1, 1}, {0, 1}})
    corners.push_back(mesh.add_vertex({p[0], p[1], 5}));
  mesh.add_face(corners);
  const RL::Triangulated_surface_3 s = RL::read_surface(mesh);
  REQUIRE(s.number_of_faces() == number_of_faces + 2);
  CHECK(s.polygon(number_of_faces) == number_of_faces);
  CHECK(s.polygon(number_of_faces + 1) == number_of_faces);
  CHECK(s.area(number_of_faces) + s.area(number_of_faces + 1) == Approx(1));
}
