// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_DIFFUSION_SOLVER_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_DIFFUSION_SOLVER_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/Dirichlet_boundary.h>
#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/symmetric_eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/problems/Diffusion_solver.h>
#include <CGAL/Restricted_laplacian_3/problems/internal/require_enough_points.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/values_over_surface.h>
#include <CGAL/Restricted_laplacian_3/problems/stabilization.h>

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// of the time, the parameter \f$\gamma\f$ of the linear systems
constexpr double part_of_diffusion_time = 0.25;

inline double checked_time(double time) {
  if(!(time > 0 && std::isfinite(time)))
    throw Parameter_error("time", "is " + std::to_string(time) + ", but must be positive");
  return time;
}

inline double checked_tolerance_of_diffusion(const Diffusion_options& options) {
  const double tolerance = options.tolerance.value_or(Diffusion_options::default_tolerance);
  if(!(tolerance > 0 && tolerance < 1))
    throw Parameter_error("tolerance",
                          "is " + std::to_string(tolerance) + ", but must be between 0 and 1");
  return tolerance;
}

/// What is computed of the operator \f$A\f$: \f$e^{-t A}\f$ for an initial function,
/// \f$\int_0^t e^{-s A}\, ds\f$ for a source, \f$A / (\alpha^2 + A^2)\f$ with
/// \f$\alpha = 1 / \gamma\f$ for a filter.
enum class Diffusion_function { exponential, integral, high_pass };

