// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MONTE_CARLO_ERROR_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MONTE_CARLO_ERROR_IMPL_H

#include <CGAL/Restricted_laplacian_3/problems/monte_carlo_error.h>

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/integration/Monte_carlo.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/Running_mean.h>
#include <CGAL/Restricted_laplacian_3/spectra/smallest_eigenpairs.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Independent samples of the same size.
class Sample_batches {
public:
  /// \throws Parameter_error
  Sample_batches(const Spline_space_3& space, const Monte_carlo_options& options)
    : m_space(space), m_sampling(options.sampling) {
    if(options.batches < 2)
      throw Parameter_error("batches",
                            "is " + std::to_string(options.batches) + ", but must be at least 2");
    const auto batches = static_cast<std::size_t>(options.batches);
    m_batch_size = options.samples / batches;
    if(m_batch_size == 0)
      throw Parameter_error("samples", "must be at least the number of batches");
    std::mt19937_64 generator(options.seed);
    for(std::size_t i = 0; i < batches; ++i)
      m_seeds.push_back(generator());
  }

  std::size_t size() const { return m_seeds.size(); }

  Monte_carlo operator[](std::size_t batch) const {
    return Monte_carlo(m_space.octree(), m_batch_size, m_seeds[batch], m_sampling);
  }

private:
  const Spline_space_3& m_space;
  Sampling m_sampling;
  std::size_t m_batch_size;
  std::vector<std::uint64_t> m_seeds;
};

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Estimated_operators
estimate_operators(const Spline_space_3& space, int level, const Monte_carlo_options& options,
                   double stabilization, Stabilized stabilized) {
  space.checked_level(level);
  const internal::Sample_batches batches(space, options);
  internal::Running_mean stiffness, mass;
  Estimated_operators result;
  for(std::size_t b = 0; b < batches.size(); ++b) {
    Operators of_batch =
        assemble_operators(space.integrated_by(batches[b]), level, stabilization, stabilized);
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

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Estimated_eigenvalues estimate_eigenvalues(
    const Spline_space_3& space, int k, const Monte_carlo_options& options, double stabilization) {
  if(k < 1)
    throw Parameter_error("count", "is " + std::to_string(k) + ", but must be positive");
  const internal::Sample_batches batches(space, options);
  const auto operators_of_batch = [&](std::size_t b) {
    return assemble_operators(space.integrated_by(batches[b]), {}, stabilization,
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

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MONTE_CARLO_ERROR_IMPL_H
