// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The same problems by libigl, with linear elements on the triangles, and by this package: a
// Poisson problem, f = z, and the smallest eigenvalues, from a mesh in memory to values at its
// vertices.
//
// - min_quad_with_fixed: matrices of libigl, vertex 0 held at 0
// - spectra_eigs: matrices of libigl, lumped mass; igl::spectra::eigs() with SimplicialLDLT in
//   place of its default SparseLU, and a shift of 0.01 / area
// - solve_poisson, laplace_spectrum: this package at several depths, defaults otherwise
//
// Errors are those against the same surface with smaller triangles: linear elements, full mass, on
// the mesh refined once and twice, extrapolated for a convergence of order two. Poisson: root mean
// square over the vertices, weighted by area, relative to that of the solution. Spectrum: largest
// and mean relative error of the eigenvalues above 0. Seconds are processor time of one thread, the
// median of three runs.
//
// libigl is not a package of Debian 12: -DLIBIGL_INCLUDE_DIR=... tells CMake in which folder its
// folder igl is.
//
// usage: library_comparison [MESH [NUMBER OF EIGENVALUES]]
// default: bunny_closed_70k of the shared meshes, 50

#include "support/driver.h"
#include "support/measure.h"
#include "support/package.h"

#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>
#include <CGAL/Restricted_laplacian_3/spectra/smallest_eigenpairs.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/Timer.h>
#include <CGAL/boost/graph/iterator.h>

#include <Eigen/SparseCholesky>

#include <igl/cotmatrix.h>
#include <igl/massmatrix.h>
#include <igl/min_quad_with_fixed.h>
#include <igl/spectra/eigs.h>
#include <igl/upsample.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace {

using namespace benchmarks;
namespace params = RL::parameters;
using Mesh = CGAL::Surface_mesh<RL::Point_3>;
using Matrix = Eigen::SparseMatrix<double>;

struct Arrays {
  Eigen::MatrixXd points;
  Eigen::MatrixXi triangles;
};

