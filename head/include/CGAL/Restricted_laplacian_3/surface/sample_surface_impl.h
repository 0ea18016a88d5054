// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SAMPLE_SURFACE_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SAMPLE_SURFACE_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/morton_key.h>
#include <CGAL/Restricted_laplacian_3/surface/sample_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Numbers that are uniformly distributed in \f$[0, 1)\f$, the same with every compiler: the
/// generator is fixed by the standard, and its numbers are scaled here.
class Uniform_numbers {
public:
  explicit Uniform_numbers(std::uint64_t seed) : m_generator(seed) {}
  double operator()() { return std::ldexp(static_cast<double>(m_generator() >> 11), -53); }

private:
  std::mt19937_64 m_generator;
};

/// barycentric coordinates that are uniformly distributed in a triangle
inline std::array<double, 3> uniform_barycentric(Uniform_numbers& uniform) {
  const double root = std::sqrt(uniform()), v = uniform();
  return {1 - root, root * (1 - v), root * v};
}

/// Barycentric coordinates that are uniformly distributed in the part of a triangle that belongs to
/// a number in \f$[0, 1)\f$: of the four parts that its midpoints cut it into, repeatedly, the one
/// that the digits of the number to base 4 name. Numbers from an interval of length \f$4^{-k}\f$
/// that begins at a multiple of it stay in one of these triangles, so near numbers give near
/// locations.
inline std::array<double, 3> stratified_barycentric(double number, double smallest_part,
                                                    Uniform_numbers& uniform) {
  std::array<std::array<double, 3>, 3> corners = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  constexpr int most_digits = 20;
  double part = 1;
  for(int k = 0; k < most_digits && part > smallest_part; ++k, part /= 4) {
    number *= 4;
    const int digit = (std::min)(static_cast<int>(number), 3);
    number -= digit;
    const auto c = corners;
    // 0 is the middle part, with its corners opposite to those of the triangle
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        corners[i][j] = digit == 0 ? (c[(i + 1) % 3][j] + c[(i + 2) % 3][j]) / 2
                                   : (c[i][j] + c[digit - 1][j]) / 2;
  }
  const std::array<double, 3> b = uniform_barycentric(uniform);
  std::array<double, 3> result;
  for(int j = 0; j < 3; ++j)
    result[j] = b[0] * corners[0][j] + b[1] * corners[1][j] + b[2] * corners[2][j];
  return result;
}

/// the faces in Morton order of their centroids
inline std::vector<std::uint32_t> faces_along_curve(const Triangulated_surface_3& surface) {
  constexpr int bits = 16; // of each coordinate
  const double scale = std::ldexp(1., bits) / surface.extent();
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f) {
    std::array<int, 3> index = {0, 0, 0};
    for(int axis = 0; axis < 3 && !surface.is_degenerate(f); ++axis) {
      double x = 0;
      for(int corner = 0; corner < 3; ++corner)
        x += (surface.point(f, corner)[axis] - surface.bounding_box_min()[axis]) / 3;
      index[axis] = (std::min)((std::max)(static_cast<int>(x * scale), 0), (1 << bits) - 1);
    }
    keys.emplace_back(morton_key(index), static_cast<std::uint32_t>(f));
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> faces;
  for(const auto& key : keys)
    faces.push_back(key.second);
  return faces;
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<Surface_location>
sample_surface(const Triangulated_surface_3& surface, std::size_t number, std::uint64_t seed,
               Sampling sampling) {
  surface.require_triangles("a sample of it");
  if(number == 0)
    throw Parameter_error("samples", "is 0, but must be positive");
  const bool is_stratified = sampling == Sampling::stratified;
  std::vector<std::uint32_t> faces;
  if(is_stratified)
    faces = internal::faces_along_curve(surface);
  const auto face_at = [&](std::size_t i) { return is_stratified ? faces[i] : i; };
  std::vector<double> cumulated(surface.number_of_faces());
  double sum = 0;
  for(std::size_t i = 0; i < cumulated.size(); ++i)
    cumulated[i] = sum += surface.area(face_at(i));

  internal::Uniform_numbers uniform(seed);
  std::vector<Surface_location> samples(number);
  for(std::size_t k = 0; k < number; ++k) {
    const double x = is_stratified ? (static_cast<double>(k) + uniform()) / number : uniform();
    // The first face whose cumulated area is larger: never a degenerate one.
    const auto it = std::upper_bound(cumulated.begin(), cumulated.end(), x * sum);
    std::size_t i =
        (std::min)(static_cast<std::size_t>(it - cumulated.begin()), cumulated.size() - 1);
    while(surface.is_degenerate(face_at(i)))
      --i;
    samples[k].face = face_at(i);
    const double area = surface.area(samples[k].face);
    samples[k].barycentric = is_stratified
                                 ? internal::stratified_barycentric(
                                       (std::max)((x * sum - (cumulated[i] - area)) / area, 0.),
                                       sum / area / static_cast<double>(number), uniform)
                                 : internal::uniform_barycentric(uniform);
  }
  return samples;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SAMPLE_SURFACE_IMPL_H
