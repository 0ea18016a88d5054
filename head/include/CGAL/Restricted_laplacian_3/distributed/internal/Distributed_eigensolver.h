// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_DISTRIBUTED_EIGENSOLVER_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_DISTRIBUTED_EIGENSOLVER_H

#include <CGAL/Restricted_laplacian_3/distributed/internal/Distributed_multigrid.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/petsc.h>

#include <slepceps.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

using Petsc_eigensolver = Petsc_handle<EPS, EPSDestroy>;

/// An eigenvalue, and its vector \f$x\f$, \f$x^T M x = 1\f$.
struct Petsc_pair {
  double value = 0, residual = 0;
  Petsc_vector x;
};

/// ascending
inline void sort_pairs(std::vector<Petsc_pair>& pairs) {
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Petsc_pair& a, const Petsc_pair& b) { return a.value < b.value; });
}

/// Blocks in which pairs are computed: of the vectors of a block, as many wait for the others of
/// the same eigenvalue and for those that follow. Measured on a sphere and on a scan: with smaller
/// blocks, or fewer that wait, the last of a block hardly converge.
constexpr int largest_block = 32;
constexpr double part_that_converges = 0.6;

/// The block for so many pairs: a few more vectors than pairs, which converge soon, in whole panels
/// of a cycle.
inline int block_of(int count) {
  constexpr int guards = 4;
  const int panels = (count + guards + vectors_of_a_block - 1) / vectors_of_a_block;
  return (std::min)(largest_block, panels * vectors_of_a_block);
}

/// Eigenpairs \f$S x = \lambda M x\f$ on one level of a hierarchy, by SLEPc.
class Distributed_eigensolver {
public:
  /// \param multigrid for \f$S + \alpha M\f$
  /// \param level of the hierarchy
  /// \param mass \f$M\f$ of the level
  /// \param shift \f$\sigma\f$
  Distributed_eigensolver(Distributed_multigrid& multigrid, std::size_t level, Mat mass,
                          double alpha, double shift)
    : m_multigrid(multigrid), m_level(level), m_matrix(multigrid.matrix(level)), m_mass(mass),
      m_alpha(alpha), m_shift(shift) {
    for(Petsc_vector* v : {&m_sx, &m_mx})
      petsc_check(MatCreateVecs(mass, v->address(), nullptr));
    // the norm of M x for a constant: that of others is about the same
    petsc_check(VecSet(m_sx, 1));
    petsc_check(MatMult(mass, m_sx, m_mx));
    PetscReal area = 0;
    petsc_check(VecDot(m_sx, m_mx, &area));
    petsc_check(VecNorm(m_mx, NORM_2, &m_scale));
    m_scale /= std::sqrt(area);
  }

  Distributed_eigensolver(const Distributed_eigensolver&) = delete;
  Distributed_eigensolver& operator=(const Distributed_eigensolver&) = delete;

  /// The pair of a vector: its Rayleigh quotient, and its relative residual.
  Petsc_pair pair(Vec x) {
    Petsc_pair result;
    petsc_check(VecDuplicate(x, result.x.address()));
    petsc_check(VecCopy(x, result.x));
    petsc_check(MatMult(m_mass, x, m_mx));
    petsc_check(MatMult(m_matrix, x, m_sx));
    petsc_check(VecAXPY(m_sx, -m_alpha, m_mx));
    PetscReal energy = 0, mass = 0, residual = 0, norm = 0;
    petsc_check(VecDot(x, m_sx, &energy));
    petsc_check(VecDot(x, m_mx, &mass));
    result.value = energy / mass;
    petsc_check(VecAXPY(m_sx, -m_shift, m_mx));
    petsc_check(VecNorm(m_sx, NORM_2, &norm));
    petsc_check(VecAXPY(m_sx, m_shift - result.value, m_mx));
    petsc_check(VecNorm(m_sx, NORM_2, &residual));
    result.residual = residual / norm;
    petsc_check(VecScale(result.x, 1 / std::sqrt(mass)));
    return result;
  }

  /// the largest absolute value of \f$x^T M y\f$ for the vectors \f$y\f$ of some pairs
  double largest_cosine(const Petsc_pair& pair, const std::vector<Petsc_pair>& others) {
    double result = 0;
    petsc_check(MatMult(m_mass, pair.x, m_mx));
    for(const Petsc_pair& other : others) {
      PetscReal cosine = 0;
      petsc_check(VecDot(other.x, m_mx, &cosine));
      result = (std::max)(result, std::abs(cosine));
    }
    return result;
  }

