// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_BENCHMARK_SPECTRA_H
#define RESTRICTED_LAPLACIAN_3_BENCHMARK_SPECTRA_H

// Spectra of both operators, their differences, and references for meshes whose spectrum is not
// known.

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/assembly/cotangent_operators.h>
#include <CGAL/Restricted_laplacian_3/spectra/smallest_eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

namespace benchmarks {

namespace RL = CGAL::Restricted_laplacian_3;

struct Spectrum {
  Eigen::VectorXd values; // without those of the kernel, times area
  double area = 0;        // of the surface: the masses of the paper's space do not sum to it
  std::size_t unknowns = 0;
  double sheets_per_cell = 0;
  double assembly_seconds = 0;
  double eigenvalue_seconds = 0;
};

/// The smallest eigenvalues after the first `kernel` ones; progress on the error stream.
/// \pre the area is known
inline void solve(const RL::Operators& operators, int kernel, int count, Spectrum& spectrum) {
  CGAL::Real_timer timer;
  timer.start();
  RL::Eigenpairs_options options;
  options.tolerance = 1e-8;
  const RL::Eigenpairs pairs =
      RL::smallest_eigenpairs(operators.stiffness, operators.mass, kernel + count, options);
  if(!pairs.converged)
    throw std::runtime_error("the eigenvalues did not converge");
  spectrum.unknowns = static_cast<std::size_t>(operators.stiffness.rows());
  spectrum.values = pairs.values.tail(count) * spectrum.area;
  spectrum.eigenvalue_seconds = timer.time();
  std::fprintf(stderr, "%zu unknowns, %.1f s + %.1f s\n", spectrum.unknowns,
               spectrum.assembly_seconds, spectrum.eigenvalue_seconds);
}

/// the spaces that are compared
enum class Space { paper, unsplit, split };

inline const char* name_of(Space space) {
  return space == Space::paper ? "paper" : space == Space::unsplit ? "unsplit" : "split";
}

inline RL::Spline_space_3 space_of(const RL::Triangulated_surface_3& surface, Space space,
                                   int depth) {
  RL::Spline_space_options options;
  options.depth = depth;
  options.paper = space == Space::paper;
  options.split = space == Space::split;
  return RL::Spline_space_3(surface, options);
}

inline Spectrum restricted_spectrum(const RL::Triangulated_surface_3& surface, Space space_name,
                                    int depth, int kernel, int count) {
  std::fprintf(stderr, "  %s, depth %d: ", name_of(space_name), depth);
  Spectrum spectrum;
  CGAL::Real_timer timer;
  timer.start();
  RL::Operators operators;
  {
    const RL::Spline_space_3 space = space_of(surface, space_name, depth);
    spectrum.sheets_per_cell = static_cast<double>(space.octree().number_of_sheets(depth)) /
                               static_cast<double>(space.octree().number_of_cells(depth));
    operators = RL::assemble_operators(space);
  }
  spectrum.assembly_seconds = timer.time();
  spectrum.area = surface.area();
  solve(operators, kernel, count, spectrum);
  return spectrum;
}

inline Spectrum cotangent_spectrum(const RL::Triangulated_surface_3& surface, int kernel,
                                   int count) {
  std::fprintf(stderr, "  cotangent: ");
  Spectrum spectrum;
  CGAL::Real_timer timer;
  timer.start();
  const RL::Operators operators = RL::cotangent_operators(surface);
  spectrum.assembly_seconds = timer.time();
  spectrum.area = surface.area();
  solve(operators, kernel, count, spectrum);
  return spectrum;
}

/// number of connected components of a surface, which is the dimension of the kernel
inline int number_of_components(const RL::Triangulated_surface_3& surface) {
  const RL::Spline_space_3 space = space_of(surface, Space::split, 1);
  return static_cast<int>(space.octree().number_of_sheets(0));
}

/// each triangle cut into four by the midpoints of its sides
inline RL::Triangulated_surface_3 refined(const RL::Triangulated_surface_3& surface) {
  std::vector<RL::Point_3> points;
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
    points.push_back(surface.point(v));
  std::unordered_map<std::uint64_t, std::uint32_t> midpoints;
  const auto midpoint = [&](std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax(a, b);
    const auto [it, is_new] =
        midpoints.insert({std::uint64_t(low) << 32 | high, std::uint32_t(points.size())});
    if(is_new)
      points.push_back(CGAL::midpoint(surface.point(low), surface.point(high)));
    return it->second;
  };
  std::vector<RL::Triangulated_surface_3::Triangle> finer;
  for(std::size_t i = 0; i < surface.number_of_faces(); ++i) {
    const auto& f = surface.triangle(i);
    const std::uint32_t a = midpoint(f[0], f[1]), b = midpoint(f[1], f[2]),
                        c = midpoint(f[2], f[0]);
    finer.insert(finer.end(), {{f[0], a, c}, {a, f[1], b}, {c, b, f[2]}, {a, b, c}});
  }
  return RL::Triangulated_surface_3(std::move(points), std::move(finer));
}

/// differences of eigenvalues relative to those of a reference, in percent
struct Difference {
  Difference(const Eigen::VectorXd& values, const Eigen::VectorXd& reference) {
    const Eigen::ArrayXd d = 100 * ((values - reference).array() / reference.array()).abs();
    largest = d.maxCoeff(&position);
    mean = d.mean();
  }
  double largest, mean;
  Eigen::Index position;
};

inline void print_values(const char* name, const Eigen::VectorXd& values) {
  std::printf("# %s:", name);
  for(double value : values)
    std::printf(" %.6g", value);
  std::printf("\n");
}

/// The cotangent operator after as many midpoint refinements as fit, but at most `most`, and after
/// one less.
struct Cotangent_reference {
  Cotangent_reference(RL::Triangulated_surface_3 surface, int kernel, int count, int most = 3,
                      std::size_t largest_number_of_vertices = 1200000) {
    // A triangulation has about 3/2 edges for each triangle.
    const auto vertices_of_refined = [](const RL::Triangulated_surface_3& s) {
      return s.number_of_vertices() + s.number_of_faces() * 3 / 2;
    };
    for(; refinements < most; ++refinements) {
      if(vertices_of_refined(surface) > largest_number_of_vertices)
        break;
      // Two spectra will do, but which refinement is the last is known only here.
      RL::Triangulated_surface_3 finer = refined(surface);
      const bool is_last =
          refinements == most - 1 || vertices_of_refined(finer) > largest_number_of_vertices;
      if(is_last) {
        coarse = cotangent_spectrum(surface, kernel, count);
        fine = cotangent_spectrum(finer, kernel, count);
      }
      surface = std::move(finer);
    }
    if(refinements > 0)
      extrapolated = fine.values + (fine.values - coarse.values) / 3;
  }

  /// Whether the last two refinements agree within `percent`, for all eigenvalues.
  bool counts(double percent) const {
    return refinements > 0 && Difference(fine.values, coarse.values).largest <= percent;
  }

  int refinements = 0;
  Spectrum coarse, fine;
  Eigen::VectorXd extrapolated;
};

} // namespace benchmarks

#endif // RESTRICTED_LAPLACIAN_3_BENCHMARK_SPECTRA_H
