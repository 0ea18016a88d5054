// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The conformal flow by other libraries, for flow_peers.py: reads a mesh, goes some steps, writes
// the moved mesh and prints the seconds of one step.
//
// - cgal: CGAL::Polygon_mesh_processing::smooth_shape(), by default BiCGSTAB with an incomplete
//   factorization; the volume is kept. Its matrix has half of the areas of vertices and twice the
//   cotangent weights, so it gets a quarter of the time step
// - pmp: pmp::implicit_smoothing(), SimplicialLDLT; the area is kept, and boundaries stay
//
// pmp is not a package of Debian: -DPMP_INCLUDE_DIR=... and -DPMP_LIBRARY=... tell CMake where its
// headers and its library are. In single precision, as it is built by default, unless it is built
// otherwise.
//
// usage: flow_libraries cgal|pmp MESH.off TIME_STEP STEPS OUTPUT.off

#include <CGAL/Polygon_mesh_processing/smooth_shape.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#ifdef RESTRICTED_LAPLACIAN_3_BENCHMARK_PMP
#include <pmp/algorithms/smoothing.h>
#include <pmp/io/io.h>
#include <pmp/surface_mesh.h>
#endif

#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

double cgal(const std::string& input, double time_step, unsigned steps, const std::string& output) {
  Mesh mesh;
  std::ifstream in(input);
  if(!(in >> mesh))
    throw std::runtime_error("cannot read " + input);
  CGAL::Real_timer timer;
  timer.start();
  CGAL::Polygon_mesh_processing::smooth_shape(mesh, time_step / 4,
                                              CGAL::parameters::number_of_iterations(steps));
  timer.stop();
  std::ofstream out(output);
  out.precision(17);
  out << mesh;
  return timer.time() / steps;
}

#ifdef RESTRICTED_LAPLACIAN_3_BENCHMARK_PMP
double pmp_flow(const std::string& input, double time_step, unsigned steps,
                const std::string& output) {
  pmp::SurfaceMesh mesh;
  pmp::read(mesh, input);
  CGAL::Real_timer timer;
  timer.start();
  pmp::implicit_smoothing(mesh, static_cast<pmp::Scalar>(time_step), steps);
  timer.stop();
  pmp::write(mesh, output);
  return timer.time() / steps;
}
#endif

} // namespace

int main(int argc, char* argv[]) {
  if(argc != 6) {
    std::cerr << "usage: flow_libraries cgal|pmp MESH.off TIME_STEP STEPS OUTPUT.off\n";
    return EXIT_FAILURE;
  }
  try {
    const std::string library = argv[1];
    const double time_step = std::stod(argv[3]);
    const auto steps = static_cast<unsigned>(std::stoi(argv[4]));
    if(library == "cgal")
      std::cout << cgal(argv[2], time_step, steps, argv[5]) << '\n';
#ifdef RESTRICTED_LAPLACIAN_3_BENCHMARK_PMP
    else if(library == "pmp")
      std::cout << pmp_flow(argv[2], time_step, steps, argv[5]) << '\n';
#endif
    else
      throw std::runtime_error("this program was built without " + library);
  } catch(const std::exception& e) {
    std::cerr << "flow_libraries: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
