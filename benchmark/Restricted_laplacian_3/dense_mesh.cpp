// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What does a mesh with far more triangles than the space has unknowns cost? From the mesh in
// memory
// - to stiffness and mass matrices of all levels (operators),
// - to the solution of a Poisson problem at its vertices, f = x (poisson), to a tolerance,
// and, in the same run, to the solution by the cotangent Laplacian and CHOLMOD with AMD ordering, a
// vertex held at 0. Each is the median of three runs. One thread, and two for the package with TBB
// and for the BLAS of CHOLMOD.
//
// usage: dense_mesh [MESH [DEPTH OF OPERATORS [DEPTH OF POISSON [TOLERANCE]]]]
// default: armadillo_mc1m of the shared meshes, 7, 6, 1e-8

#include "support/measure.h"
#include "support/package.h"

#include <CGAL/Restricted_laplacian_3/assembly/cotangent_operators.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>

#ifdef CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace benchmarks;
namespace params = RL::parameters;
using Mesh = CGAL::Surface_mesh<RL::Point_3>;
using Vertex_map = Mesh::Property_map<Mesh::Vertex_index, double>;

template <class Work> double median_seconds(Work&& work) {
  std::vector<double> seconds;
  for(int repetition = 0; repetition < 3; ++repetition) {
    CGAL::Real_timer timer;
    timer.start();
    work();
    seconds.push_back(timer.time());
  }
  return median(seconds);
}

void print(const char* name, int depth, int threads, std::size_t unknowns, double seconds,
           const std::string& remark = "") {
  std::printf("%-20s %5d %7d %9zu %9.3f  %s\n", name, depth, threads, unknowns, seconds,
              remark.c_str());
  std::fflush(stdout);
}

void measure_operators(const Mesh& mesh, int depth, int threads) {
  [[maybe_unused]] const auto limited = limit_threads(threads);
  std::size_t unknowns = 0;
  const double seconds = median_seconds([&] {
    const RL::Spline_space_3 space(RL::read_surface(mesh), space_options(depth, true, threads));
    RL::assemble_operators(space, 0, depth, RL::Triangle_cubature(space), default_stabilization());
    unknowns = space.dimension();
  });
  print("operators_all_levels", depth, threads, unknowns, seconds);
}

void measure_poisson(const Mesh& mesh, const Vertex_map& f, Vertex_map u, int depth,
                     double tolerance, int threads) {
  [[maybe_unused]] const auto limited = limit_threads(threads);
  RL::Solve_report report;
  const auto np = params::octree_depth(depth).relative_tolerance(tolerance);
  const double seconds = median_seconds([&] {
    report = threads > 1 ? RL::solve_poisson(mesh, f, u,
                                             np.concurrency_tag(CGAL::Parallel_if_available_tag()))
                         : RL::solve_poisson(mesh, f, u, np);
  });
  char remark[128];
  std::snprintf(remark, sizeof remark,
                "%d iterations, residual %.1e; space %.3f, assembly %.3f, setup %.3f, solve %.3f",
                report.iterations, report.relative_residual, report.space_seconds,
                report.assembly_seconds, report.setup_seconds, report.solve_seconds);
  const RL::Spline_space_3 space(RL::read_surface(mesh), space_options(depth, true, threads));
  print("poisson", depth, threads, space.dimension(), seconds, remark);
}

#ifdef CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD
void measure_cotangent(const Mesh& mesh, const Vertex_map& f, int threads) {
  set_blas_threads(threads);
  std::size_t unknowns = 0;
  double assembly_seconds = 0;
  const double seconds = median_seconds([&] {
    CGAL::Real_timer timer;
    timer.start();
    const RL::Triangulated_surface_3 surface = RL::read_surface(mesh);
    const RL::Operators both = RL::cotangent_operators(surface);
    unknowns = surface.number_of_vertices();
    Eigen::VectorXd values(static_cast<Eigen::Index>(unknowns));
    Eigen::Index i = 0;
    for(const Mesh::Vertex_index v : mesh.vertices())
      values[i++] = f[v];
    Eigen::VectorXd b = -(both.mass * values);
    b.array() -= b.mean();
    RL::Sparse_matrix a = both.stiffness;
    a.coeffRef(0, 0) *= 2;
    assembly_seconds = timer.time();
    Eigen::CholmodSupernodalLLT<RL::Sparse_matrix> cholesky;
    cholesky.cholmod().nmethods = 1;
    cholesky.cholmod().method[0].ordering = CHOLMOD_AMD;
    cholesky.compute(a);
    const Eigen::VectorXd u = cholesky.solve(b);
    if(cholesky.info() != Eigen::Success)
      throw std::runtime_error("CHOLMOD failed");
  });
  char remark[64];
  std::snprintf(remark, sizeof remark, "of which matrices %.3f", assembly_seconds);
  print("cotangent_cholmod", 0, threads, unknowns, seconds, remark);
}
#endif

void compare(int argc, char* argv[]) {
  const std::string name = argc > 1 ? argv[1] : "armadillo_mc1m";
  const int depth_of_operators = argc > 2 ? std::stoi(argv[2]) : 7,
            depth_of_poisson = argc > 3 ? std::stoi(argv[3]) : 6;
  const double tolerance = argc > 4 ? std::stod(argv[4]) : 1e-8;
  auto mesh = find_mesh_file(name);
  if(!mesh)
    return;
  Vertex_map f = mesh->add_property_map<Mesh::Vertex_index, double>("v:f").first,
             u = mesh->add_property_map<Mesh::Vertex_index, double>("v:u").first;
  for(const Mesh::Vertex_index v : mesh->vertices())
    f[v] = mesh->point(v).x();
  print_header(argc, argv);
  std::printf("# %s, %zu triangles; tolerance %g\n", name.c_str(),
              static_cast<std::size_t>(mesh->number_of_faces()), tolerance);
  std::printf("# %-18s %5s %7s %9s %9s\n", "what", "depth", "threads", "unknowns", "seconds");
  for(int threads = 1; threads <= (is_parallel_available() ? 2 : 1); ++threads) {
    measure_operators(*mesh, depth_of_operators, threads);
    measure_poisson(*mesh, f, u, depth_of_poisson, tolerance, threads);
#ifdef CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD
    measure_cotangent(*mesh, f, threads);
#endif
  }
}

} // namespace

int main(int argc, char* argv[]) {
  try {
    compare(argc, argv);
  } catch(const std::exception& e) {
    std::fprintf(stderr, "dense_mesh: %s\n", e.what());
    return 1;
  }
}
