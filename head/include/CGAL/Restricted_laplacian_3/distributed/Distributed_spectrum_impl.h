// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_SPECTRUM_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_SPECTRUM_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_spectrum.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Distributed_eigensolver.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Distributed_multigrid.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Distributed_rows.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Element_exchange.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/petsc.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/problems/multigrid_levels.h>
#include <CGAL/Restricted_laplacian_3/problems/stabilization.h>
#include <CGAL/Restricted_laplacian_3/spectra/shared/nested_iteration.h>
#include <CGAL/Restricted_laplacian_3/spectra/smallest_eigenpairs.h>

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Computes a `Distributed_spectrum`.
class Distributed_spectrum_solver {
public:
  Distributed_spectrum_solver(const Distributed_space& space, int k,
                              const Laplace_spectrum_options& options,
                              const Distributed_spectrum_state& state)
    : m_space(space), m_communicator(space.communicator()), m_k(k), m_options(options),
      m_state(state), m_shift(natural_shift(space.area())) {}

  Distributed_spectrum solve() {
    CGAL::Real_timer timer;
    timer.start();
    m_communicator.agree([&] { check_and_assemble(); });
    Distributed_spectrum result;
    result.report.assembly_seconds = timer.time();
    const int carried = number_of_carried_vectors(m_k), depth = m_space.depth();
    const auto dimension = [&](int level) {
      return static_cast<std::int64_t>(m_space.dimension(level));
    };
    int start = m_space.gathered_level();
    while(start < depth && dimension(start) < unknowns_of_a_start_vector * carried)
      ++start;
    if(m_k > dimension(depth) / unknowns_of_a_start_vector)
      start = depth;
    const Eigenpairs first =
        pairs_of_rank_0(start, start == depth ? m_k : carried,
                        start == depth ? Eigenpairs_options().tolerance : tolerance_of_start);
    if(start == depth)
      take_pairs_of_rank_0(first, result);
    else
      improve(first, start, timer, result);
    report(result);
    result.report.solve_seconds =
        timer.time() - result.report.assembly_seconds - result.report.setup_seconds;
    return result;
  }

private:
  void check_and_assemble() {
    const Multigrid_eigenpairs_options& o = m_options.multigrid;
    if(m_k < 1)
      throw Parameter_error("count", "is " + std::to_string(m_k) + ", but must be positive");
    if(m_space.part().is_paper_space())
      throw Parameter_error("paper", "is not possible on several ranks");
    m_tolerance = o.tolerance.value_or(m_options.eigenvalues_only
                                           ? Laplace_spectrum_options::tolerance_of_eigenvalues
                                           : Multigrid_eigenpairs_options::default_tolerance);
    if(!(m_tolerance > 0 && m_tolerance < 1))
      throw Parameter_error("tolerance", "must be between 0 and 1");
    if(o.maximum_iterations < 0)
      throw Parameter_error("maximum_iterations", "must not be negative");
    if(o.smoothing_steps < 1)
      throw Parameter_error("smoothing_steps", "must be positive");
    const Distributed_functions& known = m_state.known;
    if(known.values.size() != known.coefficients.cols() ||
       (known.values.size() > 0 &&
        known.coefficients.rows() != static_cast<Eigen::Index>(m_space.part().dimension())))
      throw Parameter_error("known", "does not fit the part of the space");
    m_coarsest = (std::min)(coarsest_multigrid_level(m_space.part()), m_space.gathered_level());
    m_operators = assemble_operators_of_levels(
        m_space.part(), m_coarsest, m_space.depth(),
        m_options.stabilization.value_or(default_spectrum_stabilization(m_space.part())),
        Stabilized::stiffness);
  }

  Operators& operators(int level) {
    return m_operators[static_cast<std::size_t>(level - m_coarsest)];
  }

  Element_exchange exchange(int level) const {
    return Element_exchange(m_communicator, m_space.level(level).first_elements,
                            m_space.level(level).elements);
  }

