// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_MULTIGRID_SOLVER_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_MULTIGRID_SOLVER_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/explain_out_of_memory.h>
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
#include <array>
#include <cmath>
#include <cstddef>
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
    Least_squares_criterion least_squares;
    internal::Progress progress;
    /// as in `Solve_options`, and the column of the first right-hand side in them
    std::array<Eigen::MatrixXd, 2>* coarser_solutions = nullptr;
    Eigen::Index first = 0;
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
                                  const Least_squares_criterion& end) {
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
    if(given.coarser_solutions)
      for(Eigen::MatrixXd& coarser : *given.coarser_solutions)
        coarser.setConstant(b.rows(), b.cols(), std::numeric_limits<double>::quiet_NaN());
    if(!given.has_first_guess)
      of_block.coarser_solutions = given.coarser_solutions;
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
      const Eigen::Index remaining = b.cols() - first;
      const auto part = [&](Eigen::Index column) {
        return static_cast<double>((std::min)(column, b.cols())) / static_cast<double>(b.cols());
      };
      const Eigen::VectorXd& squares = given.least_squares.squares;
      of_block.least_squares.squares =
          squares.tail((std::max)(squares.size() - first, Eigen::Index(0)));
      of_block.progress = progress.part(part(first), part(first + internal::vectors_of_a_block));
      of_block.first = first;
      if(remaining == 1)
        solve_block<1>(of_block, b.rightCols(remaining), x.rightCols(remaining), report);
      else
        solve_block<internal::vectors_of_a_block>(of_block, b.rightCols(remaining),
                                                  x.rightCols(remaining), report);
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
          Iteration<K> iteration(*this, given, b, cycle);
          Block coarser;
          iteration.start(
              [&](const Block& p, Block& q) {
                hierarchy.template nested_iteration<K>(
                    p, q, cycle, options.smoothing_steps, workspace,
                    given.coarser_solutions ? &coarser : nullptr);
              },
              x);
          if(hierarchy.number_of_levels() > 1) // else the guess is the solution
            iteration.keep_coarser(std::move(coarser));
          iteration.run([&](const Block& p, Block& q) {
            hierarchy.template apply<K>(p, q, cycle, options.smoothing_steps, workspace);
          });
          iteration.finish(x, report);
        },
        multigrid);
  }

  template <int K> class Iteration;

  Options options;
  internal::Mean_projection means;
  std::variant<Multigrid<Patch_smoother>, Multigrid<Gauss_seidel_smoother>> multigrid;
  double setup_seconds;
};