/// the function at \f$\lambda = (1 / \theta - 1) / \gamma\f$, divided by \f$\theta\f$
inline double diffusion_factor(Diffusion_function function, double time, double theta) {
  constexpr double smallest = 1e-14; // the function is 0, or nearly constant, beyond
  const double gamma = part_of_diffusion_time * time, t = (std::max)(theta, smallest),
               of_gamma = (std::max)(1 / t - 1, 0.), lambda = of_gamma / gamma;
  if(function == Diffusion_function::high_pass)
    return gamma * of_gamma / (1 + of_gamma * of_gamma) / t;
  if(function == Diffusion_function::exponential)
    return std::exp(-time * lambda) / t;
  return (lambda * time < 1e-8 ? time : -std::expm1(-time * lambda) / lambda) / t;
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double diffusion_time(double width) {
  if(!(width >= 0 && std::isfinite(width)))
    throw Parameter_error("width", "is " + std::to_string(width) + ", but must not be negative");
  return width * width / (16 * std::log(2.));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Diffusion_solver::Diffusion_solver(const Spline_space_3& space, double time,
                                   const Diffusion_options& options,
                                   const Surface_function_view* boundary_values)
  : m_space(space), m_time(internal::checked_time(time)),
    m_tolerance(internal::checked_tolerance_of_diffusion(options)),
    m_most_vectors(options.maximum_iterations) {
  CGAL::Real_timer timer;
  timer.start();
  internal::require_enough_points(space);
  if(m_most_vectors < 2)
    throw Parameter_error("maximum_iterations",
                          "is " + std::to_string(m_most_vectors) + ", but must be at least 2");
  std::optional<Dirichlet_boundary> boundary;
  if(boundary_values)
    boundary.emplace(space);
  set_up(options, boundary ? &*boundary : nullptr);
  m_integrals = assemble_element_integrals(space);
  if(boundary)
    m_boundary_load = boundary->load(*boundary_values);
  else if(!space.is_paper_space()) { // there constants are no functions of the space
    m_number_of_components = static_cast<int>(space.number_of_sheets(0));
    m_component.resize(space.dimension());
    for(std::size_t element = 0; element < m_component.size(); ++element) {
      std::size_t sheet = space.slot(space.depth(), element).first;
      for(int level = space.depth(); level > 0; --level)
        sheet = space.octree().parent(level, sheet);
      m_component[element] = static_cast<int>(sheet);
    }
  }
  m_setup_seconds = timer.time();
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Diffusion_solver::set_up(const Diffusion_options& options, const Dirichlet_boundary* boundary) {
  internal::Elliptic_system system;
  system.elliptic.reaction = 1 / (internal::part_of_diffusion_time * m_time);
  system.elliptic.stabilization = options.stabilization.value_or(default_stabilization(m_space));
  system.boundary = boundary;
  system.mass = &m_mass;
  // without a stabilization the matrix is nearly singular, which multigrid can bear
  if(options.factorize.value_or(system.elliptic.stabilization > 0 &&
                                m_space.dimension() <=
                                    internal::Factorized_matrix::largest_dimension(true))) {
    internal::System_matrices matrices =
        internal::assemble_system(m_space, m_space.depth(), system.elliptic,
                                  internal::Stored_entries::all, internal::Progress(), &m_mass);
    if(boundary)
      boundary->add_to_matrix(matrices.matrices.back());
    m_factor.emplace(matrices.matrices.back());
    if(*m_factor)
      return;
    m_factor.reset(); // it is not positive definite, up to rounding
  }
  constexpr double smallest_tolerance = 1e-13;
  Poisson_solver_options of_solver;
  of_solver.tolerance = (std::max)(0.1 * m_tolerance, smallest_tolerance);
  of_solver.is_parallel = m_space.options().is_parallel;
  m_multigrid.emplace(m_space, system, of_solver);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::MatrixXd
Diffusion_solver::solve(const Eigen::MatrixXd& b, Solve_report& report) const {
  CGAL::Real_timer timer;
  timer.start();
  Eigen::MatrixXd x;
  if(m_factor)
    x = m_factor->solve(b, m_space.options().is_parallel);
  else if(const Solve_report of_systems = m_multigrid->solve(b, x); !of_systems.converged)
    report.worsen_status(of_systems.status);
  report.solve_seconds += timer.time();
  return x;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::MatrixXd
Diffusion_solver::means_of(const Eigen::MatrixXd& loads) const {
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(m_number_of_components, loads.cols());
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(m_number_of_components);
  for(std::size_t i = 0; i < m_component.size(); ++i) {
    sums.row(m_component[i]) += loads.row(static_cast<Eigen::Index>(i));
    areas[m_component[i]] += m_integrals[static_cast<Eigen::Index>(i)];
  }
  for(int c = 0; c < m_number_of_components; ++c)
    sums.row(c) *= areas[c] > 0 ? 1 / areas[c] : 0;
  return sums;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Diffusion_solver::add_constants(const Eigen::MatrixXd& of_components, double sign,
                                const Eigen::VectorXd& factors, Eigen::MatrixXd& to) const {
  for(std::size_t i = 0; i < m_component.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    to.row(row) += sign * factors[row] * of_components.row(m_component[i]);
  }
}

template <class Body>
void Diffusion_solver::for_each_column(std::size_t number, const Body& body) const {
  internal::parallel_for(m_space.options().is_parallel, 0, number, 1,
                         [&](std::size_t begin, std::size_t end) {
                           for(std::size_t k = begin; k < end; ++k)
                             body(static_cast<Eigen::Index>(k));
                         });
}

/// The Krylov spaces of some functions, which share each solve.
class Diffusion_solver::Krylov_spaces {
public:
  Krylov_spaces(const Diffusion_solver& diffusion, internal::Diffusion_function function)
    : m_diffusion(diffusion), m_function(function) {}

  /// adds what becomes of the functions with these loads to coefficients
  void run(const Eigen::MatrixXd& loads, Eigen::Ref<Eigen::MatrixXd> coefficients,
           Solve_report& report, const internal::Progress& progress) {
    // so that squares neither overflow nor vanish
    const Eigen::RowVectorXd units =
        loads.cwiseAbs().colwise().maxCoeff().unaryExpr([](double largest) {
          return largest > std::numeric_limits<double>::min() ? std::exp2(std::ilogb(largest)) : 1;
        });
    start(loads * units.cwiseInverse().asDiagonal(), report);
    while(!m_active.empty()) {
      constexpr double usual_number_of_vectors = 8;
      const auto vectors = static_cast<double>(m_basis.size());
      progress(1 - std::exp(-vectors / usual_number_of_vectors));
      if(static_cast<int>(m_basis.size()) > m_diffusion.m_most_vectors) {
        report.worsen_status(Solve_status::iteration_limit);
        break;
      }
      add_vectors(report);
      update();
    }
    report.relative_residual = (std::max)(report.relative_residual, m_last_change);
    for(Eigen::Index k = 0; k < loads.cols(); ++k)
      for(Eigen::Index j = 0; j < m_functions[k].result.size(); ++j)
        coefficients.col(k) += units[k] * (m_functions[k].result[j] * m_basis[j].col(k));
    report.iterations = (std::max)(report.iterations, static_cast<int>(m_basis.size()));
    progress(1);
  }

private:
  /// of a function: the tridiagonal matrix, and what is known of the result in the basis
  struct Function_space {
    double norm = 0; // of the first vector
    std::vector<double> diagonal, beside;
    Eigen::VectorXd result;
  };

  /// \f$K^{-1} b\f$ with \f$K = M + \gamma S\f$
  Eigen::MatrixXd solve(const Eigen::MatrixXd& loads, Solve_report& report) const {
    return m_diffusion.solve(loads, report) /
           (internal::part_of_diffusion_time * m_diffusion.m_time);
  }

  void start(const Eigen::MatrixXd& loads, Solve_report& report) {
    m_basis.assign(1, solve(loads, report));
    m_with_mass.assign(1, m_diffusion.loads_of(m_basis[0]));
    m_functions.assign(static_cast<std::size_t>(loads.cols()), {});
    for(Eigen::Index k = 0; k < loads.cols(); ++k) {
      Function_space& f = m_functions[k];
      f.norm = std::sqrt((std::max)(m_basis[0].col(k).dot(m_with_mass[0].col(k)), 0.));
      if(!(f.norm > std::numeric_limits<double>::min()))
        continue;
      m_basis[0].col(k) /= f.norm;
      m_with_mass[0].col(k) /= f.norm;
      m_active.push_back(k);
    }
  }

  /// one more vector for each function that has not converged
  void add_vectors(Solve_report& report) {
    Eigen::MatrixXd loads(m_with_mass[0].rows(), static_cast<Eigen::Index>(m_active.size()));
    for(std::size_t i = 0; i < m_active.size(); ++i)
      loads.col(static_cast<Eigen::Index>(i)) = m_with_mass.back().col(m_active[i]);
    Eigen::MatrixXd w = solve(loads, report);
    m_diffusion.for_each_column(m_active.size(), [&](Eigen::Index i) {
      Function_space& f = m_functions[m_active[i]];
      f.diagonal.push_back(0);
      for(int pass = 0; pass < 2; ++pass) // the second one for what rounding leaves
        for(std::size_t j = 0; j < m_basis.size(); ++j) {
          const double product = m_with_mass[j].col(m_active[i]).dot(w.col(i));
          w.col(i) -= product * m_basis[j].col(m_active[i]);
          if(j + 1 == m_basis.size())
            f.diagonal.back() += product;
        }
    });
    const Eigen::MatrixXd with_mass = m_diffusion.loads_of(w);
    m_basis.push_back(Eigen::MatrixXd::Zero(w.rows(), m_basis[0].cols()));
    m_with_mass.push_back(m_basis.back());
    for(std::size_t i = 0; i < m_active.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      const double norm = std::sqrt((std::max)(w.col(column).dot(with_mass.col(column)), 0.));
      m_functions[m_active[i]].beside.push_back(norm);
      if(norm > 0) {
        m_basis.back().col(m_active[i]) = w.col(column) / norm;
        m_with_mass.back().col(m_active[i]) = with_mass.col(column) / norm;
      }
    }
  }

  /// new results, and which functions have converged
  void update() {
    std::vector<Eigen::Index> still_active;
    m_last_change = 0;
    for(const Eigen::Index k : m_active) {
      Function_space& f = m_functions[k];
      const auto size = static_cast<Eigen::Index>(f.diagonal.size());
      Eigen::MatrixXd small = Eigen::MatrixXd::Zero(size, size);
      for(Eigen::Index j = 0; j < size; ++j) {
        small(j, j) = f.diagonal[j];
        if(j + 1 < size)
          small(j + 1, j) = small(j, j + 1) = f.beside[j];
      }
      const internal::Symmetric_eigenpairs pairs =
          internal::symmetric_eigenpairs(small, "a matrix of a diffusion");
      Eigen::VectorXd weights(size);
      for(Eigen::Index j = 0; j < size; ++j)
        weights[j] = f.norm * pairs.vectors(0, j) *
                     internal::diffusion_factor(m_function, m_diffusion.m_time, pairs.values[j]);
      Eigen::VectorXd result = pairs.vectors * weights, change = result;
      change.head(f.result.size()) -= f.result;
      // functions that have decayed altogether have no digits
      constexpr double rounding = 1e-12, smallest_part = 1e-12;
      const double unit = m_function == internal::Diffusion_function::exponential
                              ? 1
                              : m_diffusion.m_time,
                   relative =
                       change.norm() / (std::max)(result.norm(), smallest_part * unit * f.norm);
      f.result = std::move(result);
      const bool is_invariant = f.beside.back() <= rounding * std::abs(f.diagonal[0]);
      if(!is_invariant && !(size > 1 && relative <= m_diffusion.m_tolerance))
        still_active.push_back(k);
      if(!is_invariant)
        m_last_change = (std::max)(m_last_change, relative);
    }
    m_active.swap(still_active);
  }

  const Diffusion_solver& m_diffusion;
  internal::Diffusion_function m_function;
  std::vector<Function_space> m_functions;
  std::vector<Eigen::Index> m_active;
  std::vector<Eigen::MatrixXd> m_basis, m_with_mass; // a vector of each function, and M times it
  double m_last_change = 0;
};

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::MatrixXd
Diffusion_solver::loads_of(const Eigen::MatrixXd& coefficients) const {
  Eigen::MatrixXd loads(coefficients.rows(), coefficients.cols());
  for_each_column(static_cast<std::size_t>(coefficients.cols()), [&](Eigen::Index k) {
    loads.col(k) = m_mass.selfadjointView<Eigen::Upper>() * coefficients.col(k);
  });
  return loads;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Diffused_functions
Diffusion_solver::diffuse(const Surface_function_view& initial, const Surface_function_view* source,
                          const std::function<bool(double)>& progress) const {
  CGAL::Real_timer timer;
  timer.start();
  Eigen::MatrixXd sources;
  if(source) {
    if(source->components() != initial.components())
      throw Parameter_error("source", "has " + std::to_string(source->components()) +
                                          " components, but there are " +
                                          std::to_string(initial.components()) + " functions");
    sources = assemble_component_loads(m_space, *source);
  }
  const Eigen::MatrixXd loads = assemble_component_loads(m_space, initial);
  const double assembly_seconds = timer.time();
  Diffused_functions result = diffuse_loads(loads, sources, progress);
  result.assembly_seconds = assembly_seconds;
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Diffused_functions Diffusion_solver::low_pass(
    const Eigen::MatrixXd& loads, const Eigen::MatrixXd& gradient_loads,
    const Eigen::MatrixXd& boundary_loads, const std::function<bool(double)>& progress) const {
  Diffused_functions result;
  result.set_status(Solve_status::converged);
  result.setup_seconds = m_setup_seconds;
  const double alpha = 1 / (internal::part_of_diffusion_time * m_time);
  // the functions themselves, and then less what is not passed
  const Eigen::MatrixXd same = solve(gradient_loads + alpha * loads, result);
  result.coefficients = Eigen::MatrixXd::Zero(loads.rows(), loads.cols());
  const internal::Progress own(progress);
  const Eigen::MatrixXd inner_loads = gradient_loads - boundary_loads;
  for(Eigen::Index first = 0; first < loads.cols(); first += functions_at_once()) {
    const Eigen::Index number = (std::min)(functions_at_once(), loads.cols() - first);
    const auto part = [&](Eigen::Index k) {
      return static_cast<double>(k) / static_cast<double>(loads.cols());
    };
    Krylov_spaces(*this, internal::Diffusion_function::high_pass)
        .run(inner_loads.middleCols(first, number), result.coefficients.middleCols(first, number),
             result, own.part(part(first), part(first + number)));
  }
  result.coefficients = same - result.coefficients;
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Diffused_functions
Diffusion_solver::diffuse_loads(const Eigen::MatrixXd& initial, const Eigen::MatrixXd& source,
                                const std::function<bool(double)>& progress) const {
  using internal::Diffusion_function;
  for(const Eigen::MatrixXd* loads : {&initial, &source})
    if(loads->size() > 0 &&
       (loads->rows() != m_integrals.size() || loads->cols() != initial.cols()))
      throw Parameter_error(loads == &initial ? "initial" : "source",
                            "does not have the size of the space, or of the functions");
  const internal::Progress own(progress);
  own(0);
  Diffused_functions result;
  result.set_status(Solve_status::converged);
  result.setup_seconds = m_setup_seconds;
  result.coefficients = Eigen::MatrixXd::Zero(initial.rows(), initial.cols());
  Eigen::MatrixXd loads = initial, sources = source;
  if(m_boundary_load.size() > 0) {
    if(sources.size() == 0)
      sources = Eigen::MatrixXd::Zero(initial.rows(), initial.cols());
    sources.colwise() += m_boundary_load;
  }
  Eigen::MatrixXd means = means_of(loads);
  add_constants(means, -1, m_integrals, loads);
  if(sources.size() > 0) {
    const Eigen::MatrixXd of_source = means_of(sources);
    add_constants(of_source, -1, m_integrals, sources);
    means += m_time * of_source;
  }
  const Eigen::Index at_once = functions_at_once(),
                     parts = 2 * ((initial.cols() + at_once - 1) / at_once);
  Eigen::Index part = 0;
  for(Eigen::Index first = 0; first < initial.cols(); first += at_once)
    for(const auto function : {Diffusion_function::exponential, Diffusion_function::integral}) {
      const internal::Progress of_part =
          own.part(static_cast<double>(part) / static_cast<double>(parts),
                   static_cast<double>(part + 1) / static_cast<double>(parts));
      ++part;
      const Eigen::MatrixXd& given = function == Diffusion_function::integral ? sources : loads;
      const Eigen::Index number = (std::min)(at_once, initial.cols() - first);
      if(given.size() > 0)
        Krylov_spaces(*this, function)
            .run(given.middleCols(first, number), result.coefficients.middleCols(first, number),
                 result, of_part);
    }
  if(m_number_of_components > 0) {
    const double area = m_integrals.sum(); // taken out, so that products do not overflow
    const Eigen::MatrixXd left =
        area * means_of((m_integrals / area).asDiagonal() * result.coefficients);
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(m_integrals.size());
    add_constants(means - left, 1, ones, result.coefficients);
  }
  own(1);
  return result;
}

namespace internal {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Diffused_functions
diffuse_to_accuracy(Spline_space_3& space, const Diffusion_problem& problem, double accuracy,
                    const Integrated_space& integrated) {
  Diffusion_problem own = problem;
  if(!own.options.tolerance)
    own.options.tolerance = (std::min)(Diffusion_options::default_tolerance, accuracy);
  Diffused_functions result;
  search_depth(space, accuracy, Progress(problem.progress), {}, [&](const Progress& progress) {
    own.progress = progress.callback();
    result = diffuse_in_space(integrated ? integrated(space) : space, own);
    return Found_in_space{&result, values_over_surface(space, result.coefficients)};
  });
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Diffused_functions
diffuse_in_space(const Spline_space_3& space, const Diffusion_problem& problem) {
  const auto pointer = [](const std::optional<Surface_function_view>& f) {
    return f ? &*f : nullptr;
  };
  Diffusion_options options = problem.options;
  if(!options.factorize && problem.initial.components() == 1 &&
     space.dimension() > Factorized_matrix::largest_dimension(false))
    options.factorize = false;
  return Diffusion_solver(space, problem.time, options, pointer(problem.boundary_values))
      .diffuse(problem.initial, pointer(problem.source), problem.progress);
}

} // namespace internal

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_DIFFUSION_SOLVER_IMPL_H
