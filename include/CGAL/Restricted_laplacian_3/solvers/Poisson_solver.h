// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_POISSON_SOLVER_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_POISSON_SOLVER_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid.h>
#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Symmetric_matrix.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/conjugate_gradient.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/connected_components.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Solvers
/// which smoother a `Poisson_solver` uses: `Patch_smoother` or `Gauss_seidel_smoother`
enum class Smoother { patch, point };

/// \ingroup PkgRestrictedLaplacian3Solvers
/// What a `Poisson_solver` does unless told otherwise.
struct Poisson_solver_options {
  /// \f$ \|b - A x\|_2 \le \f$ tolerance times \f$\|b\|_2\f$ ends the iteration
  double relative_tolerance = 1e-3;
  /// the iteration ends after this many cycles, converged or not
  int maximum_iterations = 1000;
  /// shape of the multigrid cycle
  Cycle cycle = Cycle::V;
  /// smoothing steps before, and again after the coarse correction
  int smoothing_steps = 1;
  /// iterate cycles alone, instead of preconditioning conjugate gradients with them
  bool stand_alone_multigrid = false;
  /// patches take twice the memory and setup of points, and a tenth of their iterations
  Smoother smoother = Smoother::patch;
  /// whether several threads are used; results do not depend on that
  bool is_parallel = false;
};

namespace internal {

/// The functions that are constant on one connected component of the graph of a matrix \f$A\f$ and
/// 0 on the others, as far as \f$A 1_c = w_c\f$ with given loads \f$w_c\f$. This holds for
/// \f$A = S + M_w\f$, \f$w\f$ the integrals of the elements with the weight of the mass matrix, if
/// constants are in the space. Where \f$w_c = 0\f$ they are in the kernel. Otherwise the weighted
/// mean of a solution on the component is known beforehand, \f$1_c^T b / 1_c^T w_c\f$, and both are
/// split off in the same way.
class Constants {
public:
  /// \param constant_loads \f$w\f$, not negative
  Constants(const Eigen::SparseMatrix<double>& a, Eigen::VectorXd integrals,
            const Eigen::VectorXd& constant_loads)
    : m_measures(std::move(integrals)) {
    int number = 0;
    std::tie(m_component, number) = connected_components(a);
    m_is_screened.assign(number, 0);
    for(std::size_t i = 0; i < m_component.size(); ++i)
      if(constant_loads[i] > 0)
        m_is_screened[m_component[i]] = 1;
    m_sums.assign(number, 0.);
    for(std::size_t i = 0; i < m_component.size(); ++i) {
      if(m_is_screened[m_component[i]])
        m_measures[i] = constant_loads[i];
      m_sums[m_component[i]] += m_measures[i];
    }
    m_is_split_off = maps_constants_to(constant_loads, a, m_component, number);
    for(int c = 0; c < number; ++c) {
      m_is_split_off[c] = m_is_split_off[c] && m_sums[c] > 0;
      m_number += m_is_split_off[c];
    }
  }

  int number_of_components() const { return static_cast<int>(m_sums.size()); }
  /// number of the component of each unknown
  const std::vector<int>& components() const { return m_component; }
  /// whether \f$A 1_c = w_c\f$ holds on a component
  bool is_split_off(int component) const { return m_is_split_off[component]; }
  /// whether \f$w_c \ne 0\f$
  bool is_screened(int component) const { return m_is_screened[component]; }
  /// The weights of the unknowns in the means on their components: \f$w_c\f$, or the integrals of
  /// the elements where it is 0.
  const Eigen::VectorXd& measures() const { return m_measures; }
  /// their sum on a component
  double sum_of_measures(int component) const { return m_sums[component]; }

  /// number of components whose constants are in the kernel
  int kernel_dimension() const {
    int result = 0;
    for(int c = 0; c < number_of_components(); ++c)
      result += m_is_split_off[c] && !m_is_screened[c];
    return result;
  }

