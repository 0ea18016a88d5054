// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_MULTIGRID_SOLVER_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_MULTIGRID_SOLVER_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/name_step.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid_solver.h>

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Function_view.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/Mean_projection.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/Symmetric_matrix.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/conjugate_gradient.h>

#include <CGAL/Real_timer.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <variant>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

inline void check_tolerance(double tolerance) {
  if(!(tolerance > 0 && tolerance < 1))
    throw Parameter_error("tolerance", "must be between 0 and 1");
}

/// A row with a negative diagonal entry would be left out by the smoother, without a word. Sums of
/// products that cancel may leave one that is negative by rounding.
inline void check_entries(const Sparse_matrix& a) {
  constexpr double rounding = 1e-12;
  const Eigen::VectorXd diagonal = a.diagonal();
  const double largest = diagonal.size() > 0 ? diagonal.cwiseAbs().maxCoeff() : 0;
  for(Eigen::Index i = 0; i < diagonal.size(); ++i)
    if(diagonal[i] < -rounding * largest)
      throw Parameter_error("a", "is not positive semi-definite: the diagonal entry of row " +
                                     std::to_string(i) + " is negative");
  if(!a.coeffs().allFinite())
    throw Parameter_error("a", "has an entry that is not a finite number");
}

inline Poisson_solver_options checked(const Sparse_matrix& a, const Eigen::VectorXd& integrals,
                                      const Eigen::VectorXd& constant_loads,
                                      Poisson_solver_options options) {
  if(!options.tolerance)
    options.tolerance = Poisson_solver_options::default_tolerance;
  if(integrals.size() != a.cols())
    throw Parameter_error("element_integrals", "does not fit the size of the matrix");
  if(constant_loads.size() != a.cols())
    throw Parameter_error("constant_loads", "does not fit the size of the matrix");
  check_entries(a);
  check_tolerance(*options.tolerance);
  if(options.maximum_iterations < 0)
    throw Parameter_error("maximum_iterations", "must not be negative");
  if(options.smoothing_steps < 1)
    throw Parameter_error("smoothing_steps", "must be positive");
  if(!(options.energy_tolerance >= 0 && options.energy_tolerance < 1))
    throw Parameter_error("energy_tolerance", "must be from 0 to 1, and less than that");
  return options;
}

} // namespace internal

/// What a solver keeps, and the iteration.
struct Multigrid_solver::Impl {
  /// what is asked of the iteration for some columns
  struct Block_options {
    double tolerance;
    bool has_first_guess;
    Least_squares_end least_squares;
    internal::Progress progress;
  };

  /// \param a is compressed
  Impl(Sparse_matrix&& a, Multigrid_levels levels, const Eigen::VectorXd& element_integrals,
       const Eigen::VectorXd& constant_loads, const Options& given)
    : options(internal::checked(a, element_integrals, constant_loads, given)),
      means(a, element_integrals, constant_loads) {
    CGAL::Real_timer timer;
    timer.start();
    if(levels.patches.empty())
      options.smoother = Smoother_type::point;
    if(options.smoother == Smoother_type::patch)
      multigrid.emplace<Multigrid<Patch_smoother>>(std::move(a), std::move(levels),
                                                   options.is_parallel, true);
    else
      multigrid.emplace<Multigrid<Gauss_seidel_smoother>>(std::move(a), std::move(levels),
                                                          options.is_parallel, true);
    setup_seconds = timer.time();
  }

  const internal::Symmetric_matrix& matrix() const {
    return std::visit(
        [](const auto& m) -> const internal::Symmetric_matrix& { return m.finest_matrix(); },
        multigrid);
  }

  void check(const Eigen::Ref<const Eigen::MatrixXd>& b, double tolerance) const {
    internal::check_tolerance(tolerance);
    if(b.rows() != matrix().rows())
      throw Parameter_error("b", "has " + std::to_string(b.rows()) + " rows, but the matrix has " +
                                     std::to_string(matrix().rows()));
    if(!b.allFinite())
      throw Parameter_error("b", "has an entry that is not a finite number");
  }

