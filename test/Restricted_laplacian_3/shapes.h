// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_TEST_SHAPES_H
#define RESTRICTED_LAPLACIAN_3_TEST_SHAPES_H

#include "test_meshes.h"

#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

/// \file
/// Shapes that tests generate, as points and triangles and as meshes.

namespace shapes {

namespace RL = CGAL::Restricted_laplacian_3;
using Mesh = CGAL::Surface_mesh<RL::Point_3>;

struct Triangles {
  std::vector<RL::Point_3> points;
  std::vector<std::array<std::uint32_t, 3>> faces;
};

inline Mesh mesh(const Triangles& t) {
  Mesh result;
  for(const RL::Point_3& p : t.points)
    result.add_vertex(p);
  for(const auto& f : t.faces)
    result.add_face(Mesh::Vertex_index(f[0]), Mesh::Vertex_index(f[1]), Mesh::Vertex_index(f[2]));
  return result;
}

inline Triangles triangles(const Mesh& mesh) {
  Triangles result;
  const RL::Triangulated_surface_3 surface = RL::read_surface(mesh);
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
    result.points.push_back(surface.point(v));
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    result.faces.push_back(surface.triangle(f));
  return result;
}

/// splits each triangle into four at the midpoints of its sides
inline Triangles split_in_four(const Triangles& t) {
  Triangles result;
  result.points = t.points;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> midpoints;
  const auto midpoint = [&](std::uint32_t a, std::uint32_t b) {
    const auto [it, is_new] =
        midpoints.insert({std::minmax(a, b), static_cast<std::uint32_t>(result.points.size())});
    if(is_new)
      result.points.push_back(CGAL::midpoint(t.points[a], t.points[b]));
    return it->second;
  };
  for(const auto& f : t.faces) {
    const std::uint32_t a = midpoint(f[0], f[1]), b = midpoint(f[1], f[2]),
                        c = midpoint(f[2], f[0]);
    result.faces.push_back({f[0], a, c});
    result.faces.push_back({a, f[1], b});
    result.faces.push_back({c, b, f[2]});
    result.faces.push_back({a, b, c});
  }
  return result;
}

/// the octahedron, split `n` times and projected to the unit sphere: 4^(n+1) + 2 vertices
inline Triangles sphere(int n) {
  Triangles t;
  t.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  t.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
             {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for(int i = 0; i < n; ++i) {
    t = split_in_four(t);
    for(RL::Point_3& p : t.points) {
      const RL::Vector_3 v = p - CGAL::ORIGIN;
      p = CGAL::ORIGIN + v / std::sqrt(v.squared_length());
    }
  }
  return t;
}

/// A box with `n` x `n` squares a side, each cut along one of its two diagonals, chosen by `seed`:
/// different seeds triangulate the same surface.
inline Triangles box(double x, double y, double z, int n, unsigned seed) {
  Triangles t;
  std::mt19937 generator(seed);
  std::map<std::array<int, 3>, std::uint32_t> numbers;
  const auto vertex = [&](const std::array<int, 3>& i) {
    const auto [it, is_new] = numbers.insert({i, static_cast<std::uint32_t>(t.points.size())});
    if(is_new)
      t.points.emplace_back(x * i[0] / n, y * i[1] / n, z * i[2] / n);
    return it->second;
  };
  for(int axis = 0; axis < 3; ++axis)
    for(int side = 0; side < 2; ++side)
      for(int i = 0; i < n; ++i)
        for(int j = 0; j < n; ++j) {
          std::array<std::uint32_t, 4> v;
          for(int corner = 0; corner < 4; ++corner) {
            std::array<int, 3> index;
            index[axis] = side * n;
            index[(axis + 1) % 3] = i + (corner == 1 || corner == 2);
            index[(axis + 2) % 3] = j + (corner >= 2);
            v[corner] = vertex(index);
          }
          if(side == 0)
            std::swap(v[1], v[3]);
          if(generator() & 1u) {
            t.faces.push_back({v[0], v[1], v[2]});
            t.faces.push_back({v[0], v[2], v[3]});
          } else {
            t.faces.push_back({v[0], v[1], v[3]});
            t.faces.push_back({v[1], v[2], v[3]});
          }
        }
  return t;
}

/// A square of `n` x `n` squares with a triangle of random height at each side of its right and
/// upper boundary: their tips reach into cells of which they fill little. It is flat but for waves
/// of a height.
inline Triangles ragged_square(int n, double height, unsigned seed) {
  Triangles t;
  std::mt19937 generator(seed);
  const auto random = [&generator] { return generator() * std::ldexp(1., -32); };
  const auto vertex = [&](double i, double j) {
    const double x = i / n, y = j / n;
    t.points.emplace_back(x, y, height * std::sin(7 * x) * std::cos(5 * y));
    return static_cast<std::uint32_t>(t.points.size() - 1);
  };
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= n; ++i)
      vertex(i, j);
  const auto number = [n](int i, int j) { return static_cast<std::uint32_t>(i + (n + 1) * j); };
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < n; ++i) {
      t.faces.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1)});
      t.faces.push_back({number(i, j), number(i + 1, j + 1), number(i, j + 1)});
    }
  for(int i = 0; i < n; ++i) {
    const double along = i + random(), up = n + 2 * random();
    t.faces.push_back({number(i + 1, n), vertex(along, up), number(i, n)});
    const double beside = i + random(), out = n + 2 * random();
    t.faces.push_back({number(n, i), vertex(out, beside), number(n, i + 1)});
  }
  return t;
}

/// A square of `n` x `n` squares with bumps of random directions, half as long from octave to
/// octave: a level of the octree whose cells are much larger cuts it into many pieces.
inline Triangles bumpy_square(int n, double height, int octaves, unsigned seed) {
  std::mt19937 generator(seed);
  const auto random_angle = [&generator] {
    return 2 * CGAL_PI * generator() * std::ldexp(1., -32);
  };
  struct Wave {
    double x, y, phase, height;
  };
  std::vector<Wave> waves;
  for(int octave = 0; octave < octaves; ++octave)
    for(int k = 0; k < 6; ++k) {
      const double frequency = std::ldexp(6., octave), angle = random_angle();
      waves.push_back({frequency * std::cos(angle), frequency * std::sin(angle), random_angle(),
                       height * std::pow(0.7, octave)});
    }
  Triangles t;
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= n; ++i) {
      const double x = static_cast<double>(i) / n, y = static_cast<double>(j) / n;
      double z = 0;
      for(const Wave& wave : waves)
        z += wave.height * std::sin(wave.x * x + wave.y * y + wave.phase);
      t.points.emplace_back(x, y, z);
    }
  const auto number = [n](int i, int j) { return static_cast<std::uint32_t>(i + (n + 1) * j); };
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < n; ++i) {
      t.faces.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1)});
      t.faces.push_back({number(i, j), number(i + 1, j + 1), number(i, j + 1)});
    }
  return t;
}

/// Reads a mesh file; the mesh is empty if there is no such file. Not inline, because the readers
/// of all formats take long to compile.
Mesh read(const std::string& path);

/// QSlim: a closed mesh with so many vertices that stands for the same surface. Not inline, because
/// it takes long to compile.
Mesh simplified(Mesh mesh, std::size_t vertices);

} // namespace shapes

#endif // RESTRICTED_LAPLACIAN_3_TEST_SHAPES_H