  /// Subtracts the load of a constant on each component, so that the loads of the component sum to
  /// 0: the right-hand side of \f$f\f$ becomes that of \f$f\f$ minus its mean.
  template <int K> void project_load(Block_vector<K>& b) const {
    const auto means = this->means<K>(b, [](double) { return 1.; });
    for(std::size_t i = 0; i < m_component.size() && m_number > 0; ++i)
      row<K>(b, i) -= m_measures[i] * means[m_component[i]];
  }

  /// Shifts a solution on each component by a constant: to mean 0 if \f$w_c = 0\f$, else to the
  /// mean that solves the equation with the right-hand side \f$b\f$ before its projection.
  template <int K> void shift_solution(const Block_vector<K>& b, Block_vector<K>& x) const {
    if(m_number == 0)
      return;
    auto shifts = this->means<K>(x, [](double measure) { return -measure; });
    const auto loads = this->means<K>(b, [](double) { return 1.; });
    for(std::size_t c = 0; c < shifts.size(); ++c)
      if(m_is_screened[c])
        shifts[c] += loads[c];
    for(std::size_t i = 0; i < m_component.size(); ++i)
      row<K>(x, i) += shifts[m_component[i]];
  }

private:
  /// weighted sums over each component that is split off, over that of the measures; 0 for others
  template <int K, class Weight>
  std::vector<Block_row<K>, Eigen::aligned_allocator<Block_row<K>>> means(const Block_vector<K>& v,
                                                                          Weight&& weight) const {
    std::vector<Block_row<K>, Eigen::aligned_allocator<Block_row<K>>> result(m_sums.size(),
                                                                             Block_row<K>::Zero());
    for(std::size_t i = 0; i < m_component.size() && m_number > 0; ++i)
      result[m_component[i]] += weight(m_measures[i]) * row<K>(v, i);
    for(std::size_t c = 0; c < result.size(); ++c)
      result[c] *= m_is_split_off[c] ? 1 / m_sums[c] : 0.;
    return result;
  }

  Eigen::VectorXd m_measures;
  std::vector<int> m_component;
  std::vector<double> m_sums;
  std::vector<char> m_is_screened, m_is_split_off;
  int m_number = 0;
};

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Solvers
/// Solves \f$A x = b\f$ for a symmetric positive semi-definite matrix by conjugate gradients that
/// are preconditioned with a multigrid cycle, from a first guess by nested iteration:
/// \f$A = S\f$ for the Poisson problem, \f$A = S + \alpha M\f$ for the screened one. It is set up
/// once and then solves for any number of right-hand sides. Knows matrices only, no surface.
///
/// *Precision.* The iteration is in double precision, the cycle in single precision. The iteration
/// ends by the true residual, computed anew from the solution.
///
/// *Singular systems.* If \f$A\f$ annihilates the functions that are constant on a connected
/// component (of the graph of the matrix), the system has a solution only for right-hand sides
/// whose entries sum to 0 on the component. The load of a constant is subtracted from \f$b\f$ to
/// achieve this, which turns the load of \f$f\f$ into that of \f$f\f$ minus its mean on the
/// component, and of all solutions the one with mean 0 on the component is returned. With
/// screening, \f$A\f$ maps the constant 1 to its load with the screening weight, \f$\alpha\f$ or a
/// function, and the weighted mean of the solution is computed exactly, however small the weight
/// is. Near-kernel (combinations of
/// elements that nearly vanish on the surface) is left alone: its coefficients carry no
/// information, and do not change the function on the surface.
class Poisson_solver {
public:
  /// all entries of a matrix, column by column, in double precision
  using Sparse_matrix = Eigen::SparseMatrix<double>;
  /// what the constructors take
  using Options = Poisson_solver_options;

