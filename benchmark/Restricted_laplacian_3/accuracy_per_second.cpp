// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What accuracy does a second buy? Poisson problems and spectra with known solutions, on refined
// meshes of a sphere (radius 1) and a torus (radii 1 and 0.4), by this package at several depths
// and by the cotangent Laplacian.
//
// Time is that from a mesh in memory to values at its vertices: matrices, setup, solution. Each is
// the median of the repetitions.
// - restricted: this package with its default solver, which gets the right-hand side as a function
//   and evaluates it at the 16 nodes of its cubature in each part of a triangle in a cell
// - restricted_v: the same with the values of the right-hand side at the vertices, as the cotangent
//   methods have them
// - smooth, smooth_v: the same two on the smooth surface through the vertices, values at them
//   interpolated smoothly; the vertices of these meshes lie on the sphere or torus
// - cot_cholmod: the cotangent Laplacian, a vertex held at 0, CHOLMOD with AMD ordering
// - cot_amg: conjugate gradients with BoomerAMG, configuration amg2 of support/boomer_amg.h
// - cot_cholmod_f, cot_amg_f: the same two with the right-hand side as a function, integrated
//   against hat functions by a rule of degree 4; the others interpolate it linearly
// The iterative ones run to each of the tolerances (of the residual, relative).
//
// Poisson: on the sphere the sum of harmonics of degrees 2, 5, 9 and 14 about different axes, on
// the torus a sum of two products of sines and cosines of its angles. The error is the root mean
// square over the vertices, weighted by area, relative to that of the solution.
//
// Spectra: the error is the largest relative one of the first 30 non-zero eigenvalues, against
// l (l + 1) on the sphere. On the torus the problem separates into periodic ones in one angle,
// which a Fourier method solves to about 1e-12. Both operators go through smallest_eigenpairs():
// Spectra, shift-invert, CHOLMOD.
//
// First all pairs of time and error; then, for a row of errors, the least time of each method that
// is at least that accurate, whatever mesh and depth it takes; and the same on the second mesh
// alone (8,192 triangles on the sphere, 5,120 on the torus): who has a mesh cannot choose it.
//
// Spaces with more than 16 unknowns for a vertex of the mesh are left out, because their error is
// that of the flat triangles, and those with fewer than 1/32, because a coarser mesh does as well.
//
// usage: accuracy_per_second [OPTION]...

#include "support/driver.h"
#include "support/linear_solvers.h"
#include "support/measure.h"
#include "support/package.h"
#include "support/sphere.h"

#include <CGAL/Restricted_laplacian_3/assembly/cotangent_operators.h>
#include <CGAL/Restricted_laplacian_3/integration/triangle_quadrature.h>
#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/patches/curved_surface.h>
#include <CGAL/Restricted_laplacian_3/patches/smooth_vertex_data.h>
#include <CGAL/Restricted_laplacian_3/spectra/smallest_eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>

#include <Eigen/Dense>
#include <HYPRE.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace RL = CGAL::Restricted_laplacian_3;
using namespace benchmarks;