  /// The sum of the matrices that ranks have of a level, all of it, on rank 0.
  Sparse_matrix matrix_on_rank_0(int level, const Sparse_matrix& a) const {
    const Distributed_rows rows =
        sum_of_matrices(m_communicator, exchange(level), m_space.level(level).elements, a);
    const auto to_rank_0 = [&](const auto& list) {
      std::vector<std::decay_t<decltype(list)>> lists(
          static_cast<std::size_t>(m_communicator.size()));
      lists.front() = list;
      lists = m_communicator.exchange(lists);
      for(std::size_t rank = 1; rank < lists.size(); ++rank)
        lists[0].insert(lists[0].end(), lists[rank].begin(), lists[rank].end());
      return lists[0];
    };
    std::vector<PetscInt> sizes;
    for(std::size_t i = 0; i < rows.size(); ++i)
      sizes.push_back(rows.first[i + 1] - rows.first[i]);
    sizes = to_rank_0(sizes);
    const std::vector<PetscInt> columns = to_rank_0(rows.columns);
    const std::vector<double> values = to_rank_0(rows.values);
    Sparse_matrix result;
    m_communicator.agree([&] {
      const auto n = static_cast<Eigen::Index>(sizes.size());
      result.resize(n, n);
      result.resizeNonZeros(static_cast<Eigen::Index>(values.size()));
      for(Eigen::Index i = 0; i < n; ++i)
        result.outerIndexPtr()[i + 1] =
            result.outerIndexPtr()[i] + static_cast<int>(sizes[static_cast<std::size_t>(i)]);
      std::copy(columns.begin(), columns.end(), result.innerIndexPtr());
      std::copy(values.begin(), values.end(), result.valuePtr());
    });
    return result;
  }

  /// eigenpairs of a level, computed by rank 0, on all ranks
  Eigenpairs pairs_of_rank_0(int level, int number, double tolerance) {
    const Sparse_matrix s = matrix_on_rank_0(level, operators(level).stiffness),
                        m = matrix_on_rank_0(level, operators(level).mass);
    Eigenpairs pairs;
    m_communicator.agree([&] {
      if(m_communicator.rank() != 0)
        return;
      Eigenpairs_options options;
      options.tolerance = tolerance;
      pairs = smallest_eigenpairs(s, m, number, options);
      if(pairs.values.size() < number)
        throw Numerical_error("the problem on the coarsest level could not be solved");
    });
    const auto broadcast = [&](auto& matrix, Eigen::Index rows, Eigen::Index columns) {
      std::vector<double> values(matrix.data(), matrix.data() + matrix.size());
      m_communicator.broadcast(values, 0);
      matrix.resize(rows, columns);
      std::copy(values.begin(), values.end(), matrix.data());
    };
    broadcast(pairs.values, number, 1);
    broadcast(pairs.residuals, number, 1);
    broadcast(pairs.vectors, static_cast<Eigen::Index>(m_space.dimension(level)), number);
    return pairs;
  }

  void take_pairs_of_rank_0(const Eigenpairs& pairs, Distributed_spectrum& result) const {
    const std::vector<std::uint64_t>& elements = m_space.level(m_space.depth()).elements;
    Distributed_functions& functions = result.pairs;
    functions.values = pairs.values;
    functions.coefficients.resize(static_cast<Eigen::Index>(elements.size()), m_k);
    for(std::size_t i = 0; i < elements.size(); ++i)
      functions.coefficients.row(static_cast<Eigen::Index>(i)) =
          pairs.vectors.row(static_cast<Eigen::Index>(elements[i]));
    result.residuals = pairs.residuals;
  }