  /// \param a the matrix
  /// \param prolongations from each level to the next finer one, coarsest first
  /// \param element_integrals \f$\int b_i\f$ for each unknown
  /// \param alpha the screening weight that `a` contains, if any
  /// \param options tolerance, iterations, cycle, smoother, threads
  /// \param patches of each level but the coarsest, coarsest first, see `smoothing_patches()`;
  /// without them, the smoother is point Gauss-Seidel
  /// \param coarse_matrices of each level but the finest, coarsest first; if there are none, they
  /// are computed as Galerkin products
  /// \throws Parameter_error if sizes do not fit, if an option is outside its domain, if an entry
  /// of the matrix is not finite, or a diagonal entry negative beyond rounding
  Poisson_solver(const Sparse_matrix& a, std::vector<Sparse_matrix> prolongations,
                 const Eigen::VectorXd& element_integrals, double alpha = 0,
                 const Options& options = Options(), std::vector<Smoothing_patches> patches = {},
                 std::vector<Sparse_matrix> coarse_matrices = {})
    : Poisson_solver(Sparse_matrix(a), std::move(prolongations), element_integrals, alpha, options,
                     std::move(patches), std::move(coarse_matrices)) {}

  /// The same, without a copy of the matrix; it is empty afterwards.
  Poisson_solver(Sparse_matrix&& a, std::vector<Sparse_matrix> prolongations,
                 const Eigen::VectorXd& element_integrals, double alpha = 0,
                 const Options& options = Options(), std::vector<Smoothing_patches> patches = {},
                 std::vector<Sparse_matrix> coarse_matrices = {})
    : Poisson_solver(std::move(a), std::move(prolongations), element_integrals,
                     Eigen::VectorXd(alpha * element_integrals), options, std::move(patches),
                     std::move(coarse_matrices)) {}

  /// The same with a screening weight that varies over the surface.
  /// \param a the matrix; it is empty afterwards
  /// \param prolongations as above
  /// \param element_integrals as above
  /// \param constant_loads \f$w_i = \int \alpha\, b_i\f$ for each unknown, not negative: what `a`
  /// maps the constant 1 to. On components where all of them are 0, constants are in the kernel.
  /// \param options tolerance, iterations, cycle, smoother, threads
  /// \param patches as above
  /// \param coarse_matrices as above
  Poisson_solver(Sparse_matrix&& a, std::vector<Sparse_matrix> prolongations,
                 const Eigen::VectorXd& element_integrals, const Eigen::VectorXd& constant_loads,
                 const Options& options = Options(), std::vector<Smoothing_patches> patches = {},
                 std::vector<Sparse_matrix> coarse_matrices = {})
    : m_options(checked(a, element_integrals, constant_loads, options)),
      m_constants(a, element_integrals, constant_loads) {
    CGAL::Real_timer timer;
    timer.start();
    if(patches.empty())
      m_options.smoother = Smoother::point;
    patches.resize(prolongations.size());
    // Half of the matrix is given up before the inverses of the smoother are computed.
    const auto keep_half = [&] { m_matrix.take_half_of(a); };
    if(m_options.smoother == Smoother::patch)
      m_multigrid.emplace<Patch_multigrid>(a, std::move(prolongations), std::move(patches),
                                           m_options.is_parallel, std::move(coarse_matrices),
                                           keep_half);
    else
      m_multigrid.emplace<Point_multigrid>(a, std::move(prolongations), std::move(patches),
                                           m_options.is_parallel, std::move(coarse_matrices),
                                           keep_half);
    m_setup_seconds = timer.time();
  }

  /// The options that are used: those given to the constructor, but with `Smoother::point` if there
  /// are no patches.
  const Options& options() const { return m_options; }
  /// the entries of the matrix on and above its diagonal
  const Sparse_matrix& upper_half() const { return m_matrix.upper_half(); }
  /// number of connected components whose constants are in the kernel of the matrix
  int kernel_dimension() const { return m_constants.kernel_dimension(); }
  /// the connected components of the graph of the matrix, and the constants on them
  const internal::Constants& constants() const { return m_constants; }
  /// wall-clock seconds that the hierarchy took
  double setup_seconds() const { return m_setup_seconds; }