namespace {

constexpr double pi = 3.14159265358979323846;

struct Options {
  int smallest_mesh = 0, meshes = 6, repetitions = 3, threads = 1;
  std::vector<int> depths = {4, 5, 6, 7, 8}, spectrum_depths = {3, 4, 5, 6};
  std::vector<double> tolerances = {1e-3};
  std::vector<std::string> parts = {"poisson", "spectrum"};
  double stabilization = default_stabilization();
  int eigenvalues = 30;
};

// A surface with the exact solutions on it.
struct Shape {
  std::string name;
  std::function<RL::Triangulated_surface_3(int)> mesh; // each finer than the one before
  // near the surface, of the nearest point on it
  std::function<double(const RL::Point_3&)> solution, laplacian;
  std::function<std::vector<double>(int)> eigenvalues; // that many, after the 0
};

std::complex<double> power(std::complex<double> z, int exponent) {
  std::complex<double> result = 1;
  for(; exponent > 0; exponent /= 2, z *= z)
    if(exponent % 2 == 1)
      result *= z;
  return result;
}

// u and its Laplacian at a point of the sphere
std::pair<double, double> harmonics(const RL::Point_3& p) {
  // null vectors x + i y of four frames give harmonic polynomials (a . p)^l
  constexpr std::array<std::array<double, 6>, 4> frames = {{
      {1, 0, 0, 0, 1, 0},
      {2. / 3, 2. / 3, 1. / 3, -2. / 3, 1. / 3, 2. / 3},
      {0.6, 0, 0.8, 0, 1, 0},
      {0, 0.28, 0.96, 1, 0, 0},
  }};
  constexpr std::array<int, 4> degrees = {2, 5, 9, 14};
  const double r = std::sqrt((p - CGAL::ORIGIN).squared_length());
  double u = 0, laplacian = 0;
  for(int i = 0; i < 4; ++i) {
    const auto& a = frames[i];
    const std::complex<double> z((a[0] * p.x() + a[1] * p.y() + a[2] * p.z()) / r,
                                 (a[3] * p.x() + a[4] * p.y() + a[5] * p.z()) / r);
    const double h = std::real(power(z, degrees[i]));
    u += h;
    laplacian -= degrees[i] * (degrees[i] + 1) * h;
  }
  return {u, laplacian};
}

std::vector<double> sphere_eigenvalues(int count) {
  std::vector<double> values;
  for(int l = 1; static_cast<int>(values.size()) < count; ++l)
    for(int m = -l; m <= l && static_cast<int>(values.size()) < count; ++m)
      values.push_back(l * (l + 1));
  return values;
}

constexpr double large_radius = 1, small_radius = 0.4;

// 40 x 16 quadrilaterals for n = 0, four times as many for the next, each cut in two
RL::Triangulated_surface_3 torus(int n) {
  const std::uint32_t columns = 40u << n, rows = 16u << n;
  std::vector<RL::Point_3> points;
  std::vector<RL::Triangulated_surface_3::Triangle> faces;
  for(std::uint32_t i = 0; i < columns; ++i)
    for(std::uint32_t j = 0; j < rows; ++j) {
      const double phi = 2 * pi * i / columns, theta = 2 * pi * j / rows;
      const double distance = large_radius + small_radius * std::cos(theta);
      points.emplace_back(distance * std::cos(phi), distance * std::sin(phi),
                          small_radius * std::sin(theta));
      const std::uint32_t a = i * rows + j, b = (i + 1) % columns * rows + j,
                          c = (i + 1) % columns * rows + (j + 1) % rows,
                          d = i * rows + (j + 1) % rows;
      faces.insert(faces.end(), {{a, b, c}, {a, c, d}});
    }
  return RL::Triangulated_surface_3(std::move(points), std::move(faces));
}

// u and its Laplacian at a point of the torus
std::pair<double, double> torus_functions(const RL::Point_3& p) {
  const double phi = std::atan2(p.y(), p.x());
  const double theta = std::atan2(p.z(), std::hypot(p.x(), p.y()) - large_radius);
  const double u1 = std::sin(3 * phi) * std::cos(2 * theta), u2 = std::cos(2 * phi + theta);
  const double by_theta = -2 * std::sin(3 * phi) * std::sin(2 * theta) - std::sin(2 * phi + theta);
  const double by_theta_twice = -4 * u1 - u2, by_phi_twice = -9 * u1 - 4 * u2;
  const double w = large_radius + small_radius * std::cos(theta);
  return {u1 + u2, by_theta_twice / (small_radius * small_radius) -
                       std::sin(theta) / (small_radius * w) * by_theta + by_phi_twice / (w * w)};
}

// Eigenfunctions are v(theta) times the sine or cosine of k phi, with
//   int w / r^2 v' q' + k^2 / w v q = lambda int w v q   for all q,   w = R + r cos theta.
std::vector<double> torus_eigenvalues(int count) {
  constexpr int modes = 24, nodes = 256, size = 2 * modes + 1;
  std::vector<double> values;
  for(int k = 0; k <= count; ++k) {
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(size, size), b = a;
    for(int node = 0; node < nodes; ++node) {
      const double theta = 2 * pi * node / nodes;
      const double w = large_radius + small_radius * std::cos(theta);
      Eigen::VectorXd v(size), d(size);
      v[0] = 1;
      d[0] = 0;
      for(int m = 1; m <= modes; ++m) {
        v[2 * m - 1] = std::cos(m * theta);
        d[2 * m - 1] = -m * std::sin(m * theta);
        v[2 * m] = std::sin(m * theta);
        d[2 * m] = m * std::cos(m * theta);
      }
      a += w / (small_radius * small_radius) * d * d.transpose() + k * k / w * v * v.transpose();
      b += w * v * v.transpose();
    }
    const Eigen::VectorXd lambda =
        Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(a, b, Eigen::EigenvaluesOnly)
            .eigenvalues();
    for(int i = 0; i < lambda.size(); ++i)
      values.insert(values.end(), k == 0 ? 1 : 2, lambda[i]);
  }
  std::sort(values.begin(), values.end());
  return {values.begin() + 1, values.begin() + 1 + count};
}

std::vector<Shape> shapes() {
  return {{"sphere", [](int n) { return sphere(4 + n); },
           [](const RL::Point_3& p) { return harmonics(p).first; },
           [](const RL::Point_3& p) { return harmonics(p).second; }, sphere_eigenvalues},
          {"torus", [](int n) { return torus(n); },
           [](const RL::Point_3& p) { return torus_functions(p).first; },
           [](const RL::Point_3& p) { return torus_functions(p).second; }, torus_eigenvalues}};
}

// One way to the solution: what it takes, and what it gives.
struct Run : Solver_run {
  double assembly_seconds, error;
  std::size_t unknowns;
};

struct Result {
  std::string method;
  std::size_t faces;
  double seconds, error;
};

// All runs on one shape.
class Table {
public:
  Table(const Options& o, std::string shape) : m_options(o), m_shape(std::move(shape)) {}

