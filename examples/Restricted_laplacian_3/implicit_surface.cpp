// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces that are known better than by a mesh of them: a sphere and a torus, whose nearest points
// have a formula, and one that is where a function is 0. CGAL meshes each coarsely; area and first
// eigenvalue are then those of the facets, of a smooth surface through their vertices, and of the
// surface itself, by a projection to it and by CGAL's oracle of implicit surfaces.

#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>

#include <CGAL/IO/facets_in_complex_2_to_triangle_mesh.h>
#include <CGAL/Implicit_surface_3.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_default_triangulation_3.h>
#include <CGAL/Surface_mesh_traits_generator_3.h>
#include <CGAL/make_surface_mesh.h>

#include <cmath>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iomanip>
#include <iostream>
#include <stdexcept>
#include <string>

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;

using Triangulation = CGAL::Surface_mesh_default_triangulation_3;
using Kernel = Triangulation::Geom_traits;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Implicit_surface = CGAL::Implicit_surface_3<Kernel>;
using Oracle = CGAL::Surface_mesh_traits_generator_3<Implicit_surface>::type;
using Mesh = CGAL::Surface_mesh<Point>;

using Function = std::function<double(const Point&)>;
using Projection = std::function<Point(const Point&)>;

/// a function that is 0 on the surface, and its projection
struct Known_surface {
  Function function;
  Projection projection;
};

Known_surface sphere() {
  return {[](const Point& p) { return (p - CGAL::ORIGIN).squared_length() - 1; },
          [](const Point& p) {
            const Vector v = p - CGAL::ORIGIN;
            return CGAL::ORIGIN + v / std::sqrt(v.squared_length());
          }};
}

/// radii 1 and 0.4, around the z axis
Known_surface torus() {
  const auto center = [](const Point& p) { // of the circle that p is nearest to
    const double r = std::hypot(p.x(), p.y());
    return Point(p.x() / r, p.y() / r, 0);
  };
  return {[](const Point& p) {
            const double q = (p - CGAL::ORIGIN).squared_length() + 0.84;
            return q * q - 4 * (p.x() * p.x() + p.y() * p.y());
          },
          [=](const Point& p) {
            const Vector v = p - center(p);
            return center(p) + 0.4 / std::sqrt(v.squared_length()) * v;
          }};
}

Vector gradient(const Function& f, const Point& p) {
  constexpr double h = 1e-5;
  const auto derivative = [&](const Vector& v) { return (f(p + v) - f(p - v)) / (2 * h); };
  return Vector(derivative({h, 0, 0}), derivative({0, h, 0}), derivative({0, 0, h}));
}

/// a rounded cube with dimples; steps along the gradient lead to it
Known_surface dimpled_cube() {
  const Function f = [](const Point& p) {
    const double x = p.x() * p.x(), y = p.y() * p.y(), z = p.z() * p.z();
    return x * x + y * y + z * z - x - y - z + 0.4;
  };
  return {f, [=](Point p) {
            for(int step = 0; step < 10; ++step) {
              const Vector g = gradient(f, p);
              p = p - f(p) / g.squared_length() * g;
            }
            return p;
          }};
}

/// The same by CGAL's oracle: where a segment along the gradient meets the surface.
class Oracle_projection {
public:
  explicit Oracle_projection(const Implicit_surface& surface) : m_surface(surface) {}

  Point operator()(const Point& p) const {
    Vector g = gradient(m_surface.function(), p);
    g = g / std::sqrt(g.squared_length());
    auto intersect = m_oracle.intersect_3_object();
    for(double reach = 0.01; reach < 1; reach *= 2) {
      const CGAL::Object found =
          intersect(m_surface, Kernel::Segment_3(p - reach * g, p + reach * g));
      if(const auto* q = CGAL::object_cast<Oracle::Point_3>(&found))
        return *q;
    }
    throw std::runtime_error("no point of the surface is near a point of the mesh");
  }

private:
  const Implicit_surface& m_surface;
  Oracle m_oracle;
};

template <class NamedParameters>
void report(const std::string& name, const Mesh& mesh, const NamedParameters& np) {
  const RL::Laplace_spectrum s =
      RL::laplace_spectrum(mesh, 2, np.octree_depth(5).eigenvalues_only(true));
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
    const Known_surface known = name == "sphere"  ? sphere()
                                : name == "torus" ? torus()
                                                  : dimpled_cube();
    const Implicit_surface implicit(known.function, Kernel::Sphere_3(CGAL::ORIGIN, 4), 1e-10);

    CGAL::get_default_random() = CGAL::Random(0); // the same mesh each time
    Triangulation triangulation;
    CGAL::Complex_2_in_triangulation_3<Triangulation> complex(triangulation);
    const CGAL::Surface_mesh_default_criteria_3<Triangulation> criteria(30, size, size);
    CGAL::make_surface_mesh(complex, implicit, criteria, CGAL::Manifold_tag(), 40);
    Mesh mesh;
    CGAL::facets_in_complex_2_to_triangle_mesh(complex, mesh);
    std::cout << mesh.number_of_faces() << " triangles\n"
              << "geometry            area  eigenvalue\n"
              << std::setprecision(8);

    report("flat", mesh, params::surface_geometry(RL::Surface_geometry::flat));
    report("smooth", mesh, params::surface_geometry(RL::Surface_geometry::smooth));
    report("projection", mesh, params::surface_geometry(known.projection));
    report("oracle", mesh, params::surface_geometry(Oracle_projection(implicit)));
    return 0;
  } catch(const std::exception& e) {
    std::cerr << "implicit_surface: " << e.what() << '\n';
    return 1;
  }
}
