// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SPACE_SPECTRUM_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SPACE_SPECTRUM_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/explain_out_of_memory.h>
#include <CGAL/Restricted_laplacian_3/problems/internal/level_estimate.h>
#include <CGAL/Restricted_laplacian_3/problems/internal/require_enough_points.h>
#include <CGAL/Restricted_laplacian_3/problems/space_spectrum.h>

#include <CGAL/Restricted_laplacian_3/assembly/cotangent_operators.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Disjoint_sets.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/memory.h>
#include <CGAL/Restricted_laplacian_3/problems/multigrid_levels.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/search_depth.h>
#include <CGAL/Restricted_laplacian_3/spectra/shared/nested_iteration.h>
#include <CGAL/Restricted_laplacian_3/spectra/smallest_eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>
#include <CGAL/Restricted_laplacian_3/splines/estimate_memory.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

/// sets eigenvalues and report
inline void take_pairs(Eigenpairs&& pairs, Eigensolver eigensolver, Laplace_spectrum& spectrum) {
  spectrum.pairs = std::move(pairs);
  spectrum.eigensolver = eigensolver;
  spectrum.eigenvalues = spectrum.pairs.values;
  spectrum.report.set_status(spectrum.pairs.status);
  spectrum.report.iterations = spectrum.pairs.iterations;
  spectrum.report.relative_residuals.clear();
  spectrum.report.relative_residual = 0;
  for(double residual : spectrum.pairs.residuals) {
    spectrum.report.relative_residuals.push_back(residual);
    spectrum.report.relative_residual = (std::max)(spectrum.report.relative_residual, residual);
  }
}

/// Sets estimated errors and extrapolated eigenvalues, if all pairs were found.
/// \param coarser_values of coarser levels, coarsest first
inline void estimate_errors(const Spline_space_3& space,
                            const std::vector<Eigen::VectorXd>& coarser_values,
                            Laplace_spectrum& spectrum) {
  const Eigen::VectorXd& values = spectrum.eigenvalues;
  const std::size_t number = coarser_values.size();
  if(number == 0 || !spectrum.report.converged || coarser_values.back().size() != values.size())
    return;
  const Eigen::VectorXd& last = coarser_values.back();
  // what is smaller is 0
  constexpr double part_of_natural_distance = 1e-6;
  const double smallest = -part_of_natural_distance * natural_shift(space.surface().area());
  const auto changes = [&](const Eigen::VectorXd& coarse, const Eigen::VectorXd& fine) {
    const Eigen::ArrayXd scale = values.array().max(smallest);
    return Eigen::VectorXd(
        (values.array() > smallest).select(((coarse - fine).array() / scale).abs(), 0.).matrix());
  };
  const Eigen::VectorXd errors = changes(last, values);
  const double largest = errors.maxCoeff(),
               before = number > 1 ? changes(coarser_values[number - 2], last).maxCoeff()
                                   : std::numeric_limits<double>::quiet_NaN();
  spectrum.report.estimated_error = error_of_changes(largest, before);
  spectrum.report.is_estimate_trusted = is_resolved(space);
  spectrum.estimated_errors =
      largest > 0 ? Eigen::VectorXd(errors * (spectrum.report.estimated_error / largest)) : errors;
  spectrum.extrapolated_eigenvalues = (4 * values - last) / 3;
}

/// The coarsest level whose eigenvalues are compared with those of the finest, by factorizations.
inline int coarsest_level_of_estimate(const Spline_space_3& space, int k) {
  constexpr int most_levels = 2;
  const auto least_dimension =
      static_cast<std::size_t>(unknowns_of_a_start_vector) * static_cast<std::size_t>(k);
  int level = space.depth();
  while(!space.is_paper_space() && level > 0 && level > space.depth() - most_levels &&
        space.dimension(level - 1) >= least_dimension)
    --level;
  return level;
}

/// the eigenvalues of levels, coarsest first: of those after the last one on which they are not all
/// found
inline std::vector<Eigen::VectorXd> eigenvalues_of_levels(const std::vector<Operators>& levels,
                                                          int k) {
  std::vector<Eigen::VectorXd> result;
  for(const auto& [stiffness, mass] : levels) {
    Eigenpairs pairs;
    try {
      pairs = smallest_eigenpairs(stiffness, mass, k);
    } catch(const Numerical_error&) { // as if there were none
    }
    if(pairs.values.size() == k)
      result.push_back(std::move(pairs.values));
    else
      result.clear();
  }
  return result;
}