  /// Looks for pairs beside those of `known`.
  /// \param count how many
  /// \param first vectors to begin with
  /// \param known they are not computed again
  /// \param block of LOBPCG, unless the options of SLEPc say another one
  /// \param found is called with more and more of the pairs that have converged
  /// \return the pairs that SLEPc takes for converged, ascending, at most `count`
  std::vector<Petsc_pair> solve(int count, double tolerance, int maximum_iterations,
                                std::vector<Vec> first, std::vector<Vec> known = {},
                                int block = largest_block,
                                std::function<void(std::vector<Petsc_pair>)> found = {}) {
    m_tolerance = tolerance;
    m_found = std::move(found);
    m_finished = 0;
    block = (std::min)(static_cast<int>(first.size()), block);
    // as many as LOBPCG has room for
    const int room = (std::max)(3, (count - 1) / block + 3) * block;
    first.resize((std::min)(first.size(), static_cast<std::size_t>(room)));
    const Petsc_eigensolver solver = make_solver(block, count, maximum_iterations);
    if(!known.empty())
      petsc_check(EPSSetDeflationSpace(solver, static_cast<PetscInt>(known.size()), known.data()));
    petsc_check(EPSSetInitialSpace(solver, static_cast<PetscInt>(first.size()), first.data()));
    petsc_check(PetscPushErrorHandler(PetscReturnErrorHandler, nullptr));
    const PetscErrorCode code = EPSSolve(solver);
    petsc_check(PetscPopErrorHandler());
    if(m_error)
      std::rethrow_exception(m_error);
    m_multigrid.rethrow();
    // a projected problem that is singular to rounding
    m_has_failed = code == PETSC_ERR_LIB;
    if(!m_has_failed)
      petsc_check(code);
    PetscInt iterations = 0, number = 0;
    petsc_check(EPSGetIterationNumber(solver, &iterations));
    m_iterations += static_cast<int>(iterations);
    std::vector<Petsc_pair> result;
    if(m_has_failed)
      result = finished_pairs(solver);
    else {
      EPSConvergedReason reason = EPS_CONVERGED_ITERATING;
      petsc_check(EPSGetConvergedReason(solver, &reason));
      m_has_failed = reason == EPS_DIVERGED_BREAKDOWN;
      petsc_check(EPSGetConverged(solver, &number));
      Petsc_vector x;
      petsc_check(MatCreateVecs(m_mass, x.address(), nullptr));
      for(PetscInt i = 0; i < number; ++i) {
        petsc_check(EPSGetEigenvector(solver, i, x, nullptr));
        result.push_back(pair(x));
      }
    }
    sort_pairs(result);
    if(result.size() > static_cast<std::size_t>(count))
      result.resize(static_cast<std::size_t>(count));
    return result;
  }

  /// of all calls
  int iterations() const { return m_iterations; }
  /// whether the last call ended early, because vectors had become dependent
  bool has_failed() const { return m_has_failed; }

private:
  /// For SLEPc, which has \f$M x - \nu\, (S + \alpha M)\, x\f$, with vectors of unit energy.
  static PetscErrorCode relative_residual(EPS, PetscScalar nu, PetscScalar, PetscReal residual,
                                          PetscReal* error, void* context) {
    const auto& self = *static_cast<const Distributed_eigensolver*>(context);
    const double lambda = 1 / nu - self.m_alpha;
    *error = nu > 0 ? residual / nu / ((lambda - self.m_shift) * self.m_scale * std::sqrt(nu)) : 1;
    return 0;
  }