  static void check_least_squares(const Eigen::Ref<const Eigen::MatrixXd>& b,
                                  const Least_squares_end& end) {
    if(!(end.tolerance >= 0))
      throw Parameter_error("least_squares", "has a tolerance that is negative");
    if(end.tolerance > 0 && (end.squares.size() != b.cols() || !end.squares.allFinite()))
      throw Parameter_error("least_squares", "needs a finite number for each right-hand side");
  }

  static void check_guess(const Eigen::Ref<const Eigen::MatrixXd>& b,
                          const Eigen::Ref<const Eigen::MatrixXd>& x) {
    if(x.rows() != b.rows() || x.cols() != b.cols())
      throw Parameter_error("x", "is a first guess, but not of the size of the right-hand side");
    if(!x.allFinite())
      throw Parameter_error("x", "has an entry that is not a finite number, as a first guess");
  }

  /// \param x a vector or a matrix, gets the size of `b`
  template <class Vectors>
  Solve_report solve(const Eigen::Ref<const Eigen::MatrixXd>& b, Vectors& x,
                     const Solve_options& given) const {
    Block_options of_block;
    of_block.tolerance = given.tolerance.value_or(*options.tolerance);
    of_block.has_first_guess = given.has_first_guess;
    of_block.least_squares = given.least_squares;
    const internal::Progress progress(given.progress);
    check(b, of_block.tolerance);
    check_least_squares(b, given.least_squares);
    if(given.has_first_guess)
      check_guess(b, x);
    else
      x.resize(b.rows(), b.cols());
    Solve_report report;
    report.set_status(Solve_status::converged);
    report.relative_energy_error = 0;
    report.setup_seconds = setup_seconds;
    CGAL::Real_timer timer;
    timer.start();
    for(Eigen::Index first = 0; first < b.cols(); first += internal::vectors_of_a_block) {
      // Some columns travel with empty ones: eight take about twice as long as one.
      const Eigen::Index left = b.cols() - first;
      const auto part = [&](Eigen::Index column) {
        return static_cast<double>((std::min)(column, b.cols())) / static_cast<double>(b.cols());
      };
      const Eigen::VectorXd& squares = given.least_squares.squares;
      of_block.least_squares.squares =
          squares.tail((std::max)(squares.size() - first, Eigen::Index(0)));
      of_block.progress = progress.part(part(first), part(first + internal::vectors_of_a_block));
      if(left == 1)
        solve_block<1>(of_block, b.rightCols(left), x.rightCols(left), report);
      else
        solve_block<internal::vectors_of_a_block>(of_block, b.rightCols(left), x.rightCols(left),
                                                  report);
    }
    progress(1);
    report.solve_seconds = timer.time();
    return report;
  }

  /// solves for the first columns of `b`, at most `K`, and adds to the report
  template <int K>
  void solve_block(const Block_options& given, const Eigen::Ref<const Eigen::MatrixXd>& b,
                   Eigen::Ref<Eigen::MatrixXd> x, Solve_report& report) const {
    std::visit(
        [&](const auto& hierarchy) {
          typename std::decay_t<decltype(hierarchy)>::template Workspace<K> workspace;
          using Block = internal::Block_vector<K>;
          Cycle cycle = options.cycle;
          iterate<K>(
              [&](const Block& p, Block& q) {
                hierarchy.template nested_iteration<K>(p, q, cycle, options.smoothing_steps,
                                                       workspace);
              },
              [&](const Block& p, Block& q) {
                hierarchy.template apply<K>(p, q, cycle, options.smoothing_steps, workspace);
              },
              cycle, given, b, x, report);
        },
        multigrid);
  }