/// The iteration for some right-hand sides, at most `K`.
template <int K> class Multigrid_solver::Impl::Iteration {
  using Block = internal::Block_vector<K>;
  using Row = internal::Block_row<K>;

public:
  /// \param cycle of the preconditioner; W-cycles that are found to diverge become V-cycles
  Iteration(const Impl& solver, const Block_options& given,
            const Eigen::Ref<const Eigen::MatrixXd>& b, Cycle& cycle)
    : m_solver(solver), m_given(given), m_cycle(cycle),
      m_count(static_cast<int>((std::min)(b.cols(), Eigen::Index(K)))),
      m_load(Block::Zero(b.rows(), K)), m_record(solver.options.energy_tolerance) {
    m_load.leftCols(m_count) = b.leftCols(m_count);
    // Squares of very small or large loads would leave the range of numbers.
    m_scale = m_load.cwiseAbs().colwise().maxCoeff().array().unaryExpr(
        [](double largest) { return largest > 0 ? largest : 1.; });
    m_load = m_load * m_scale.inverse().matrix().asDiagonal();
    m_b = m_load;
    m_solver.means.template project_load<K>(m_b);
    m_norm = internal::dot<K>(m_b, m_b).sqrt();
    // What the projection leaves of the load of a constant is rounding error.
    m_norm = (m_norm > projection_tolerance * internal::dot<K>(m_load, m_load).sqrt())
                 .select(m_norm, 0.);
    m_b = m_b * (m_norm > 0).select(Row::Ones(), Row::Zero()).matrix().asDiagonal();
    m_target = given.tolerance * m_norm;
    if(given.least_squares.tolerance > 0)
      compare_with_least_squares();
    given.progress(0);
  }

  /// \param guess makes a first guess
  /// \param x one of the caller, if there is one
  void start(internal::Block_operator<K> guess, const Eigen::Ref<const Eigen::MatrixXd>& x) {
    if(m_given.has_first_guess)
      improve_first_guess(guess, x);
    else {
      guess(m_b, m_x);
      update_residual();
    }
    if(start_at_zero_where_worse() && !m_given.has_first_guess)
      m_cycle = Cycle::V;
  }

  /// Keeps what nested iteration has found on coarser levels, if that is asked for.
  /// \param coarser one level below the first guess
  void keep_coarser(Block&& coarser) {
    if(!m_given.coarser_solutions)
      return;
    m_coarser = {m_x, std::move(coarser)};
    // where the first guess was of no use
    for(int k = 0; k < K; ++k)
      if(m_norm[k] > 0 && m_x.col(k).isZero(0))
        m_coarser[0].col(k).setConstant(std::numeric_limits<double>::quiet_NaN());
  }

  /// \param precondition one cycle
  void run(internal::Block_operator<K> precondition) {
    const auto multiply = [&](const Block& p, Block& q) {
      m_solver.matrix().template multiply<K>(p, q, m_solver.options.is_parallel);
    };
    const auto project = [&](Block& p) { this->project(p); };
    const internal::Preconditioned_operator<K> a = {multiply, precondition, project};
    // The recursively updated residual drifts away from the true one. Start again from the true one
    // as long as that helps.
    const int limit = m_solver.options.maximum_iterations;
    while(m_has_improved && !is_done() && m_iterations < limit) {
      m_record.ends_if_it_amplifies = m_cycle == Cycle::W;
      m_record.start(internal::dot<K>(m_x, m_b + m_r));
      if(m_solver.options.stand_alone_multigrid)
        internal::stationary_iteration<K>(a, m_r, m_x, m_target, m_iterations, limit);
      else
        internal::conjugate_gradient<K>(a, m_r, m_x, m_target, m_iterations, limit, m_record);
      const Row last = m_residual;
      update_residual();
      m_has_improved = (m_residual.max(m_target) < last.max(m_target) * restart_gain).any();
      if(m_cycle == Cycle::W && (m_record.amplifies() || !(m_residual <= m_norm).all())) {
        m_cycle = Cycle::V;
        start_at_zero_where_worse();
        m_has_improved = true;
      }
    }
  }

  /// \param x gets the solution, and the report what is said of it
  void finish(Eigen::Ref<Eigen::MatrixXd> x, Solve_report& report) {
    m_solver.means.template shift_solution<K>(m_load, m_x);
    m_x = m_x * m_scale.matrix().asDiagonal();
    x.leftCols(m_count) = m_x.leftCols(m_count);
    if(m_given.coarser_solutions)
      export_coarser(*m_given.coarser_solutions);
    report.iterations = (std::max)(report.iterations, m_iterations);
    for(int k = 0; k < m_count; ++k) {
      const double relative = m_norm[k] > 0 ? m_residual[k] / m_norm[k] : 0;
      report.relative_residuals.push_back(relative);
      report.relative_residual = (std::max)(report.relative_residual, relative);
      if(m_norm[k] > 0)
        report.relative_energy_error =
            m_record.knows_error(k)
                ? (std::max)(report.relative_energy_error, std::sqrt(m_record.squared_error(k)))
                : std::numeric_limits<double>::quiet_NaN();
      if(relative <= m_given.tolerance || m_record.has_converged(k))
        continue;
      report.worsen_status(!(relative <= 1) ? Solve_status::diverged
                           : m_has_improved ? Solve_status::iteration_limit
                                            : Solve_status::stalled);
    }
  }

private:
  /// a restart has to reduce a residual by this factor at least, else the iteration ends
  static constexpr double restart_gain = 0.9;
  /// a right-hand side that the projection reduces to this fraction is a constant
  static constexpr double projection_tolerance = 1e-13;

  void export_coarser(std::array<Eigen::MatrixXd, 2>& solutions) {
    for(std::size_t i = 0; i < 2; ++i) {
      if(m_coarser[i].rows() != m_x.rows())
        continue;
      m_solver.means.template shift_solution<K>(m_load, m_coarser[i]);
      m_coarser[i] = m_coarser[i] * m_scale.matrix().asDiagonal();
      solutions[i].middleCols(m_given.first, m_count) = m_coarser[i].leftCols(m_count);
    }
  }

  void compare_with_least_squares() {
    Block constants = Block::Zero(m_load.rows(), K);
    m_solver.means.template shift_solution<K>(m_load, constants);
    Row squares = Row::Zero();
    for(int k = 0; k < m_count; ++k)
      squares[k] = m_given.least_squares.squares[k];
    m_record.compare_with_least_squares(squares / m_scale.square() -
                                            internal::dot<K>(constants, m_load),
                                        m_given.least_squares.tolerance);
  }

  /// where that lessens the residual
  void improve_first_guess(internal::Block_operator<K> guess,
                           const Eigen::Ref<const Eigen::MatrixXd>& x) {
    Block guessed = Block::Zero(m_load.rows(), K);
    guessed.leftCols(m_count) = x.leftCols(m_count);
    guessed = guessed * m_scale.inverse().matrix().asDiagonal();
    m_x = guessed;
    update_residual();
    const Block r_of_guess = m_r;
    const Row of_guess = m_residual;
    guess(r_of_guess, m_x);
    m_x += guessed;
    update_residual();
    for(int k = 0; k < K; ++k)
      if(!(m_residual[k] <= of_guess[k])) {
        m_x.col(k) = guessed.col(k);
        m_r.col(k) = r_of_guess.col(k);
        m_residual[k] = of_guess[k];
      }
  }

  /// A first guess that is worse than none comes from cycles that diverge, on a near-kernel or by
  /// rounding.
  bool start_at_zero_where_worse() {
    bool was_worse = false;
    for(int k = 0; k < K; ++k)
      if(!(m_residual[k] <= m_norm[k])) {
        was_worse = true;
        m_x.col(k).setZero();
        m_r.col(k) = m_b.col(k);
        m_residual[k] = m_norm[k];
      }
    return was_worse;
  }

  bool is_done() const {
    for(int k = 0; k < K; ++k)
      if(m_residual[k] > m_target[k] && !m_record.has_converged(k))
        return false;
    return true;
  }

  /// the first thing that follows after each step
  void project(Block& p) const {
    m_solver.means.template project_load<K>(p);
    if(m_given.progress.is_shown())
      m_given.progress(part_done(internal::dot<K>(p, p).sqrt()));
  }

  void update_residual() {
    m_solver.matrix().template residual<K>(m_b, m_x, m_r, m_solver.options.is_parallel);
    project(m_r);
    m_residual = internal::dot<K>(m_r, m_r).sqrt();
  }

  /// Residuals fall by about the same factor in each step; the last of the right-hand sides counts.
  double part_done(const Row& residual) const {
    double largest = m_given.tolerance;
    for(int k = 0; k < K; ++k)
      if(m_norm[k] > 0)
        largest = (std::max)(largest, residual[k] / m_norm[k]);
    return std::log(largest) / std::log(m_given.tolerance);
  }

  const Impl& m_solver;
  const Block_options& m_given;
  Cycle& m_cycle;
  int m_count; ///< of columns that are not empty
  Block m_load, m_b, m_x, m_r;
  std::array<Block, 2> m_coarser; ///< if they are asked for
  Row m_scale, m_norm, m_target, m_residual;
  internal::Conjugate_gradient_record<K> m_record;
  int m_iterations = 0;
  bool m_has_improved = true;
};

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Multigrid_solver::Multigrid_solver(Sparse_matrix&& a, Multigrid_levels levels,
                                   const Eigen::VectorXd& element_integrals, double alpha,
                                   const Options& options)
  : Multigrid_solver(std::move(a), std::move(levels), element_integrals,
                     Eigen::VectorXd(alpha * element_integrals), options) {}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Multigrid_solver::Multigrid_solver(Sparse_matrix&& a, Multigrid_levels levels,
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
  return internal::explain_out_of_memory("not enough memory for the iteration",
                                         [&] { return m_impl->solve(b, x, options); });
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Solve_report
Multigrid_solver::solve(const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::MatrixXd& x,
                        const Solve_options& options) const {
  return internal::explain_out_of_memory("not enough memory for the iteration",
                                         [&] { return m_impl->solve(b, x, options); });
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_MULTIGRID_SOLVER_IMPL_H