  Petsc_eigensolver make_solver(int block, int count, int maximum_iterations) {
    const int number_of_blocks = 1 + static_cast<int>(count / (part_that_converges * block));
    Petsc_eigensolver solver;
    petsc_check(
        EPSCreate(PetscObjectComm(reinterpret_cast<PetscObject>(m_mass)), solver.address()));
    petsc_check(EPSSetOperators(solver, m_mass, m_matrix));
    petsc_check(EPSSetProblemType(solver, EPS_GHEP));
    petsc_check(EPSSetWhichEigenpairs(solver, EPS_LARGEST_REAL));
    if(m_level < m_multigrid.finest())
      petsc_check(EPSSetOptionsPrefix(solver, "coarse_"));
    // SLEPc does not take all that a type has set back when options choose another one.
    std::array<char, 64> type = {};
    PetscBool is_chosen = PETSC_FALSE;
    const char* prefix = nullptr;
    petsc_check(EPSGetOptionsPrefix(solver, &prefix));
    petsc_check(
        PetscOptionsGetString(nullptr, prefix, "-eps_type", type.data(), type.size(), &is_chosen));
    petsc_check(EPSSetType(solver, is_chosen == PETSC_TRUE ? type.data() : EPSLOBPCG));
    petsc_check(EPSLOBPCGSetBlockSize(solver, block));
    petsc_check(EPSLOBPCGSetRestart(solver, part_that_converges));
    // Without the residuals of vectors that have converged, the projected problem becomes singular
    // to rounding, now and then.
    petsc_check(EPSLOBPCGSetLocking(solver, PETSC_FALSE));
    BV basis = nullptr;
    petsc_check(EPSGetBV(solver, &basis));
    petsc_check(BVSetOrthogonalization(basis, BV_ORTHOG_CGS, BV_ORTHOG_REFINE_IFNEEDED,
                                       PETSC_DEFAULT, BV_ORTHOG_BLOCK_SVQB));
    petsc_check(EPSSetDimensions(solver, count, PETSC_DEFAULT, PETSC_DEFAULT));
    petsc_check(EPSSetTolerances(solver, m_tolerance,
                                 (std::max)(maximum_iterations, 1) * number_of_blocks));
    petsc_check(EPSSetConvergenceTestFunction(solver, relative_residual, this, nullptr));
    petsc_check(EPSSetStoppingTestFunction(solver, stop, this, nullptr));
    petsc_check(EPSMonitorSet(solver, tell, this, nullptr));
    ST transformation = nullptr;
    petsc_check(EPSGetST(solver, &transformation));
    petsc_check(STSetType(transformation, STPRECOND));
    petsc_check(STPrecondSetKSPHasMat(transformation, PETSC_TRUE));
    KSP cycle = nullptr;
    petsc_check(STGetKSP(transformation, &cycle));
    petsc_check(KSPSetType(cycle, KSPPREONLY));
    petsc_check(KSPSetOperators(cycle, m_matrix, m_matrix));
    PC pc = nullptr;
    petsc_check(KSPGetPC(cycle, &pc));
    m_multigrid.configure_for_many(pc, m_level);
    petsc_check(EPSSetFromOptions(solver));
    petsc_check(KSPSetUp(cycle));
    return solver;
  }

  /// a vector of the basis of SLEPc
  Petsc_pair pair_of_basis(EPS solver, PetscInt i) {
    BV basis = nullptr;
    Vec x = nullptr;
    petsc_check(EPSGetBV(solver, &basis));
    petsc_check(BVGetColumn(basis, i, &x));
    Petsc_pair result = pair(x);
    petsc_check(BVRestoreColumn(basis, i, &x));
    return result;
  }

  std::vector<Petsc_pair> finished_pairs(EPS solver) {
    std::vector<Petsc_pair> result;
    for(PetscInt i = 0; i < m_finished; ++i)
      result.push_back(pair_of_basis(solver, i));
    return result;
  }

  /// Sees which of the pairs that have converged are in the basis: LOBPCG puts whole blocks there.
  static PetscErrorCode tell(EPS solver, PetscInt, PetscInt converged, PetscScalar*, PetscScalar*,
                             PetscReal*, PetscInt, void* context) {
    auto& self = *static_cast<Distributed_eigensolver*>(context);
    try { // no exceptions through functions of C
      const PetscInt before = self.m_finished;
      while(!self.m_error && self.m_finished < converged &&
            self.pair_of_basis(solver, self.m_finished).residual <= self.m_tolerance)
        ++self.m_finished;
      if(self.m_finished > before && self.m_found)
        self.m_found(self.finished_pairs(solver));
    } catch(...) {
      self.m_error = std::current_exception();
    }
    return 0;
  }

  static PetscErrorCode stop(EPS solver, PetscInt iteration, PetscInt largest, PetscInt converged,
                             PetscInt wanted, EPSConvergedReason* reason, void* context) {
    if(static_cast<const Distributed_eigensolver*>(context)->m_error)
      *reason = EPS_CONVERGED_USER;
    else
      PetscCall(EPSStoppingBasic(solver, iteration, largest, converged, wanted, reason, nullptr));
    return 0;
  }

  Distributed_multigrid& m_multigrid;
  std::size_t m_level;
  Mat m_matrix, m_mass;
  double m_alpha, m_shift, m_scale = 0, m_tolerance = 0;
  int m_iterations = 0;
  bool m_has_failed = false;
  PetscInt m_finished = 0; // first vectors of the basis that have converged
  std::exception_ptr m_error;
  std::function<void(std::vector<Petsc_pair>)> m_found;
  Petsc_vector m_sx, m_mx;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_DISTRIBUTED_EIGENSOLVER_H