Arrays arrays(const Mesh& mesh) {
  Arrays a{Eigen::MatrixXd(mesh.number_of_vertices(), 3),
           Eigen::MatrixXi(mesh.number_of_faces(), 3)};
  for(const Mesh::Vertex_index v : mesh.vertices())
    for(int c = 0; c < 3; ++c)
      a.points(v.idx(), c) = mesh.point(v)[c];
  for(const Mesh::Face_index f : mesh.faces()) {
    int corner = 0;
    for(const Mesh::Vertex_index v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      a.triangles(f.idx(), corner++) = static_cast<int>(v.idx());
  }
  return a;
}

struct Matrices {
  Matrix laplacian, mass;
  double area;
};

Matrices matrices(const Arrays& mesh, igl::MassMatrixType type) {
  Matrices m;
  igl::cotmatrix(mesh.points, mesh.triangles, m.laplacian);
  igl::massmatrix(mesh.points, mesh.triangles, type, m.mass);
  m.area = m.mass.sum();
  return m;
}

/// Laplacian u = z, u = 0 at vertex 0
Eigen::VectorXd solve_by_libigl(const Arrays& mesh, igl::MassMatrixType type) {
  const Matrices m = matrices(mesh, type);
  Eigen::VectorXd f = mesh.points.col(2);
  f.array() -= (m.mass * f).sum() / m.area;
  const Eigen::VectorXi vertex = Eigen::VectorXi::Zero(1);
  const Eigen::VectorXd value = Eigen::VectorXd::Zero(1), b = m.mass * f;
  igl::min_quad_with_fixed_data<double> data;
  igl::min_quad_with_fixed_precompute(Matrix(-m.laplacian), vertex, Matrix(), true, data);
  Eigen::VectorXd u;
  igl::min_quad_with_fixed_solve(data, b, value, Eigen::VectorXd(), u);
  return u;
}

Eigen::VectorXd eigenvalues_by_libigl(const Arrays& mesh, int k) {
  const Matrices m = matrices(mesh, igl::MASSMATRIX_TYPE_DEFAULT);
  Eigen::MatrixXd vectors;
  Eigen::VectorXd values;
  igl::spectra::eigs<double, Eigen::MatrixXd, Eigen::VectorXd, Eigen::SimplicialLDLT<Matrix>>(
      Matrix(-m.laplacian), m.mass, k, 0.01 / m.area, vectors, values);
  std::sort(values.data(), values.data() + values.size());
  return values;
}

/// what the errors are measured against
struct Reference {
  Eigen::VectorXd areas, solution, eigenvalues;

  Reference(const Arrays& mesh, int k) {
    areas = matrices(mesh, igl::MASSMATRIX_TYPE_BARYCENTRIC).mass.diagonal();
    std::array<Eigen::VectorXd, 2> u, lambda;
    Arrays fine = mesh;
    for(int level = 0; level < 2; ++level) {
      // the given vertices remain the first ones
      const Arrays coarse = fine;
      igl::upsample(coarse.points, coarse.triangles, fine.points, fine.triangles);
      u[level] = centered(solve_by_libigl(fine, igl::MASSMATRIX_TYPE_FULL).head(areas.size()));
      const Matrices m = matrices(fine, igl::MASSMATRIX_TYPE_FULL);
      lambda[level] = RL::smallest_eigenpairs(-m.laplacian, m.mass, k).values;
    }
    solution = (4 * u[1] - u[0]) / 3;
    eigenvalues = (4 * lambda[1] - lambda[0]) / 3;
  }

  Eigen::VectorXd centered(const Eigen::VectorXd& u) const {
    return u.array() - areas.dot(u) / areas.sum();
  }
  double norm(const Eigen::VectorXd& u) const { return std::sqrt(areas.dot(u.cwiseAbs2())); }
  double error_of_solution(const Eigen::VectorXd& u) const {
    return norm(centered(u) - solution) / norm(solution);
  }
  Eigen::ArrayXd errors_of_eigenvalues(const Eigen::VectorXd& values) const {
    const Eigen::Index n = eigenvalues.size() - 1;
    return (values.tail(n).array() / eigenvalues.tail(n).array() - 1).abs();
  }
};

/// the median time of three runs
template <class Work> double seconds_of(Work&& work) {
  std::vector<double> seconds;
  for(int repetition = 0; repetition < 3; ++repetition) {
    CGAL::Timer timer;
    timer.start();
    work();
    seconds.push_back(timer.time());
  }
  return median(seconds);
}

void print_row(const char* method, int depth, double seconds, const std::vector<double>& errors) {
  std::printf("%-20s %5d %9.3f", method, depth, seconds);
  for(const double error : errors)
    std::printf(" %9.1e", error);
  std::printf("\n");
  std::fflush(stdout);
}

void compare(int argc, char* argv[]) {
  const std::string name = argc > 1 ? argv[1] : "bunny_closed_70k";
  const int k = argc > 2 ? std::stoi(argv[2]) : 50;
  auto mesh = find_mesh_file(name);
  if(!mesh)
    return;
  set_blas_threads(1);
  [[maybe_unused]] const auto limited = limit_threads(1);
  const Arrays input = arrays(*mesh);
  print_header(argc, argv);
  std::printf("# %s, %d vertices, %d eigenvalues\n", name.c_str(),
              static_cast<int>(input.points.rows()), k);
  const Reference reference(input, k);

  std::printf("# %-18s %5s %9s %9s\n", "Poisson", "depth", "seconds", "error");
  Eigen::VectorXd solution;
  double seconds =
      seconds_of([&] { solution = solve_by_libigl(input, igl::MASSMATRIX_TYPE_DEFAULT); });
  print_row("min_quad_with_fixed", 0, seconds, {reference.error_of_solution(solution)});
  const auto u = mesh->add_property_map<Mesh::Vertex_index, double>("v:u").first;
  const auto f = [](const RL::Surface_point& s) { return s.point.z(); };
  for(const int depth : {4, 5, 6, 7}) {
    seconds = seconds_of(
        [&] { static_cast<void>(RL::solve_poisson(*mesh, f, u, params::depth(depth))); });
    for(const Mesh::Vertex_index v : mesh->vertices())
      solution[v.idx()] = u[v];
    print_row("solve_poisson", depth, seconds, {reference.error_of_solution(solution)});
  }

  std::printf("# %-18s %5s %9s %9s %9s\n", "spectrum", "depth", "seconds", "largest", "mean error");
  const auto print_spectrum = [&](const char* method, int depth, const Eigen::VectorXd& values) {
    const Eigen::ArrayXd errors = reference.errors_of_eigenvalues(values);
    print_row(method, depth, seconds, {errors.maxCoeff(), errors.mean()});
  };
  Eigen::VectorXd values;
  seconds = seconds_of([&] { values = eigenvalues_by_libigl(input, k); });
  print_spectrum("spectra_eigs", 0, values);
  for(const int depth : {3, 4, 5, 6}) {
    seconds = seconds_of(
        [&] { values = RL::laplace_spectrum(*mesh, k, params::depth(depth)).eigenvalues; });
    print_spectrum("laplace_spectrum", depth, values);
  }
}

} // namespace

int main(int argc, char* argv[]) {
  return run_benchmark("library_comparison", [&] { compare(argc, argv); });
}
