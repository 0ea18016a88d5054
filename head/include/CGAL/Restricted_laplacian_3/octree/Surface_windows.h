// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_SURFACE_WINDOWS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_SURFACE_WINDOWS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_view.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Grid_vertices.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {
class Faces_in_coarse_cells;
} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Dev
/// A division of a surface of triangles into *windows* that can be worked on one after the other,
/// or far from each other, with a part of the memory that the whole would take.
///
/// A window is a range of the finest cells of an octree in Morton order, together with the faces
/// that may have a fragment in these cells, or that are near to them. Each cell is in one window;
/// a face may be in several. Windows begin at cells of a coarse level, `level()`, and hold about
/// the same number of fragments, as far as a few large faces or many small ones in one coarse cell
/// allow.
///
/// Takes time linear in the number of faces plus the number of coarse cells that large faces meet,
/// and 4 bytes for each face of each window; none if there is one window.
class Surface_windows {
public:
  /// largest `level()`
  static constexpr int largest_level = 7;

  /// \param surface a surface of triangles; it is read here only
  /// \param vertices of the surface in the grid of the finest cells
  /// \param number_of_fragments about how many are wanted in a window, at least 1
  /// \param margin distance, in units of the finest cells, from the cells of a window up to which
  /// all faces belong to the window as well
  /// \param is_parallel whether several threads are used, if the program is linked with TBB; the
  /// windows are the same
  Surface_windows(const Triangulated_surface_3& surface, const internal::Grid_vertices& vertices,
                  std::size_t number_of_fragments, double margin = 0, bool is_parallel = false);

  /// number of windows, at least 1
  std::size_t size() const { return m_first_cells.size() - 1; }

  /// The cells of this level are not divided among windows: \f$\min(d, 7)\f$ for an octree of depth
  /// \f$d\f$.
  int level() const { return m_level; }

  /// a half-open range of Morton keys of finest cells
  std::array<std::uint64_t, 2> cells(std::size_t window) const {
    CGAL_precondition(window < size());
    return {m_first_cells[window] << m_shift, m_first_cells[window + 1] << m_shift};
  }

  /// The faces of a window, ascending: all that have a fragment in its cells, or come as near as
  /// the margin to one of them, and perhaps others whose bounding box does.
  internal::Number_view faces(std::size_t window) const {
    CGAL_precondition(window < size());
    if(size() == 1)
      return internal::Number_view(m_number_of_faces);
    return {m_faces.data() + m_first_faces[window],
            m_first_faces[window + 1] - m_first_faces[window]};
  }

  /// an estimate of the number of fragments of the surface, within some percent for triangles that
  /// are either small or large compared with the cells
  double estimated_number_of_fragments() const { return m_estimated_number_of_fragments; }

private:
  /// sets `m_first_cells`
  void divide(const internal::Faces_in_coarse_cells& faces, double number_of_windows,
              bool is_parallel);
  /// sets `m_first_faces` and `m_faces`
  void distribute(const internal::Faces_in_coarse_cells& faces, bool is_parallel);

  int m_level;
  int m_shift; // from keys of the finest cells to those of the level
  std::size_t m_number_of_faces;
  double m_estimated_number_of_fragments = 0;
  std::vector<std::uint64_t> m_first_cells; // of windows, on the level, and one more
  std::vector<std::size_t> m_first_faces;   // of windows, and one more
  std::vector<std::uint32_t> m_faces;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/octree/Surface_windows_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_SURFACE_WINDOWS_H