  /// \param guess makes the first guess
  /// \param precondition one cycle
  /// \param cycle its shape; W-cycles that are found to diverge become V-cycles
  template <int K>
  void iterate(internal::Block_operator<K> guess, internal::Block_operator<K> precondition,
               Cycle& cycle, const Block_options& given,
               const Eigen::Ref<const Eigen::MatrixXd>& b_all, Eigen::Ref<Eigen::MatrixXd> x_all,
               Solve_report& report) const {
    using Block = internal::Block_vector<K>;
    using Row = internal::Block_row<K>;
    const double tolerance = given.tolerance;
    const internal::Progress& progress = given.progress;
    const Eigen::Index count = (std::min)(b_all.cols(), Eigen::Index(K));
    Block load = Block::Zero(b_all.rows(), K), b, x, r;
    load.leftCols(count) = b_all.leftCols(count);
    // Squares of very small or large loads would leave the range of numbers.
    const Row scale = load.cwiseAbs().colwise().maxCoeff().array().unaryExpr(
        [](double largest) { return largest > 0 ? largest : 1.; });
    load = load * scale.inverse().matrix().asDiagonal();
    b = load;
    means.template project_load<K>(b);
    Row norm = internal::dot<K>(b, b).sqrt();
    // What the projection leaves of the load of a constant is rounding error.
    norm = (norm > projection_tolerance * internal::dot<K>(load, load).sqrt()).select(norm, 0.);
    b = b * (norm > 0).select(Row::Ones(), Row::Zero()).matrix().asDiagonal();
    const Row target = tolerance * norm;

    const internal::Symmetric_matrix& matrix = this->matrix();
    const auto multiply = [&](const Block& p, Block& q) {
      matrix.template multiply<K>(p, q, options.is_parallel);
    };
    // the first thing that follows after each step
    const auto project = [&](Block& p) {
      means.template project_load<K>(p);
      if(progress.is_shown())
        progress(part_done<K>(internal::dot<K>(p, p).sqrt(), norm, tolerance));
    };
    Row residual;
    const auto update_residual = [&] {
      matrix.template residual<K>(b, x, r, options.is_parallel);
      project(r);
      residual = internal::dot<K>(r, r).sqrt();
    };
    progress(0);
    if(given.has_first_guess) {
      Block guessed = Block::Zero(load.rows(), K);
      guessed.leftCols(count) = x_all.leftCols(count);
      guessed = guessed * scale.inverse().matrix().asDiagonal();
      x = guessed;
      update_residual();
      const Block left = r;
      const Row of_guess = residual;
      guess(left, x);
      x += guessed;
      update_residual();
      for(int k = 0; k < K; ++k)
        if(!(residual[k] <= of_guess[k])) {
          x.col(k) = guessed.col(k);
          r.col(k) = left.col(k);
          residual[k] = of_guess[k];
        }
    } else {
      guess(b, x);
      update_residual();
    }

    // The recursively updated residual drifts away from the true one. Start again from the true one
    // as long as that helps.
    int iterations = 0;
    internal::Conjugate_gradient_record<K> record(options.energy_tolerance);
    if(given.least_squares.tolerance > 0) {
      Block constants = Block::Zero(load.rows(), K);
      means.template shift_solution<K>(load, constants);
      Row squares = Row::Zero();
      for(int k = 0; k < static_cast<int>(count); ++k)
        squares[k] = given.least_squares.squares[k];
      record.compare_with_least_squares(squares / scale.square() -
                                            internal::dot<K>(constants, load),
                                        given.least_squares.tolerance);
    }
    // A first guess that is worse than none comes from cycles that diverge, on a near-kernel or by
    // rounding.
    const auto start_at_zero_where_worse = [&] {
      bool was_worse = false;
      for(int k = 0; k < K; ++k)
        if(!(residual[k] <= norm[k])) {
          was_worse = true;
          x.col(k).setZero();
          r.col(k) = b.col(k);
          residual[k] = norm[k];
        }
      return was_worse;
    };
    if(start_at_zero_where_worse() && !given.has_first_guess)
      cycle = Cycle::V;
    const auto is_left = [&] {
      for(int k = 0; k < K; ++k)
        if(residual[k] > target[k] && !record.has_converged(k))
          return true;
      return false;
    };
    bool has_improved = true;
    while(has_improved && is_left() && iterations < options.maximum_iterations) {
      record.ends_if_it_amplifies = cycle == Cycle::W;
      record.start(internal::dot<K>(x, b + r));
      if(options.stand_alone_multigrid)
        internal::stationary_iteration<K>(multiply, precondition, project, r, x, target, iterations,
                                          options.maximum_iterations);
      else
        internal::conjugate_gradient<K>(multiply, precondition, project, r, x, target, iterations,
                                        options.maximum_iterations, record);
      const Row last = residual;
      update_residual();
      has_improved = (residual.max(target) < last.max(target) * restart_gain).any();
      if(cycle == Cycle::W && (record.amplifies() || !(residual <= norm).all())) {
        cycle = Cycle::V;
        start_at_zero_where_worse();
        has_improved = true;
      }
    }

    means.template shift_solution<K>(load, x);
    x = x * scale.matrix().asDiagonal();
    x_all.leftCols(count) = x.leftCols(count);
    report.iterations = (std::max)(report.iterations, iterations);
    for(int k = 0; k < static_cast<int>(count); ++k) {
      const double relative = norm[k] > 0 ? residual[k] / norm[k] : 0;
      report.relative_residuals.push_back(relative);
      report.relative_residual = (std::max)(report.relative_residual, relative);
      if(norm[k] > 0)
        report.relative_energy_error =
            record.knows_error(k)
                ? (std::max)(report.relative_energy_error, std::sqrt(record.squared_error(k)))
                : std::numeric_limits<double>::quiet_NaN();
      if(relative <= tolerance || record.has_converged(k))
        continue;
      report.worsen_status(!(relative <= 1) ? Solve_status::diverged
                           : has_improved   ? Solve_status::iteration_limit
                                            : Solve_status::stalled);
    }
  }