  // Repeats a run and prints medians. `parameters` tells apart runs of one method.
  template <class Method>
  void add(const std::string& method, const std::string& parameters, std::size_t faces,
           Method&& run) {
    std::vector<double> assembly, setup, solve;
    Run last{};
    for(int i = 0; i < m_options.repetitions; ++i) {
      last = run();
      assembly.push_back(last.assembly_seconds);
      setup.push_back(last.setup_seconds);
      solve.push_back(last.solve_seconds);
    }
    const double total = median(assembly) + median(setup) + median(solve);
    std::printf("%-7s %8zu %-13s %-9s %8zu %8.3f %8.3f %8.3f %8.3f %9.2e %3s\n", m_shape.c_str(),
                faces, method.c_str(), parameters.c_str(), last.unknowns, median(assembly),
                median(setup), median(solve), total, last.error, last.converged ? "yes" : "no");
    std::fflush(stdout);
    m_results.push_back({method, faces, total, last.error});
  }

  // on all meshes, or on those with that many faces
  void print_pareto(const std::string& what, const std::vector<std::string>& methods,
                    std::size_t faces = 0) const {
    constexpr std::array<double, 10> errors = {1e-1, 3e-2,   1e-2, 3e-3, 1e-3,
                                               3e-4, 1.5e-4, 1e-4, 3e-5, 1e-5};
    const auto counts = [faces](const Result& r) { return faces == 0 || r.faces == faces; };
    std::printf(
        "\n\n# %s, %s, least seconds%s\n# least seconds for an error of at most that; cot / "
        "restricted: "
        "above 1 the package is faster\n# %-7s",
        m_shape.c_str(), what.c_str(),
        faces > 0 ? (" on " + std::to_string(faces) + " faces").c_str() : "", "error");
    for(const std::string& method : methods)
      std::printf(" %13s", method.c_str());
    std::printf(" %12s\n", "cot/restr");
    for(double error : errors) {
      if(std::none_of(m_results.begin(), m_results.end(),
                      [&](const Result& r) { return counts(r) && r.error <= error; }))
        break;
      std::printf("%9.1e", error);
      double restricted = std::nan(""), cotangent = std::nan("");
      for(const std::string& method : methods) {
        double seconds = std::nan("");
        for(const Result& r : m_results)
          if(counts(r) && r.method == method && r.error <= error)
            seconds = std::fmin(seconds, r.seconds);
        double& best = method.rfind("cot", 0) == 0 ? cotangent : restricted;
        best = std::fmin(best, seconds);
        std::printf(" %13.3f", seconds);
      }
      std::printf(" %12.2f\n", cotangent / restricted);
    }
    std::printf("\n\n");
  }

private:
  const Options& m_options;
  std::string m_shape;
  std::vector<Result> m_results;
};

// The root mean square over the vertices of u - v, weighted by area, relative to that of v; their
// means are made equal.
double relative_error(const RL::Triangulated_surface_3& surface, const double* u,
                      const Shape& shape) {
  std::vector<double> weights(surface.number_of_vertices(), 0.), exact;
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for(const std::uint32_t v : surface.triangle(f))
      weights[v] += surface.area(f) / (3 * surface.area());
  double mean = 0;
  for(std::size_t v = 0; v < weights.size(); ++v) {
    exact.push_back(shape.solution(surface.point(v)));
    mean += weights[v] * (u[v] - exact[v]);
  }
  double error = 0, norm = 0;
  for(std::size_t v = 0; v < weights.size(); ++v) {
    error += weights[v] * std::pow(u[v] - exact[v] - mean, 2);
    norm += weights[v] * exact[v] * exact[v];
  }
  return std::sqrt(error / norm);
}

// linear, or smooth on a smooth surface
RL::Cubic_surface_function<double>
interpolated(const RL::Triangulated_surface_3& surface,
             const std::function<double(const RL::Point_3&)>& f) {
  std::vector<double> values;
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
    values.push_back(f(surface.point(v)));
  return surface.is_smooth() ? RL::Cubic_surface_function<double>(surface, std::move(values))
                             : RL::Cubic_surface_function<double>(std::move(values));
}

Run restricted_poisson(const Options& o, const Shape& shape, const RL::Triangulated_surface_3& mesh,
                       int depth, double tolerance, bool is_smooth, bool has_function) {
  Run run;
  Stopwatch watch;
  const RL::Spline_space_3 space(is_smooth ? RL::curved_surface(mesh) : mesh,
                                 space_options(depth, true, o.threads));
  const RL::Triangulated_surface_3& surface = space.surface();
  const auto laplacian = [&](const RL::Surface_point& p) { return shape.laplacian(p.point); };
  const Eigen::VectorXd load =
      has_function ? RL::assemble_load(space, RL::function_of_degree(laplacian, 2))
                   : RL::assemble_load(space, interpolated(surface, shape.laplacian));
  run.unknowns = space.dimension();
  const RL::Poisson_solver solver = poisson_solver(space, o.stabilization, o.threads, tolerance);
  run.setup_seconds = solver.setup_seconds();
  run.assembly_seconds = watch.lap() - run.setup_seconds;
  Eigen::VectorXd eta;
  run.converged = solver.solve(-load, eta).converged;
  const std::vector<double> u = RL::Spline_function_3(space, eta).values_at_vertices();
  run.solve_seconds = watch.lap();
  run.error = relative_error(surface, u.data(), shape);
  return run;
}

// minus the integrals of the right-hand side, without its mean, times hat functions
// `areas`: those of the hat functions
Eigen::VectorXd integrated_load(const Shape& shape, const RL::Triangulated_surface_3& surface,
                                const Eigen::VectorXd& areas) {
  Eigen::VectorXd b =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(surface.number_of_vertices()));
  const std::vector<RL::Triangle_quadrature_node> rule = RL::triangle_quadrature(4);
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for(const RL::Triangle_quadrature_node& node : rule) {
      const std::array<double, 3> l = {node.b0, node.b1, node.b2};
      RL::Surface_location location;
      location.face = f;
      location.barycentric = l;
      const double value =
          surface.area(f) * node.weight * shape.laplacian(surface.surface_point(location).point);
      for(int i = 0; i < 3; ++i)
        b[surface.triangle(f)[i]] -= value * l[i];
    }
  return b - areas * (b.sum() / areas.sum());
}