  /// From eigenvectors of a level to those of the finest.
  void improve(const Eigenpairs& first, int start, CGAL::Real_timer& timer,
               Distributed_spectrum& result) {
    const int gathered = m_space.gathered_level();
    const double alpha = reaction_of_hierarchy(first.values, m_shift);
    std::vector<Sparse_matrix> matrices;
    std::vector<Petsc_matrix> masses(static_cast<std::size_t>(m_space.depth() - gathered) + 1);
    for(int level = m_coarsest; level <= m_space.depth(); ++level) {
      Operators& o = operators(level);
      m_communicator.agree([&] { matrices.push_back(o.stiffness + alpha * o.mass); });
      Sparse_matrix().swap(o.stiffness);
      if(level > start) {
        const Element_exchange of_elements = exchange(level);
        masses[static_cast<std::size_t>(level - gathered)] = petsc_matrix(
            m_communicator,
            sum_of_matrices(m_communicator, of_elements, m_space.level(level).elements, o.mass),
            of_elements.own_size());
      }
      Sparse_matrix().swap(o.mass);
    }
    Poisson_solver_options cycle;
    cycle.smoothing_steps = m_options.multigrid.smoothing_steps;
    Distributed_multigrid multigrid(m_space, std::move(matrices), cycle);
    result.report.setup_seconds = timer.time() - result.report.assembly_seconds;

    // the entries of this rank
    const auto of_start = static_cast<std::size_t>(start - gathered);
    const std::array<std::size_t, 2> range = multigrid.range(of_start);
    std::vector<Petsc_pair> pairs(static_cast<std::size_t>(first.values.size()));
    for(std::size_t i = 0; i < pairs.size(); ++i) {
      const double* column = first.vectors.col(static_cast<Eigen::Index>(i)).data();
      petsc_check(MatCreateVecs(multigrid.matrix(of_start), pairs[i].x.address(), nullptr));
      set_values(pairs[i].x, std::vector<double>(column + range[0], column + range[1]));
    }
    for(std::size_t level = of_start + 1; level <= multigrid.finest(); ++level) {
      prolongate(multigrid, level, pairs);
      Distributed_eigensolver solver(multigrid, level, masses[level], alpha, m_shift);
      if(level == multigrid.finest()) {
        improve_finest(multigrid.exchange(level), solver, pairs, result);
        continue;
      }
      const std::size_t number = pairs.size();
      std::vector<Petsc_pair> found =
          solver.solve(static_cast<int>(number), tolerance_of_coarse_levels,
                       m_options.multigrid.maximum_iterations, vectors_of(pairs));
      // those that have not converged are no worse than they were
      for(std::size_t i = found.size(); i < number; ++i)
        found.push_back(std::move(pairs[i]));
      pairs = std::move(found);
    }
  }

  static void prolongate(const Distributed_multigrid& multigrid, std::size_t level,
                         std::vector<Petsc_pair>& pairs) {
    for(Petsc_pair& pair : pairs) {
      Petsc_vector x;
      petsc_check(MatCreateVecs(multigrid.matrix(level), x.address(), nullptr));
      petsc_check(MatMult(multigrid.prolongation(level), pair.x, x));
      pair.x = std::move(x);
    }
  }

  static std::vector<Vec> vectors_of(const std::vector<Petsc_pair>& pairs, std::size_t first = 0) {
    std::vector<Vec> result;
    for(std::size_t i = first; i < pairs.size(); ++i)
      result.push_back(pairs[i].x);
    return result;
  }

