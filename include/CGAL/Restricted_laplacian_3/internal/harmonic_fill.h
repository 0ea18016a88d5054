// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_HARMONIC_FILL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_HARMONIC_FILL_H

#include <CGAL/Restricted_laplacian_3/Surface_location.h>
#include <CGAL/Restricted_laplacian_3/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/conjugate_gradient.h>
#include <CGAL/Restricted_laplacian_3/internal/Disjoint_sets.h>
#include <CGAL/Restricted_laplacian_3/internal/block_vectors.h>

#include <Eigen/Core>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// A side of a face, with the cotangent of the angle that is opposite.
struct Weighted_side {
  std::uint32_t v, w;
  double weight;
};

/// The sides of all faces that have an area. Cotangents are raised to a small positive number, so
/// that the values of a harmonic function lie between those that are given, on any triangulation;
/// those of needles are limited.
inline std::vector<Weighted_side> weighted_sides(const Triangulated_surface_3& surface) {
  constexpr double smallest = 1e-2, largest = 1e2;
  std::vector<Weighted_side> sides;
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for(int i = 0; i < 3 && !surface.is_degenerate(f); ++i) {
      const Vector_3 a = surface.point(f, (i + 1) % 3) - surface.point(f, i),
                     b = surface.point(f, (i + 2) % 3) - surface.point(f, i);
      const double cotangent = (a * b) / (2 * surface.area(f));
      sides.push_back({surface.triangle(f)[(i + 1) % 3], surface.triangle(f)[(i + 2) % 3],
                       std::clamp(cotangent, smallest, largest)});
    }
  return sides;
}

/// Gives values to the vertices that have none: those of the function that is harmonic there, by
/// the weights of `weighted_sides()`, and takes the given values elsewhere. Vertices that are not
/// connected with one that has a value get the mean of the given values.
///
/// Up to 1e-4 of the size of the values: what is filled is a guess in any case.
/// \param has_value for each vertex, set for those that get one from others
/// \param values of the vertices, a row for each
template <int K>
void fill_harmonically(const Triangulated_surface_3& surface, std::vector<char>& has_value,
                       Eigen::Matrix<double, Eigen::Dynamic, K>& values) {
  constexpr double tolerance = 1e-4;
  constexpr int maximum_iterations = 1000;
  const std::vector<Weighted_side> sides = weighted_sides(surface);
  const std::size_t n = surface.number_of_vertices();
  Disjoint_sets sets(n);
  for(const Weighted_side& side : sides)
    sets.unite(side.v, side.w);
  std::vector<char> is_reached(n, 0); // of the roots of the sets
  Eigen::Matrix<double, 1, K> sum = Eigen::Matrix<double, 1, K>::Zero();
  double number = 0;
  for(std::uint32_t v = 0; v < n; ++v)
    if(has_value[v]) {
      is_reached[sets.find(v)] = 1;
      sum += values.row(v);
      ++number;
    }
  std::vector<int> rows(n, -1);
  int size = 0;
  for(std::uint32_t v = 0; v < n; ++v)
    if(!has_value[v]) {
      values.row(v) = number > 0 ? (sum / number).eval() : Eigen::Matrix<double, 1, K>::Zero();
      if(is_reached[sets.find(v)])
        rows[v] = size++;
    }
  if(size == 0)
    return;

  std::vector<Eigen::Triplet<double>> entries;
  Block_vector<K> r = Block_vector<K>::Zero(size, K), x = r;
  for(const Weighted_side& side : sides)
    for(const auto& [v, w] : {std::make_pair(side.v, side.w), std::make_pair(side.w, side.v)}) {
      if(rows[v] < 0)
        continue;
      entries.emplace_back(rows[v], rows[v], side.weight);
      if(rows[w] >= 0)
        entries.emplace_back(rows[v], rows[w], -side.weight);
      else
        r.row(rows[v]) += side.weight * values.row(w);
    }
  Eigen::SparseMatrix<double> a(size, size);
  a.setFromTriplets(entries.begin(), entries.end());
  const Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::NaturalOrdering<int>> factor(a);
  const auto multiply = [&](const Block_vector<K>& p, Block_vector<K>& q) { q.noalias() = a * p; };
  const auto precondition = [&](const Block_vector<K>& p, Block_vector<K>& q) {
    q = factor.solve(p);
  };
  const Block_row<K> target = tolerance * dot<K>(r, r).sqrt();
  int iterations = 0;
  conjugate_gradient<K>(
      multiply, precondition, [](Block_vector<K>&) {}, r, x, target, iterations,
      maximum_iterations);
  for(std::size_t v = 0; v < n; ++v)
    if(rows[v] >= 0) {
      values.row(static_cast<Eigen::Index>(v)) = x.row(rows[v]);
      has_value[v] = 1;
    }
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_HARMONIC_FILL_H
