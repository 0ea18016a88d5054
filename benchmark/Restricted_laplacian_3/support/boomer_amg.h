// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_BENCHMARK_BOOMER_AMG_H
#define RESTRICTED_LAPLACIAN_3_BENCHMARK_BOOMER_AMG_H

// hypre's algebraic multigrid for a symmetric matrix, alone or as the preconditioner of hypre's
// conjugate gradients.

#include <HYPRE.h>
#include <HYPRE_IJ_mv.h>
#include <HYPRE_krylov.h>
#include <HYPRE_parcsr_ls.h>
#include <mpi.h>

#include <cstdio>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace benchmarks {

/// The numbers are those of hypre's reference manual.
struct Boomer_amg_configuration {
  int coarsening = 10, interpolation = 6;
  int interpolation_entries = 4; // at most in a row; 0: all
  int aggressive_levels = 1;
  int coarsest_solver = 6;
  double strength_threshold = 0.25;
  bool is_preconditioner = false;
};

/// The configurations by name, `_pcg` behind it for a preconditioner:
/// - amg1, classical: Ruge-Stueben coarsening (3), classical interpolation (0), not truncated;
/// - amg2, tuned: HMIS coarsening (10), extended+i interpolation (6), 4 entries in a row, one level
///   of aggressive coarsening;
/// - hmis: as amg2 without aggressive coarsening;
/// - cgc: as amg2 with the coarsening of Griebel, Metsch and Schweitzer (21).
///
/// All have the strength threshold 0.25 and one sweep of symmetric Gauss-Seidel (6) before and
/// after the coarse correction; also on the coarsest level, whose matrix is singular as the others
/// are. Other ones by their numbers, separated by colons, in the order of the members above.
inline Boomer_amg_configuration boomer_amg_configuration(const std::string& name) {
  const std::string base = name.substr(0, name.rfind("_pcg"));
  Boomer_amg_configuration c;
  c.is_preconditioner = base != name;
  if(base == "amg1") {
    c.coarsening = 3;
    c.interpolation = c.interpolation_entries = c.aggressive_levels = 0;
  } else if(base == "hmis") {
    c.aggressive_levels = 0;
  } else if(base == "cgc") {
    c.coarsening = 21;
  } else if(base != "amg2") {
    if(std::sscanf(base.c_str(), "%d:%d:%d:%d:%d:%lf", &c.coarsening, &c.interpolation,
                   &c.interpolation_entries, &c.aggressive_levels, &c.coarsest_solver,
                   &c.strength_threshold) != 6)
      throw std::invalid_argument("there is no configuration " + name);
  }
  return c;
}

/// Initializes MPI and hypre for as long as it lives; one in a program.
struct Hypre_session {
  Hypre_session() {
    MPI_Init(nullptr, nullptr);
    HYPRE_Init();
  }
  Hypre_session(const Hypre_session&) = delete;
  Hypre_session& operator=(const Hypre_session&) = delete;
  ~Hypre_session() {
    HYPRE_Finalize();
    MPI_Finalize();
  }
};

/// Each process has the consecutive rows `first` .. `last` - 1 of the matrix and of the vectors.
class Boomer_amg {
public:
  /// Copies the rows of the process, given as compressed rows with global columns. A
  /// `Hypre_session` has to exist.
  Boomer_amg(MPI_Comm communicator, int first, int last, const int* row_begins, const int* columns,
             const double* values)
    : m_communicator(communicator), m_first(first), m_last(last), m_rows(last - first) {
    std::iota(m_rows.begin(), m_rows.end(), first);
    std::vector<int> sizes;
    for(int i = 0; i < last - first; ++i)
      sizes.push_back(row_begins[i + 1] - row_begins[i]);
    HYPRE_IJMatrixCreate(communicator, first, last - 1, first, last - 1, &m_matrix);
    HYPRE_IJMatrixSetObjectType(m_matrix, HYPRE_PARCSR);
    HYPRE_IJMatrixSetRowSizes(m_matrix, sizes.data());
    HYPRE_IJMatrixInitialize(m_matrix);
    HYPRE_IJMatrixSetValues(m_matrix, last - first, sizes.data(), m_rows.data(), columns, values);
    HYPRE_IJMatrixAssemble(m_matrix);
    HYPRE_IJMatrixGetObject(m_matrix, reinterpret_cast<void**>(&m_a));
    for(Vector* v : {&m_b, &m_x}) {
      HYPRE_IJVectorCreate(communicator, first, last - 1, &v->vector);
      HYPRE_IJVectorSetObjectType(v->vector, HYPRE_PARCSR);
      HYPRE_IJVectorInitialize(v->vector);
      HYPRE_IJVectorAssemble(v->vector);
      HYPRE_IJVectorGetObject(v->vector, reinterpret_cast<void**>(&v->entries));
    }
  }
  Boomer_amg(const Boomer_amg&) = delete;
  Boomer_amg& operator=(const Boomer_amg&) = delete;
  ~Boomer_amg() {
    destroy_solvers();
    HYPRE_IJVectorDestroy(m_b.vector);
    HYPRE_IJVectorDestroy(m_x.vector);
    HYPRE_IJMatrixDestroy(m_matrix);
  }