  /// Residuals fall by about the same factor in each step; the last of the right-hand sides counts.
  template <int K>
  static double part_done(const internal::Block_row<K>& residual,
                          const internal::Block_row<K>& norm, double tolerance) {
    double largest = tolerance;
    for(int k = 0; k < K; ++k)
      if(norm[k] > 0)
        largest = (std::max)(largest, residual[k] / norm[k]);
    return std::log(largest) / std::log(tolerance);
  }

  /// a restart has to reduce a residual by this factor at least, else the iteration ends
  static constexpr double restart_gain = 0.9;
  /// a right-hand side that the projection reduces to this fraction is a constant
  static constexpr double projection_tolerance = 1e-13;

  Options options;
  internal::Mean_projection means;
  std::variant<Multigrid<Patch_smoother>, Multigrid<Gauss_seidel_smoother>> multigrid;
  double setup_seconds;
};

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Multigrid_solver::Multigrid_solver(Sparse_matrix a, Multigrid_levels levels,
                                   const Eigen::VectorXd& element_integrals, double alpha,
                                   const Options& options)
  : Multigrid_solver(std::move(a), std::move(levels), element_integrals,
                     Eigen::VectorXd(alpha * element_integrals), options) {}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Multigrid_solver::Multigrid_solver(Sparse_matrix a, Multigrid_levels levels,
                                   const Eigen::VectorXd& element_integrals,
                                   const Eigen::VectorXd& constant_loads, const Options& options) {
  a.makeCompressed();
  m_impl = std::make_unique<Impl>(std::move(a), std::move(levels), element_integrals,
                                  constant_loads, options);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Multigrid_solver::Multigrid_solver(Multigrid_solver&& other) noexcept = default;
CGAL_RESTRICTED_LAPLACIAN_3_INLINE Multigrid_solver&
Multigrid_solver::operator=(Multigrid_solver&& other) noexcept = default;
CGAL_RESTRICTED_LAPLACIAN_3_INLINE Multigrid_solver::~Multigrid_solver() = default;

CGAL_RESTRICTED_LAPLACIAN_3_INLINE const Multigrid_solver::Options&
Multigrid_solver::options() const {
  return m_impl->options;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE const Multigrid_solver::Sparse_matrix&
Multigrid_solver::upper_half() const {
  return m_impl->matrix().upper_half();
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE int Multigrid_solver::kernel_dimension() const {
  return m_impl->means.kernel_dimension();
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE const internal::Mean_projection&
Multigrid_solver::mean_projection() const {
  return m_impl->means;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double Multigrid_solver::setup_seconds() const {
  return m_impl->setup_seconds;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Solve_report
Multigrid_solver::solve(const Eigen::Ref<const Eigen::VectorXd>& b, Eigen::VectorXd& x,
                        const Solve_options& options) const {
  return internal::name_step("not enough memory for the iteration",
                             [&] { return m_impl->solve(b, x, options); });
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Solve_report
Multigrid_solver::solve(const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::MatrixXd& x,
                        const Solve_options& options) const {
  return internal::name_step("not enough memory for the iteration",
                             [&] { return m_impl->solve(b, x, options); });
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_MULTIGRID_SOLVER_IMPL_H
