// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_MONTE_CARLO_ERROR_H
#define CGAL_RESTRICTED_LAPLACIAN_3_MONTE_CARLO_ERROR_H

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/integration/surface_integration.h>
#include <CGAL/Restricted_laplacian_3/spectra/eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Operators
/// Which samples `estimate_operators()` and `estimate_eigenvalues()` take.
struct Monte_carlo_options {
  /// of all batches together; each has this over `number_of_batches`, rounded down
  std::size_t number_of_samples = 1000000;
  /// at least 2. The standard errors have a relative error of about \f$1 / \sqrt{2 (B - 1)}\f$
  /// themselves, \f$B\f$ the number of batches: 24 % for 10 batches.
  int number_of_batches = 10;
  /// the same seed gives the same result with every compiler, and any number of threads
  std::uint64_t seed = 0;
  /// how the samples of a batch are drawn
  Sampling sampling = Sampling::independent;
};

/// \ingroup PkgRestrictedLaplacian3Operators
/// Matrices from samples, and the standard error of each of their entries.
struct Estimated_operators {
  /// as `assemble_operators()` with `Monte_carlo` gives them
  Operators operators;
  /// standard errors of the entries, in matrices of the same pattern
  Operators standard_errors;
};

/// \ingroup PkgRestrictedLaplacian3Operators
/// Eigenvalues from samples, and their standard errors.
struct Estimated_eigenvalues {
  /// ascending
  Eigen::VectorXd values;
  /// one for each value
  Eigen::VectorXd standard_errors;
};

namespace internal {

/// Independent samples of the same size.
class Sample_batches {
public:
  /// \throws Parameter_error
  Sample_batches(const Spline_space_3& space, const Monte_carlo_options& options)
    : m_space(space), m_sampling(options.sampling) {
    if(options.number_of_batches < 2)
      throw Parameter_error("number_of_batches", "is " + std::to_string(options.number_of_batches) +
                                                     ", but must be at least 2");
    const auto number_of_batches = static_cast<std::size_t>(options.number_of_batches);
    m_batch_size = options.number_of_samples / number_of_batches;
    if(m_batch_size == 0)
      throw Parameter_error("number_of_samples", "must be at least the number of batches");
    std::mt19937_64 generator(options.seed);
    for(std::size_t i = 0; i < number_of_batches; ++i)
      m_seeds.push_back(generator());
  }

  std::size_t size() const { return m_seeds.size(); }

  Monte_carlo operator[](std::size_t batch) const {
    return Monte_carlo(m_space, m_batch_size, m_seeds[batch], m_sampling);
  }

private:
  const Spline_space_3& m_space;
  Sampling m_sampling;
  std::size_t m_batch_size;
  std::vector<std::uint64_t> m_seeds;
};

/// Mean and standard error of the mean of arrays that come one after the other.
class Running_mean {
public:
  template <class Array> void add(const Array& values) {
    if(m_count++ == 0) {
      m_mean = Eigen::ArrayXd::Zero(values.size());
      m_squares = Eigen::ArrayXd::Zero(values.size());
    }
    const Eigen::ArrayXd change = values - m_mean;
    m_mean += change / m_count;
    m_squares += change * (values - m_mean);
  }