/// Whether a space has more parts than a number, which no sheet has in common.
inline bool has_more_components(const Spline_space_3& space, std::size_t number) {
  const int depth = space.depth();
  Disjoint_sets components(space.dimension());
  for(std::size_t sheet = 0; sheet < space.number_of_sheets(depth); ++sheet) {
    std::uint32_t first = Spline_space_3::no_element;
    for(const std::uint32_t element : space.elements(depth, sheet))
      if(element != Spline_space_3::no_element) {
        if(first == Spline_space_3::no_element)
          first = element;
        components.unite(first, element);
      }
  }
  std::size_t found = 0;
  for(std::uint32_t i = 0; i < space.dimension(); ++i)
    found += components.find(i) == i;
  return found > number;
}

/// Whether `multigrid_eigenpairs()` is used.
inline bool uses_multigrid(const Spline_space_3& space, double stabilization,
                           const Laplace_spectrum_options& options) {
  constexpr std::size_t smallest_dimension = 5000; // with fewer a factorization is as fast
  // Equal parts have equal eigenvalues. One vector at a time finds those in turn, by rounding
  // errors; a block of vectors finds them at once.
  constexpr std::size_t few_components = 4;
  if(options.eigensolver == Eigensolver::multigrid && space.is_paper_space())
    throw Parameter_error("eigensolver", "must not be multigrid in the space of the paper, whose "
                                         "levels are not nested");
  return options.eigensolver == Eigensolver::multigrid ||
         (options.eigensolver == Eigensolver::automatic && !space.is_paper_space() &&
          stabilization > 0 &&
          (space.dimension() >= smallest_dimension || has_more_components(space, few_components)));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigenpairs
multigrid_eigenpairs_of(const Spline_space_3& space, int coarsest, std::vector<Operators> operators,
                        int k, const Multigrid_eigenpairs_options& options) {
  std::vector<Sparse_matrix> stiffness(operators.size()), mass(operators.size());
  for(std::size_t i = 0; i < operators.size(); ++i) {
    stiffness[i].swap(operators[i].stiffness);
    mass[i].swap(operators[i].mass);
  }
  Multigrid_levels levels = multigrid_levels(space, coarsest);
  return multigrid_eigenpairs(std::move(stiffness), std::move(mass),
                              std::move(levels.prolongations), std::move(levels.patches), k,
                              options);
}

/// bytes that `k` pairs take for each unknown, without values at the vertices
inline double bytes_of_unknown(int k) {
  // measured: matrices when they are made; what an iteration needs of them; each of its vectors,
  // for a pair
  constexpr double of_matrices = 6000, of_levels = 1500, of_pair = 40;
  return (std::max)(of_matrices, of_levels + of_pair * k);
}

/// bytes that `k` pairs take with their space, at most at one time
inline double memory_of_pairs(const Spline_space_3& space, int k, bool with_vertex_values) {
  const auto dimension = static_cast<double>(space.dimension()),
             vertices = static_cast<double>(space.surface().number_of_vertices());
  const double solver = dimension * bytes_of_unknown(k),
               // the vectors are there twice
      values = with_vertex_values ? sizeof(double) * k * (vertices + 2 * dimension) : 0;
  return memory_of_space(space.surface(), 0).total() + (std::max)(solver, values);
}

/// bytes that a factorization and `k` pairs by it take
inline double memory_of_factorization(const Spline_space_3& space, int k) {
  // of an unknown, measured: matrices and factor; two vectors for a pair in the Krylov space, and
  // those that are found
  constexpr double of_factor = 12000, of_pair = 40;
  return memory_of_space(space.surface(), 0).total() +
         static_cast<double>(space.dimension()) * (of_factor + of_pair * k);
}

/// Whether an iteration of `multigrid_eigenpairs()` that has not converged is to be followed by a
/// factorization: not if it ended as the caller has asked it to.
inline bool tries_factorization(const Spline_space_3& space, int k, const Eigenpairs& pairs,
                                const Laplace_spectrum_options& options) {
  const bool has_stalled =
      pairs.status == Solve_status::stalled ||
      (pairs.status == Solve_status::iteration_limit &&
       options.multigrid.maximum_iterations >= Multigrid_eigenpairs_options().maximum_iterations);
  return options.eigensolver == Eigensolver::automatic && has_stalled &&
         memory_of_factorization(space, k) <= *space.options().maximum_memory;
}

/// \throws Parameter_error if `k` is not positive, or if so many pairs, perhaps with values at the
/// vertices, would take more memory than the space may have
inline void check_number_of_pairs(const Spline_space_3& space, int k, bool with_vertex_values) {
  if(k < 1)
    throw Parameter_error("count", "is " + std::to_string(k) + ", but must be positive");
  const double maximum = *space.options().maximum_memory,
               needed = memory_of_pairs(space, k, with_vertex_values);
  if(!(needed > maximum))
    return;
  int possible = 0;
  for(int too_many = k; too_many - possible > 1;) {
    const int middle = possible + (too_many - possible) / 2;
    (memory_of_pairs(space, middle, with_vertex_values) > maximum ? too_many : possible) = middle;
  }
  std::string reason = "is " + std::to_string(k) + ", which would take about " +
                       memory_text(needed) + " of memory, and " + memory_text(maximum) +
                       " are there";
  reason += possible > 0 ? "; " + std::to_string(possible) + " would fit"
                         : std::string("; not even one would fit: choose a smaller depth");
  if(with_vertex_values && memory_of_pairs(space, k, false) <= maximum)
    reason += "; without values at the vertices they would take " +
              memory_text(memory_of_pairs(space, k, false));
  throw Parameter_error("count", reason);
}

/// Computes pairs by a factorization, and takes them if their residuals are smaller than those that
/// are there.
inline void factorize(const Spline_space_3& space, int k, double stabilization,
                      const Multigrid_eigenpairs_options& options, Laplace_spectrum& spectrum) {
  const std::vector<Operators> operators = assemble_operators_of_levels(
      space, space.depth(), space.depth(), stabilization, Stabilized::stiffness, {});
  Eigenpairs_options of_factorization;
  of_factorization.progress = options.progress;
  Eigenpairs pairs;
  try {
    pairs = smallest_eigenpairs(operators[0].stiffness, operators[0].mass, k, of_factorization);
  } catch(const Numerical_error&) { // what is there remains
    return;
  }
  if(pairs.values.size() < k || !(pairs.residuals.maxCoeff() < spectrum.report.relative_residual))
    return;
  // Spectra has a tolerance of its own.
  if(!(pairs.residuals.maxCoeff() <=
       options.tolerance.value_or(Multigrid_eigenpairs_options::default_tolerance))) {
    pairs.set_status(Solve_status::stalled);
  }
  take_pairs(std::move(pairs), Eigensolver::shift_invert, spectrum);
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Laplace_spectrum
laplace_eigenpairs(const Spline_space_3& space, int k, const Laplace_spectrum_options& options) {
  internal::check_number_of_pairs(space, k, false);
  internal::require_enough_points(space);
  const double stabilization =
      options.stabilization.value_or(default_spectrum_stabilization(space));
  const bool is_multigrid = internal::uses_multigrid(space, stabilization, options);
  Laplace_spectrum spectrum;
  CGAL::Real_timer timer;
  timer.start();
  constexpr double part_of_assembly = 0.15;
  const internal::Progress progress(options.multigrid.progress);
  const internal::Progress of_solver = progress.part(part_of_assembly, 1);
  const int coarsest = is_multigrid ? internal::coarsest_multigrid_level(space)
                                    : internal::coarsest_level_of_estimate(space, k);
  std::vector<Eigen::VectorXd> coarser_values;
  std::vector<Operators> operators = assemble_operators_of_levels(
      space, coarsest, space.depth(), stabilization, Stabilized::stiffness,
      progress.part(0, part_of_assembly).callback());
  spectrum.report.assembly_seconds = timer.time();
  if(is_multigrid) {
    Multigrid_eigenpairs_options of_multigrid = options.multigrid;
    of_multigrid.is_parallel = space.options().is_parallel;
    of_multigrid.progress = of_solver.callback();
    of_multigrid.eigenvalues_only = options.eigenvalues_only;
    if(options.eigenvalues_only && !of_multigrid.tolerance)
      of_multigrid.tolerance = Laplace_spectrum_options::tolerance_of_eigenvalues;
    internal::explain_out_of_memory("not enough memory for the eigenvectors", [&] {
      internal::take_pairs(
          internal::multigrid_eigenpairs_of(space, coarsest, std::move(operators), k, of_multigrid),
          Eigensolver::multigrid, spectrum);
    });
    coarser_values.swap(spectrum.pairs.coarser_values);
    if(internal::tries_factorization(space, k, spectrum.pairs, options))
      internal::factorize(space, k, stabilization, of_multigrid, spectrum);
  } else {
    Eigenpairs_options of_factorization;
    of_factorization.progress = of_solver.callback();
    internal::take_pairs(
        smallest_eigenpairs(operators.back().stiffness, operators.back().mass, k, of_factorization),
        Eigensolver::shift_invert, spectrum);
    operators.pop_back();
    coarser_values = internal::eigenvalues_of_levels(operators, k);
  }
  internal::estimate_errors(space, coarser_values, spectrum);
  progress(1);
  spectrum.report.solve_seconds = timer.time() - spectrum.report.assembly_seconds;
  spectrum.area = space.surface().area();
  return spectrum;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Laplace_spectrum
laplace_spectrum(const Spline_space_3& space, int k, const Laplace_spectrum_options& options) {
  internal::check_number_of_pairs(space, k, !options.eigenvalues_only);
  Laplace_spectrum result = laplace_eigenpairs(space, k, options);
  if(!options.eigenvalues_only)
    result.vertex_values = Spline_functions_3(space, result.pairs.vectors).values_at_vertices();
  return result;
}

namespace internal {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Laplace_spectrum laplace_eigenpairs_to_accuracy(
    Spline_space_3& space, int count, const Laplace_spectrum_options& given, double accuracy) {
  // with fewer unknowns for each pair the last ones are not even similar
  constexpr std::size_t unknowns_of_a_pair = 20;
  Laplace_spectrum_options options = given;
  check_number_of_pairs(space, count, false);
  Depth_search_options of_search;
  of_search.bytes_of_unknown = bytes_of_unknown(count);
  of_search.least_dimension = unknowns_of_a_pair * static_cast<std::size_t>(count);
  Laplace_spectrum spectrum;
  Eigen::VectorXd before;
  search_depth(space, accuracy, Progress(given.multigrid.progress), of_search,
               [&](const Progress& progress) {
                 options.multigrid.progress = progress.callback();
                 spectrum = laplace_eigenpairs(space, count, options);
                 // after a space without an estimate comes the next level
                 if(std::isnan(spectrum.report.estimated_error))
                   estimate_errors(space, {before}, spectrum);
                 before = spectrum.eigenvalues;
                 return Found_in_space{&spectrum.report, {}};
               });
  return spectrum;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Laplace_spectrum laplace_spectrum_to_accuracy(
    Spline_space_3& space, int count, const Laplace_spectrum_options& options, double accuracy) {
  check_number_of_pairs(space, count, !options.eigenvalues_only);
  Laplace_spectrum result = laplace_eigenpairs_to_accuracy(space, count, options, accuracy);
  if(!options.eigenvalues_only)
    result.vertex_values = Spline_functions_3(space, result.pairs.vectors).values_at_vertices();
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Laplace_spectrum
cotangent_eigenpairs(const Triangulated_surface_3& surface, int k, bool lumped_mass) {
  CGAL::Real_timer timer;
  timer.start();
  const Operators operators = cotangent_operators(surface, lumped_mass);
  Laplace_spectrum spectrum;
  spectrum.report.assembly_seconds = timer.time();
  take_pairs(smallest_eigenpairs(operators.stiffness, operators.mass, k), Eigensolver::shift_invert,
             spectrum);
  spectrum.report.solve_seconds = timer.time() - spectrum.report.assembly_seconds;
  spectrum.area = surface.area();
  spectrum.vertex_values = spectrum.pairs.vectors;
  const Eigen::VectorXd diagonal = operators.mass.diagonal();
  for(Eigen::Index v = 0; v < diagonal.size(); ++v)
    if(diagonal[v] == 0)
      spectrum.vertex_values.row(v).setConstant(std::numeric_limits<double>::quiet_NaN());
  return spectrum;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SPACE_SPECTRUM_IMPL_H