// `solve(a, b, u)` returns the times of setup and solution
template <class Solve>
Run cotangent_poisson(const Shape& shape, const RL::Triangulated_surface_3& surface,
                      bool has_function, Solve&& solve) {
  Run run;
  Stopwatch watch;
  const RL::Operators both = RL::cotangent_operators(surface);
  const auto n = static_cast<Eigen::Index>(surface.number_of_vertices());
  Eigen::VectorXd b, u(n);
  if(has_function) {
    b = integrated_load(shape, surface, both.mass * Eigen::VectorXd::Ones(n));
  } else {
    Eigen::VectorXd f(n);
    for(Eigen::Index v = 0; v < n; ++v)
      f[v] = shape.laplacian(surface.point(v));
    b = poisson_load(both.mass, f);
  }
  run.unknowns = surface.number_of_vertices();
  run.assembly_seconds = watch.lap();
  static_cast<Solver_run&>(run) = solve(both.stiffness, b, u);
  run.error = relative_error(surface, u.data(), shape);
  return run;
}

std::string label(const char* format, double x) {
  char text[32];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

// those whose spaces are neither much finer nor much coarser than the mesh
std::vector<int> depths_for(const RL::Triangulated_surface_3& surface,
                            const std::vector<int>& depths) {
  constexpr double most = 16, least = 1. / 32; // unknowns for a vertex
  std::vector<int> result;
  for(int depth : depths) {
    const double unknowns =
        static_cast<double>(RL::Spline_space_3(surface, space_options(depth, true, 1)).dimension());
    const double ratio = unknowns / static_cast<double>(surface.number_of_vertices());
    if(ratio >= least && ratio <= most)
      result.push_back(depth);
  }
  return result;
}

void compare_poisson(const Options& o, const Shape& shape) {
  Table table(o, shape.name);
  for(int n = o.smallest_mesh; n < o.smallest_mesh + o.meshes; ++n) {
    const RL::Triangulated_surface_3 surface = shape.mesh(n);
    const std::size_t faces = surface.number_of_faces();
    for(bool has_function : {false, true}) {
      const std::string ending = has_function ? "_f" : "";
#ifdef CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD
      table.add("cot_cholmod" + ending, "-", faces,
                [&] { return cotangent_poisson(shape, surface, has_function, solve_by_cholmod); });
#endif
      for(double tolerance : o.tolerances)
        table.add("cot_amg" + ending, label("%.0e", tolerance), faces, [&] {
          return cotangent_poisson(shape, surface, has_function,
                                   [&](const auto& a, const auto& b, auto& u) {
                                     return solve_by_amg(a, b, tolerance, u);
                                   });
        });
    }
    for(double tolerance : o.tolerances)
      for(int depth : depths_for(surface, o.depths))
        for(bool is_smooth : {false, true})
          for(bool has_function : {true, false})
            table.add(std::string(is_smooth ? "smooth" : "restricted") + (has_function ? "" : "_v"),
                      label("d%.0f_", depth) + label("%.0e", tolerance), faces, [&] {
                        return restricted_poisson(o, shape, surface, depth, tolerance, is_smooth,
                                                  has_function);
                      });
  }
  const std::vector<std::string> methods = {"restricted",    "restricted_v", "smooth",
                                            "smooth_v",      "cot_cholmod",  "cot_amg",
                                            "cot_cholmod_f", "cot_amg_f"};
  table.print_pareto("poisson", methods);
  table.print_pareto("poisson", methods, shape.mesh(1).number_of_faces());
}

double largest_error(const Eigen::VectorXd& values, const std::vector<double>& exact) {
  double largest = 0;
  for(std::size_t i = 0; i < exact.size(); ++i)
    largest = std::max(largest, std::abs(values[i + 1] - exact[i]) / exact[i]);
  return largest;
}

void compare_spectra(const Options& o, const Shape& shape) {
  Table table(o, shape.name);
  const std::vector<double> exact = shape.eigenvalues(o.eigenvalues);
  for(int n = o.smallest_mesh; n < o.smallest_mesh + o.meshes; ++n) {
    const RL::Triangulated_surface_3 surface = shape.mesh(n);
    const auto run_with = [&](const auto& eigenpairs) {
      Run run{};
      Stopwatch watch;
      run.converged = true;
      eigenpairs(watch, run);
      return run;
    };
    table.add("cotangent", "-", surface.number_of_faces(), [&] {
      return run_with([&](Stopwatch& watch, Run& run) {
        const RL::Operators both = RL::cotangent_operators(surface);
        run.unknowns = surface.number_of_vertices();
        run.assembly_seconds = watch.lap();
        const RL::Eigenpairs pairs =
            RL::smallest_eigenpairs(both.stiffness, both.mass, o.eigenvalues + 1);
        run.solve_seconds = watch.lap();
        run.converged = pairs.converged;
        run.error = largest_error(pairs.values, exact);
      });
    });
    for(int depth : depths_for(surface, o.spectrum_depths))
      for(bool is_smooth : {false, true})
        table.add(is_smooth ? "smooth" : "restricted", label("d%.0f", depth),
                  surface.number_of_faces(), [&] {
                    return run_with([&](Stopwatch& watch, Run& run) {
                      const RL::Spline_space_3 space(is_smooth ? RL::curved_surface(surface)
                                                               : surface,
                                                     space_options(depth, true, o.threads));
                      run.unknowns = space.dimension();
                      run.assembly_seconds = watch.lap();
                      const RL::Laplace_spectrum spectrum =
                          RL::laplace_spectrum(space, o.eigenvalues + 1);
                      run.assembly_seconds += spectrum.report.assembly_seconds;
                      run.solve_seconds = watch.lap() - spectrum.report.assembly_seconds;
                      run.converged = spectrum.report.converged;
                      run.error = largest_error(spectrum.eigenvalues, exact);
                    });
                  });
  }
  const std::vector<std::string> methods = {"restricted", "smooth", "cotangent"};
  table.print_pareto("spectrum", methods);
  table.print_pareto("spectrum", methods, shape.mesh(1).number_of_faces());
}

bool read_options(int argc, char* argv[], Options& o) {
  Command_line line("usage: accuracy_per_second [OPTION]...");
  bool is_quick = false;
  line.add("part", o.parts, "poisson spectrum");
  line.add(
      "first", o.smallest_mesh,
      "coarsest mesh; 0 has 2 thousand triangles on the sphere, 1 thousand on the torus, the next "
      "one four times as many");
  line.add("meshes", o.meshes, "number of meshes of each shape");
  line.add("depth", o.depths, "of Poisson problems; 4 5 6 7 8");
  line.add("spectrum-depth", o.spectrum_depths, "3 4 5 6");
  line.add("tolerance", o.tolerances, "1e-3");
  line.add("repetitions", o.repetitions);
  line.add("threads", o.threads, "of the package and of CHOLMOD; hypre has one");
  line.add("stabilization", o.stabilization);
  line.add("quick", is_quick, "two meshes of each shape, depths to 5, one repetition");
  if(!line.read(argc, argv))
    return false;
  if(is_quick) {
    o.meshes = 2;
    o.repetitions = 1;
    o.depths = {4, 5};
    o.spectrum_depths = {3, 4};
  }
  return true;
}

} // namespace

int main(int argc, char* argv[]) {
  return run_benchmark("accuracy_per_second", [&] {
    Options o;
    if(!read_options(argc, argv, o))
      return;
    const Hypre_session session;
    set_blas_threads(o.threads);
    [[maybe_unused]] const auto limited = limit_threads(o.threads);
    print_header(argc, argv);
    std::printf("# median of %d repetitions; %d threads; stabilization %g; hypre %s\n",
                o.repetitions, o.threads, o.stabilization, HYPRE_RELEASE_VERSION);
    for(const std::string& part : o.parts)
      for(const Shape& shape : shapes()) {
        std::printf("# %s, %s, all\n", shape.name.c_str(), part.c_str());
        std::printf("# %-5s %8s %-13s %-9s %8s %8s %8s %8s %8s %9s %3s\n", "shape", "faces",
                    "method", "param", "unknowns", "assem_s", "setup_s", "solve_s", "total_s",
                    "error", "ok");
        if(part == "poisson")
          compare_poisson(o, shape);
        else
          compare_spectra(o, shape);
      }
  });
}