  /// Solves for all columns of `b`; up to eight at a time share each pass over the matrices.
  /// \param b right-hand sides, as many rows as the matrix: a vector, or a matrix of columns
  /// \param x on return the solutions, of the same shape; its old content is not used
  /// \throws Parameter_error if the number of rows does not fit, or if an entry is not finite
  template <class RightHandSides, class Solutions>
  Solve_report solve(const Eigen::MatrixBase<RightHandSides>& b,
                     Eigen::PlainObjectBase<Solutions>& x) const {
    return solve(b, x, m_options.relative_tolerance);
  }

  /// The same with another tolerance than that of the options, between 0 and 1.
  template <class RightHandSides, class Solutions>
  Solve_report solve(const Eigen::MatrixBase<RightHandSides>& b,
                     Eigen::PlainObjectBase<Solutions>& x, double relative_tolerance) const {
    check_tolerance(relative_tolerance);
    if(b.rows() != m_matrix.rows())
      throw Parameter_error("b", "has " + std::to_string(b.rows()) + " rows, but the matrix has " +
                                     std::to_string(m_matrix.rows()));
    if(!b.allFinite())
      throw Parameter_error("b", "has an entry that is not a finite number");
    Solve_report report;
    report.converged = true;
    report.setup_seconds = m_setup_seconds;
    CGAL::Real_timer timer;
    timer.start();
    x.derived().resize(b.rows(), b.cols());
    for(Eigen::Index column = 0; column < b.cols();) {
      // Some columns travel with empty ones: eight take about twice as long as one.
      column += std::visit(
          [&](const auto& multigrid) {
            return b.cols() - column == 1
                       ? solve_block<1>(multigrid, relative_tolerance, b, x, column, report)
                       : solve_block<internal::vectors_of_a_block>(multigrid, relative_tolerance, b,
                                                                   x, column, report);
          },
          m_multigrid);
    }
    report.solve_seconds = timer.time();
    return report;
  }

private:
  using Patch_multigrid = Multigrid<Patch_smoother>;
  using Point_multigrid = Multigrid<Gauss_seidel_smoother>;

  static void check_tolerance(double tolerance) {
    if(!(tolerance > 0 && tolerance < 1))
      throw Parameter_error("relative_tolerance", "must be between 0 and 1");
  }

  static Options checked(const Sparse_matrix& a, const Eigen::VectorXd& integrals,
                         const Eigen::VectorXd& constant_loads, const Options& options) {
    if(integrals.size() != a.cols())
      throw Parameter_error("element_integrals", "does not fit the size of the matrix");
    if(constant_loads.size() != a.cols())
      throw Parameter_error("constant_loads", "does not fit the size of the matrix");
    check_entries(a);
    check_tolerance(options.relative_tolerance);
    if(options.maximum_iterations < 0)
      throw Parameter_error("number_of_iterations", "must not be negative");
    if(options.smoothing_steps < 1)
      throw Parameter_error("smoothing_steps", "must be positive");
    return options;
  }

  /// A row with a negative diagonal entry would be left out by the smoother, without a word. Sums
  /// of products that cancel may leave one that is negative by rounding.
  static void check_entries(const Sparse_matrix& a) {
    constexpr double rounding = 1e-12;
    const Eigen::VectorXd diagonal = a.diagonal();
    const double largest = diagonal.size() > 0 ? diagonal.cwiseAbs().maxCoeff() : 0;
    for(Eigen::Index i = 0; i < diagonal.size(); ++i)
      if(diagonal[i] < -rounding * largest)
        throw Parameter_error("a", "is not positive semi-definite: the diagonal entry of row " +
                                       std::to_string(i) + " is negative");
    if(!Eigen::Map<const Eigen::ArrayXd>(a.valuePtr(), a.nonZeros()).allFinite())
      throw Parameter_error("a", "has an entry that is not a finite number");
  }

