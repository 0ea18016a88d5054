// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MEAN_CURVATURE_FLOW_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MEAN_CURVATURE_FLOW_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/problems/Flow_report.h>
#include <CGAL/Restricted_laplacian_3/problems/Moved_integration.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <Eigen/Core>

#include <optional>
#include <string>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Problems
/// What a `Mean_curvature_flow` keeps by scaling the surface, about the centroid of its area, after
/// each step.
enum class Rescaling {
  /// nothing: the surface is where it flows
  none,
  /// the area of the first surface
  area,
  /// the volume inside the first surface, which has to be closed
  volume
};

/// \ingroup PkgRestrictedLaplacian3Options
/// How a `Mean_curvature_flow` works: the named parameters of its constructor.
struct Mean_curvature_flow_options {
  /// the metric of the energy remains that of the first surface, as if the flow were conformal;
  /// this flow passes where the other one collapses
  bool conformal = false;
  /// without a value `Rescaling::area` if it is conformal, and none else
  std::optional<Rescaling> rescaling;
  /// whether the boundary of an open surface stays where it is; it is free otherwise
  bool fixed_boundary = true;
  /// of the linear systems; a hundredth of it with a fixed boundary, whose penalty is most of their
  /// right-hand sides
  double tolerance = 1e-6;
  /// factor \f$c\f$ of the stabilization; without a value `default_stabilization()`
  std::optional<double> stabilization;

  /// the defaults
  Mean_curvature_flow_options() = default;
  /// what is among named parameters, and the defaults else
  template <class NamedParameters, internal::Require_named_parameters<NamedParameters> = 0>
  Mean_curvature_flow_options(const NamedParameters& np) {
    internal::read_parameter(np, internal_np::conformal, conformal);
    internal::read_parameter(np, internal_np::rescaling, rescaling);
    internal::read_parameter(np, internal_np::fixed_boundary, fixed_boundary);
    internal::read_parameter(np, internal_np::tolerance, tolerance);
    internal::read_parameter(np, internal_np::stabilization, stabilization);
  }
};

/// \ingroup PkgRestrictedLaplacian3Problems
/// Mean-curvature flow of a surface, \f$\partial_t x = \Delta x = -2 H n\f$, with its positions as
/// splines on the first surface, and the metric of the moved one \cgalCite{CK11b}. A step of length
/// \f$\tau\f$ is semi-implicit:
/// \f[ (M_n + \tau S_n)\, x_{n+1} = M_n\, x_n \f]
/// with the matrices of `Moved_integration` at \f$x_n\f$. A sphere of radius \f$r\f$ shrinks as
/// \f$\sqrt{r^2 - 4 t}\f$, with an error of first order in \f$\tau\f$.
///
/// *Conformal.* With \f$S_0\f$ in place of \f$S_n\f$ it is the flow of Kazhdan, Solomon and
/// Ben-Chen \cgalCite{KSBC12}: a surface without holes and handles becomes a sphere, and the map to
/// it is conformal in the end.
///
/// *Collapse.* The other flow makes necks thinner until they vanish, in finite time. Where more
/// than a thousandth of the surface has shrunk to a twentieth along a direction, or numbers leave
/// their range, the step is not taken, and the report says why. So `time()` is that of the
/// singularity, up to a step or two.
///
/// A step takes time in proportion to the number of fragments of triangles in cells, for one
/// assembly, and of the elements, for a multigrid hierarchy and three right-hand sides.
class Mean_curvature_flow {
public:
  /// \param space of the first surface, a mesh; is copied, which costs nothing
  /// \param options named parameters, or the options themselves:
  /// \cgalNamedParamsBegin
  ///   \named_of_flow
  ///   \named_usual_stabilization
  /// \cgalNamedParamsEnd
  /// \throws Parameter_error if an option is outside its domain
  /// \throws Input_error the surface is a set of points, or has a boundary, but its volume is to be
  /// kept
  explicit Mean_curvature_flow(const Spline_space_3& space,
                               const Mean_curvature_flow_options& options = {});

  /// Goes on by a time, unless that makes the surface collapse.
  /// \param time_step \f$\tau\f$, positive, in units of squared length
  /// \throws Parameter_error if it is not
  Flow_report step(double time_step);

  /// the space, of the first surface
  const Spline_space_3& space() const { return m_space; }
  /// since the beginning, in units of squared length
  double time() const { return m_time; }
  /// the positions as functions on the first surface, three of them
  Spline_functions_3 positions() const { return Spline_functions_3(m_space, m_positions); }
  /// the coefficients of these functions: a row for each element, three columns
  const Eigen::MatrixXd& coefficients() const { return m_positions; }
  /// The positions of the vertices, a row for each: those of the splines, and for vertices without
  /// a face of positive area the first ones. Before the first step they are the vertices
  /// themselves, up to what splines leave of corners and edges.
  const Eigen::MatrixXd& vertex_positions() const { return m_at_vertices; }
  /// the space with the metric of the moved surface
  Spline_space_3 moved_space() const {
    return m_space.integrated_by(Moved_integration(m_space, m_positions));
  }

private:
  /// of coefficients, at the vertices
  Eigen::MatrixXd at_vertices(const Eigen::MatrixXd& positions) const;
  /// why the vertices cannot move there, empty if they can
  std::string collapse(const Eigen::MatrixXd& after) const;
  /// scales positions, and those at the vertices, about the centroid
  void rescale(Eigen::MatrixXd& positions, const Eigen::MatrixXd& at_vertices) const;

  Spline_space_3 m_space;
  Mean_curvature_flow_options m_options;
  double m_time = 0;
  Sparse_matrix m_evaluation; // at the vertices
  Eigen::MatrixXd m_positions, m_at_vertices;
  Eigen::MatrixXd m_first; // vertices
  double m_first_area, m_first_volume;
  bool m_is_closed;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/problems/Mean_curvature_flow_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MEAN_CURVATURE_FLOW_H
