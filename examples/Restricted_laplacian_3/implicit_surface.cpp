// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces that are known better than by a mesh of them: a sphere and a torus, whose nearest points
// have a formula, and a rounded cube, where a function is 0. Each is meshed coarsely; area and
// first eigenvalue are then those of the triangles, of a smooth surface through their vertices, and
// of the surface itself, by a projection to it.

#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <cmath>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iomanip>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Projection = std::function<Point(const Point&)>;

/// a mesh of a few triangles, and what takes points near the surface to it
struct Known_surface {
  Mesh mesh;
  Projection projection;
};

Mesh icosahedron() {
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1.0);
  return mesh;
}

Known_surface sphere() {
  return {icosahedron(), [](const Point& p) {
            const Vector v = p - CGAL::ORIGIN;
            return CGAL::ORIGIN + v / std::sqrt(v.squared_length());
          }};
}

/// radii 1 and 0.4, around the z axis
Known_surface torus() {
  constexpr int around = 10, across = 5;
  constexpr double pi = 3.14159265358979323846;
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for(int i = 0; i < around; ++i)
    for(int j = 0; j < across; ++j) {
      const double a = 2 * pi * i / around, b = 2 * pi * j / across, r = 1 + 0.4 * std::cos(b);
      v.push_back(mesh.add_vertex(Point(r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b))));
    }
  for(int i = 0; i < around; ++i)
    for(int j = 0; j < across; ++j) {
      const auto at = [&](int k, int l) {
        return v[std::size_t((i + k) % around * across + (j + l) % across)];
      };
      mesh.add_face(at(0, 0), at(1, 0), at(1, 1));
      mesh.add_face(at(0, 0), at(1, 1), at(0, 1));
    }
  return {std::move(mesh), [](const Point& p) {
            const double r = std::hypot(p.x(), p.y());
            const Point center(p.x() / r, p.y() / r, 0); // of the circle that p is nearest to
            const Vector v = p - center;
            return center + 0.4 / std::sqrt(v.squared_length()) * v;
          }};
}

/// x^4 + y^4 + z^4 = 1; steps along the gradient lead to it
Known_surface rounded_cube() {
  return {icosahedron(), [](Point p) {
            for(int step = 0; step < 10; ++step) {
              const double x = p.x(), y = p.y(), z = p.z();
              const double f = std::pow(x, 4) + std::pow(y, 4) + std::pow(z, 4) - 1;
              const Vector gradient(4 * x * x * x, 4 * y * y * y, 4 * z * z * z);
              p = p - f / gradient.squared_length() * gradient;
            }
            return p;
          }};
}

/// divides triangles into four until their edges have the length `size` or less on average
void refine(Known_surface& s, double size) {
  for(double mean = 2 * size; mean > size;) {
    CGAL::Subdivision_method_3::Loop_subdivision(s.mesh, CGAL::parameters::number_of_iterations(1));
    mean = 0;
    for(const Mesh::Vertex_index v : vertices(s.mesh))
      s.mesh.point(v) = s.projection(s.mesh.point(v));
    for(const Mesh::Edge_index e : edges(s.mesh)) {
      const Vector side = s.mesh.point(s.mesh.vertex(e, 0)) - s.mesh.point(s.mesh.vertex(e, 1));
      mean += std::sqrt(side.squared_length()) / double(num_edges(s.mesh));
    }
  }
}

template <class NamedParameters>
void report(const std::string& name, const Mesh& mesh, const NamedParameters& np) {
  const RL::Laplace_spectrum s = RL::laplace_spectrum(mesh, 2, np.depth(5).eigenvalues_only(true));
  std::cout << std::left << std::setw(12) << name << std::right << std::setw(12) << s.area
            << std::setw(12) << s.eigenvalues[1] << '\n';
}

int main(int argc, char* argv[]) {
  const std::string name = argc > 1 ? argv[1] : "";
  const double size = argc > 2 ? std::atof(argv[2]) : 0.2; // of triangles
  if(argc > 3 || !(size > 0.01 && size < 1) ||
     (name != "sphere" && name != "torus" && name != "cube")) {
    std::cerr << "usage: implicit_surface sphere|torus|cube [SIZE]\n";
    return 1;
  }
  try {
    Known_surface known = name == "sphere" ? sphere() : name == "torus" ? torus() : rounded_cube();
    refine(known, size);
    std::cout << num_faces(known.mesh) << " triangles\n"
              << "geometry            area  eigenvalue\n"
              << std::setprecision(8);

    report("flat", known.mesh, params::geometry(RL::Surface_geometry::flat));
    report("smooth", known.mesh, params::geometry(RL::Surface_geometry::smooth));
    report("projection", known.mesh, params::geometry(known.projection));
    return 0;
  } catch(const std::exception& e) {
    std::cerr << "implicit_surface: " << e.what() << '\n';
    return 1;
  }
}