  template <int K, class Hierarchy, class RightHandSides, class Solutions>
  Eigen::Index solve_block(const Hierarchy& multigrid, double relative_tolerance,
                           const Eigen::MatrixBase<RightHandSides>& b_all,
                           Eigen::PlainObjectBase<Solutions>& x_all, Eigen::Index column,
                           Solve_report& report) const {
    using Block = internal::Block_vector<K>;
    using Row = internal::Block_row<K>;
    const Eigen::Index count = (std::min)(b_all.cols() - column, Eigen::Index(K));
    Block load = Block::Zero(b_all.rows(), K), b, x, r;
    load.leftCols(count) = b_all.middleCols(column, count);
    // Squares of very small or large loads would leave the range of numbers.
    const Row scale = load.cwiseAbs().colwise().maxCoeff().array().unaryExpr(
        [](double largest) { return largest > 0 ? largest : 1.; });
    load = load * scale.inverse().matrix().asDiagonal();
    b = load;
    m_constants.project_load<K>(b);
    Row norm = internal::dot<K>(b, b).sqrt();
    // What the projection leaves of the load of a constant is rounding error.
    norm = (norm > projection_tolerance * internal::dot<K>(load, load).sqrt()).select(norm, 0.);
    b = b * (norm > 0).select(Row::Ones(), Row::Zero()).matrix().asDiagonal();
    const Row target = relative_tolerance * norm;

    typename Hierarchy::template Workspace<K> workspace;
    const auto multiply = [this](const Block& p, Block& q) {
      m_matrix.template multiply<K>(p, q, m_options.is_parallel);
    };
    const auto precondition = [&](const Block& p, Block& q) {
      multigrid.template apply<K>(p, q, m_options.cycle, m_options.smoothing_steps, workspace);
    };
    const auto project = [this](Block& p) { m_constants.project_load<K>(p); };

    multigrid.template nested_iteration<K>(b, x, m_options.cycle, m_options.smoothing_steps,
                                           workspace);
    m_matrix.template residual<K>(b, x, r, m_options.is_parallel);
    project(r);

    // The recursively updated residual drifts away from the true one. Start again from the true one
    // as long as that helps.
    int iterations = 0;
    Row residual = internal::dot<K>(r, r).sqrt();
    while((residual > target).any() && iterations < m_options.maximum_iterations) {
      if(m_options.stand_alone_multigrid)
        internal::stationary_iteration<K>(multiply, precondition, project, r, x, target, iterations,
                                          m_options.maximum_iterations);
      else
        internal::conjugate_gradient<K>(multiply, precondition, project, r, x, target, iterations,
                                        m_options.maximum_iterations);
      m_matrix.template residual<K>(b, x, r, m_options.is_parallel);
      project(r);
      const Row next = internal::dot<K>(r, r).sqrt();
      const bool improved = (next.max(target) < residual.max(target) * restart_gain).any();
      residual = next;
      if(!improved)
        break;
    }

    m_constants.shift_solution<K>(load, x);
    x = x * scale.matrix().asDiagonal();
    x_all.middleCols(column, count) = x.leftCols(count);
    report.iterations = (std::max)(report.iterations, iterations);
    for(Eigen::Index k = 0; k < count; ++k) {
      const double relative = norm[k] > 0 ? residual[k] / norm[k] : 0;
      report.relative_residuals.push_back(relative);
      report.relative_residual = (std::max)(report.relative_residual, relative);
      report.converged = report.converged && relative <= relative_tolerance;
    }
    return count;
  }

  /// a restart has to reduce a residual by this factor at least, else the iteration ends
  static constexpr double restart_gain = 0.9;
  /// a right-hand side that the projection reduces to this fraction is a constant
  static constexpr double projection_tolerance = 1e-13;

  Options m_options;
  internal::Constants m_constants;
  internal::Symmetric_matrix m_matrix;
  std::variant<Patch_multigrid, Point_multigrid> m_multigrid;
  double m_setup_seconds;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_POISSON_SOLVER_H