  /// Makes the hierarchy.
  void setup(const Boomer_amg_configuration& c) {
    destroy_solvers();
    m_is_preconditioner = c.is_preconditioner;
    HYPRE_BoomerAMGCreate(&m_amg);
    HYPRE_BoomerAMGSetCoarsenType(m_amg, c.coarsening);
    HYPRE_BoomerAMGSetInterpType(m_amg, c.interpolation);
    HYPRE_BoomerAMGSetPMaxElmts(m_amg, c.interpolation_entries);
    HYPRE_BoomerAMGSetAggNumLevels(m_amg, c.aggressive_levels);
    HYPRE_BoomerAMGSetStrongThreshold(m_amg, c.strength_threshold);
    HYPRE_BoomerAMGSetRelaxType(m_amg, 6);
    HYPRE_BoomerAMGSetCycleRelaxType(m_amg, c.coarsest_solver, 3);
    HYPRE_BoomerAMGSetPrintLevel(m_amg, 0);
    if(!m_is_preconditioner) {
      HYPRE_BoomerAMGSetup(m_amg, m_a, m_b.entries, m_x.entries);
      return;
    }
    HYPRE_BoomerAMGSetTol(m_amg, 0);
    HYPRE_BoomerAMGSetMaxIter(m_amg, 1);
    HYPRE_ParCSRPCGCreate(m_communicator, &m_pcg);
    HYPRE_PCGSetTwoNorm(m_pcg, 1);
    HYPRE_PCGSetPrecond(m_pcg, reinterpret_cast<HYPRE_PtrToSolverFcn>(HYPRE_BoomerAMGSolve),
                        reinterpret_cast<HYPRE_PtrToSolverFcn>(HYPRE_BoomerAMGSetup), m_amg);
    HYPRE_ParCSRPCGSetup(m_pcg, m_a, m_b.entries, m_x.entries);
  }

  /// Solves from the first guess 0 until the residual relative to the right-hand side is below
  /// `tolerance`, in hypre's own reckoning.
  /// \param b,x the entries of this process
  /// \return the number of iterations
  int solve(const double* b, double* x, double tolerance, int maximum_iterations) {
    int iterations = 0;
    HYPRE_IJVectorSetValues(m_b.vector, m_last - m_first, m_rows.data(), b);
    HYPRE_ParVectorSetConstantValues(m_x.entries, 0);
    if(m_is_preconditioner) {
      HYPRE_PCGSetTol(m_pcg, tolerance);
      HYPRE_PCGSetMaxIter(m_pcg, maximum_iterations);
      HYPRE_ParCSRPCGSolve(m_pcg, m_a, m_b.entries, m_x.entries);
      HYPRE_PCGGetNumIterations(m_pcg, &iterations);
    } else {
      HYPRE_BoomerAMGSetTol(m_amg, tolerance);
      HYPRE_BoomerAMGSetMaxIter(m_amg, maximum_iterations);
      HYPRE_BoomerAMGSolve(m_amg, m_a, m_b.entries, m_x.entries);
      HYPRE_BoomerAMGGetNumIterations(m_amg, &iterations);
    }
    HYPRE_ClearAllErrors(); // not reaching the tolerance is one
    HYPRE_IJVectorGetValues(m_x.vector, m_last - m_first, m_rows.data(), x);
    return iterations;
  }

private:
  struct Vector {
    HYPRE_IJVector vector = nullptr;
    HYPRE_ParVector entries = nullptr;
  };

  void destroy_solvers() {
    if(m_pcg)
      HYPRE_ParCSRPCGDestroy(m_pcg);
    if(m_amg)
      HYPRE_BoomerAMGDestroy(m_amg);
    m_pcg = m_amg = nullptr;
  }

  MPI_Comm m_communicator;
  int m_first, m_last;
  std::vector<int> m_rows;
  HYPRE_IJMatrix m_matrix = nullptr;
  HYPRE_ParCSRMatrix m_a = nullptr;
  Vector m_b, m_x;
  bool m_is_preconditioner = false;
  HYPRE_Solver m_amg = nullptr, m_pcg = nullptr;
};

} // namespace benchmarks

#endif // RESTRICTED_LAPLACIAN_3_BENCHMARK_BOOMER_AMG_H