  const Eigen::ArrayXd& mean() const { return m_mean; }
  Eigen::ArrayXd standard_error() const { return (m_squares / (m_count - 1.) / m_count).sqrt(); }

private:
  int m_count = 0;
  Eigen::ArrayXd m_mean, m_squares; // sums of squared differences to the mean
};

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Operators
/// Stiffness and mass matrix of one level by the sum over random samples (paper, section 4.3), and
/// how far each entry is from the integral.
///
/// The samples are drawn in batches that are independent of each other, each with its own matrix
/// \f$A_b\f$. The result is their mean \f$\bar A\f$, whose standard error is
/// \f[ \sqrt{ \frac{1}{B (B - 1)} \sum_{b=1}^{B} (A_b - \bar A)^2 } \f]
/// for each entry. The matrix without stabilisation is unbiased.
///
/// Takes the time of one assembly for each batch.
/// \param space the space whose elements are integrated
/// \param level from 0, the coarsest, to the depth of the space
/// \param options number of samples and batches, seed
/// \param normal_stabilization,stabilized as in `assemble_operators()`
/// \throws Parameter_error if the level or an option is outside its domain
inline Estimated_operators
estimate_operators(const Spline_space_3& space, int level,
                   const Monte_carlo_options& options = Monte_carlo_options(),
                   double normal_stabilization = 0,
                   Stabilized stabilized = Stabilized::stiffness_and_mass) {
  space.checked_level(level);
  const internal::Sample_batches batches(space, options);
  internal::Running_mean stiffness, mass;
  Estimated_operators result;
  for(std::size_t b = 0; b < batches.size(); ++b) {
    Operators of_batch =
        assemble_operators(space, level, batches[b], normal_stabilization, stabilized);
    stiffness.add(of_batch.stiffness.coeffs());
    mass.add(of_batch.mass.coeffs());
    // all have the same pattern
    result.operators.stiffness.swap(of_batch.stiffness);
    result.operators.mass.swap(of_batch.mass);
  }
  result.standard_errors = result.operators;
  result.operators.stiffness.coeffs() = stiffness.mean();
  result.operators.mass.coeffs() = mass.mean();
  result.standard_errors.stiffness.coeffs() = stiffness.standard_error();
  result.standard_errors.mass.coeffs() = mass.standard_error();
  return result;
}

/// \ingroup PkgRestrictedLaplacian3Operators
/// The `k` smallest eigenvalues of \f$S x = \lambda M x\f$ on the finest level by random samples,
/// and how far each is from that of the integrals.
///
/// The eigenvalues are those of the mean matrices of all batches. Their standard errors follow from
/// the first-order change that each batch would cause: with \f$x^T M x = 1\f$ the number
/// \f$x^T (S_b - \lambda M_b)\, x\f$ has mean 0 over the batches, and the standard error of that
/// mean is the one of \f$\lambda\f$.
///
/// The error of discretisation is not in it. Nor is what is of second order. Eigenvalues that are
/// equal or nearer to each other than their errors repel each other, so that the lowest is too low,
/// and the highest too high; take the mean of such a group, whose error is right. And with few
/// samples in a cell all eigenvalues are too small, by several standard errors for 10 samples, and
/// by hardly one for 1000.
///
/// Takes the time of two assemblies for each batch and one eigenproblem by `smallest_eigenpairs()`.
/// \param space the space; its finest level is used
/// \param k number of eigenvalues, positive
/// \param options number of samples and batches, seed
/// \param normal_stabilization of the stiffness matrix, as in `assemble_operators()`
/// \throws Parameter_error if `k` or an option is outside its domain
/// \throws Numerical_error if a factorisation fails, or if not all eigenvalues were found
inline Estimated_eigenvalues
estimate_eigenvalues(const Spline_space_3& space, int k,
                     const Monte_carlo_options& options = Monte_carlo_options(),
                     double normal_stabilization = 0) {
  if(k < 1)
    throw Parameter_error("k", "is " + std::to_string(k) + ", but must be positive");
  const internal::Sample_batches batches(space, options);
  const auto operators_of_batch = [&](std::size_t b) {
    return assemble_operators(space, space.depth(), batches[b], normal_stabilization,
                              Stabilized::stiffness);
  };
  Operators mean = operators_of_batch(0);
  for(std::size_t b = 1; b < batches.size(); ++b) {
    const Operators of_batch = operators_of_batch(b);
    mean.stiffness.coeffs() += of_batch.stiffness.coeffs();
    mean.mass.coeffs() += of_batch.mass.coeffs();
  }
  mean.stiffness.coeffs() /= static_cast<double>(batches.size());
  mean.mass.coeffs() /= static_cast<double>(batches.size());
  const Eigenpairs pairs = smallest_eigenpairs(mean.stiffness, mean.mass, k);
  if(!pairs.converged)
    throw Numerical_error("found only " + std::to_string(pairs.values.size()) + " of " +
                          std::to_string(k) + " eigenvalues");

  const Eigen::MatrixXd& x = pairs.vectors;
  internal::Running_mean changes;
  for(std::size_t b = 0; b < batches.size(); ++b) {
    const Operators of_batch = operators_of_batch(b);
    const Eigen::MatrixXd stiffness_x = of_batch.stiffness * x, mass_x = of_batch.mass * x;
    const Eigen::MatrixXd residuals = stiffness_x - mass_x * pairs.values.asDiagonal();
    const Eigen::VectorXd change = x.cwiseProduct(residuals).colwise().sum();
    changes.add(change.array());
  }
  return {pairs.values, changes.standard_error().matrix()};
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_MONTE_CARLO_ERROR_H
