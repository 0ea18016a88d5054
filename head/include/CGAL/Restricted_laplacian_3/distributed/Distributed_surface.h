// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_SURFACE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_SURFACE_H

#include <CGAL/Restricted_laplacian_3/distributed/Communicator.h>
#include <CGAL/Restricted_laplacian_3/distributed/Rank_ranges.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

class Octree_3;

/// \ingroup PkgRestrictedLaplacian3Distributed
/// What one rank has read of a surface: some consecutive vertices and some consecutive faces. Those
/// of rank 0 come first, and so on. Of a point set, points take the place of both.
struct Surface_slice {
  /// the vertices
  std::vector<Point_3> points;
  /// the faces: numbers of vertices of the whole surface; empty if it is a point set
  std::vector<Triangulated_surface_3::Triangle> triangles;
  /// the normals of the points of a point set, of any length but 0
  std::vector<Vector_3> normals;
  /// the areas that the points of a point set stand for
  std::vector<double> areas;
  /// whether it is a point set
  bool is_point_set = false;
};

/// \ingroup PkgRestrictedLaplacian3Dev
/// Some faces of a surface, with their vertices, on one rank.
struct Surface_part {
  /// the faces and vertices, in the order that they have in the whole surface, with its bounding
  /// box; a face without area if there is none
  Triangulated_surface_3 surface;
  /// the numbers of the faces in the whole surface, ascending; empty if there is none
  std::vector<std::uint32_t> faces;
  /// those of the vertices
  std::vector<std::uint32_t> vertices;
};

/// \ingroup PkgRestrictedLaplacian3Distributed
/// A surface of which each rank holds a slice.
class Distributed_surface {
public:
  /// \param communicator the ranks
  /// \param slice what this rank has
  /// \throws Distributed_error on all ranks, with the message of the exception that a
  /// `Triangulated_surface_3` of the whole would throw. Numbers of faces and vertices are those in
  /// the whole surface.
  Distributed_surface(const Communicator& communicator, Surface_slice slice);

  /// the ranks
  const Communicator& communicator() const { return m_communicator; }
  /// the faces of the slice of this rank
  const Surface_part& slice() const { return m_slice.front(); }
  /// the vertices of the slice of this rank
  const std::vector<Point_3>& points() const { return m_points; }
  /// whether it is a point set
  bool is_point_set() const { return m_is_point_set; }
  /// of the whole surface
  std::uint64_t number_of_vertices() const { return m_first_vertices.back(); }
  /// of the whole surface
  std::uint64_t number_of_faces() const { return m_number_of_faces; }
  /// of the whole surface
  std::uint64_t number_of_degenerate_faces() const { return m_number_of_degenerate_faces; }
  /// area of the whole surface
  double area() const { return m_area; }

  /// numbers of the first vertex of the slice of each rank, and of all vertices
  const std::vector<std::uint64_t>& first_vertices() const { return m_first_vertices; }

  /// Ranges of cells with about the same work: the sum of what is to be done for the fragments of
  /// triangles and, in proportion to the area, for unknowns.
  /// \param octree with the domain cube and depth, levels are not needed
  Rank_ranges balanced_ranges(const Octree_3& octree) const;

  /// The faces that meet the cells of this rank, or come near to them.
  /// \param octree with the domain cube and depth, levels are not needed
  /// \param ranges the cells of each rank
  /// \param margin how near, in units of the finest cells
  Surface_part part(const Octree_3& octree, const Rank_ranges& ranges, double margin) const;

private:
  struct Vertex_record {
    std::uint32_t vertex;
    Point_3 point;
    Vector_3 normal;
    double area;
  };
  struct Face_record {
    std::uint32_t face;
    Triangulated_surface_3::Triangle vertices;
  };

  std::uint32_t first_vertex() const;
  std::vector<Face_record> own_faces(const Surface_slice& slice, std::uint64_t first_face) const;
  std::vector<Vertex_record> own_vertices(const Surface_slice& slice) const;
  /// the vertices of faces that other ranks have, by rank
  std::vector<std::vector<std::uint32_t>> far_vertices(const std::vector<Face_record>& faces) const;
  /// \param vertices own ones, then far ones in the order of their numbers
  void find_box(const std::vector<Face_record>& faces, const std::vector<Vertex_record>& vertices);
  void find_area();
  /// \param vertices may come more than once
  Surface_part make_part(const std::vector<Face_record>& faces,
                         std::vector<Vertex_record> vertices) const;

  Communicator m_communicator;
  bool m_is_point_set;
  std::vector<std::uint64_t> m_first_vertices;
  std::uint64_t m_number_of_faces = 0, m_number_of_degenerate_faces = 0;
  double m_area = 0;
  Point_3 m_low, m_high;
  std::vector<Point_3> m_points;
  std::vector<Surface_part> m_slice; // one
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_surface_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_SURFACE_H