  /// \param guesses for the first pairs, ascending
  void improve_finest(const Element_exchange& exchange, Distributed_eigensolver& solver,
                      const std::vector<Petsc_pair>& guesses, Distributed_spectrum& result) {
    constexpr int attempts = 8;
    // SLEPc's residuals are relative to an estimate
    constexpr double margin = 0.8;
    // what two vectors have in common that belong to one pair
    constexpr double same_pair = 0.5;
    const auto k = static_cast<std::size_t>(m_k);
    std::vector<Petsc_pair> finished, others;
    const auto take = [&](Petsc_pair&& pair) {
      (pair.residual <= m_tolerance ? finished : others).push_back(std::move(pair));
    };
    for(Eigen::Index i = 0; i < m_state.known.values.size(); ++i) {
      Petsc_vector x;
      petsc_check(VecDuplicate(guesses.front().x, x.address()));
      set_values(x, exchange.own_values(m_state.known.coefficients.col(i)));
      // neither 0 nor one that is there already
      Petsc_pair pair = solver.pair(x);
      if(std::isfinite(pair.residual) && solver.largest_cosine(pair, finished) <= same_pair)
        take(std::move(pair));
    }
    result.number_of_known = static_cast<int>((std::min)(finished.size(), k));
    int block = block_of(static_cast<int>(k - finished.size()));
    double tolerance = margin * m_tolerance;
    for(int attempt = 0; attempt < attempts && finished.size() < k; ++attempt) {
      // The guesses for pairs that are known are of no use.
      std::vector<Vec> first = vectors_of(others);
      for(Vec guess : vectors_of(guesses, finished.size() + others.size()))
        first.push_back(guess);
      std::function<void(std::vector<Petsc_pair>)> tell;
      const std::size_t before = finished.size();
      if(m_state.found)
        tell = [&](std::vector<Petsc_pair> pairs) {
          for(std::size_t i = 0; i < before; ++i)
            pairs.push_back(copy(finished[i]));
          m_state.found(functions_of(exchange, pairs));
        };
      std::vector<Petsc_pair> pairs = solver.solve(static_cast<int>(k - before), tolerance,
                                                   m_options.multigrid.maximum_iterations, first,
                                                   vectors_of(finished), block, tell);
      others.clear();
      for(Petsc_pair& pair : pairs)
        take(std::move(pair));
      if(solver.has_failed()) // another block has other vectors beside each other
        block = finished.size() > before ? block_of(static_cast<int>(k - finished.size()))
                                         : block * 3 / 4;
      else if(others.empty())
        break;
      else { // not all of SLEPc's solvers have vectors of the same norm
        double largest = m_tolerance;
        for(const Petsc_pair& pair : others)
          largest = (std::max)(largest, pair.residual);
        tolerance *= margin * m_tolerance / largest;
      }
    }
    result.report.iterations = solver.iterations();
    sort_pairs(finished);
    if(finished.size() > k)
      finished.resize(k);
    result.pairs = functions_of(exchange, finished);
    result.residuals.resize(static_cast<Eigen::Index>(finished.size()));
    for(std::size_t i = 0; i < finished.size(); ++i)
      result.residuals[static_cast<Eigen::Index>(i)] = finished[i].residual;
  }

  static Petsc_pair copy(const Petsc_pair& pair) {
    Petsc_pair result;
    result.value = pair.value;
    result.residual = pair.residual;
    petsc_check(VecDuplicate(pair.x, result.x.address()));
    petsc_check(VecCopy(pair.x, result.x));
    return result;
  }

  Distributed_functions functions_of(const Element_exchange& exchange,
                                     const std::vector<Petsc_pair>& pairs) const {
    const auto number = static_cast<Eigen::Index>(pairs.size());
    Distributed_functions result;
    result.values.resize(number);
    result.coefficients.resize(static_cast<Eigen::Index>(m_space.part().dimension()), number);
    for(Eigen::Index i = 0; i < number; ++i) {
      const Petsc_pair& pair = pairs[static_cast<std::size_t>(i)];
      result.values[i] = pair.value;
      const std::vector<double> own = values_of(pair.x);
      result.coefficients.col(i) = sign(own) * exchange.known_values(own);
    }
    return result;
  }

  /// of the entry of largest absolute value, the first one of all ranks
  double sign(const std::vector<double>& own) const {
    double entry = 0;
    for(double x : own)
      if(std::abs(x) > std::abs(entry))
        entry = x;
    const double largest = m_communicator.maximum(std::abs(entry));
    const int first = m_communicator.minimum(std::abs(entry) == largest ? m_communicator.rank()
                                                                        : m_communicator.size());
    std::vector<double> result = {entry < 0 ? -1. : 1.};
    m_communicator.broadcast(result, first);
    return result[0];
  }

  void report(Distributed_spectrum& result) const {
    result.report.set_status(result.pairs.values.size() == m_k ? Solve_status::converged
                                                               : Solve_status::iteration_limit);
    for(double residual : result.residuals) {
      result.report.relative_residuals.push_back(residual);
      result.report.relative_residual = (std::max)(result.report.relative_residual, residual);
    }
  }

  const Distributed_space& m_space;
  const Communicator& m_communicator;
  int m_k;
  const Laplace_spectrum_options& m_options;
  const Distributed_spectrum_state& m_state;
  double m_shift, m_tolerance = 0;
  int m_coarsest = 0;
  std::vector<Operators> m_operators;
};

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Distributed_spectrum
laplace_spectrum(const Distributed_space& space, int k, const Laplace_spectrum_options& options,
                 const Distributed_spectrum_state& state) {
  return internal::Distributed_spectrum_solver(space, k, options, state).solve();
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_SPECTRUM_IMPL_H
