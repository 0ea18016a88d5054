// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// How exact are sums over points in place of integrals over triangles (section 4.3 of the paper)?
//
// matrices: error of stiffness and mass matrix of a mesh over the number of samples, independent
//   and stratified, and the slopes of the lines of least squares; seconds for a million samples
// eigenvalues: error of the eigenvalues of a sphere by samples, beside that by cubature of the same
//   mesh at the same depth, and the standard error that is estimated from the samples
// areas: sums and spread of the areas that are estimated for points, over the number of neighbors
// points: error of the eigenvalues l = 1 .. 5 of the unit sphere from points alone, over their
//   number and the depth
// scans: two range scans of the bunny, put together by their poses as a set of points, against the
//   part of the bunny's mesh that they cover
//
// Prints tables that gnuplot reads. Meant to be built with CHOLMOD.
//
// usage: monte_carlo_convergence [matrices|eigenvalues|areas|points|scans]...
// without an argument all of them

#include "support/measure.h"
#include "support/meshes.h"
#include "support/package.h"
#include "support/sphere.h"

#include <CGAL/Restricted_laplacian_3/foundation/internal/Disjoint_sets.h>
#include <CGAL/Restricted_laplacian_3/input/point_areas.h>
#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/integration/Monte_carlo.h>
#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/problems/monte_carlo_error.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/property_map.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace RL = CGAL::Restricted_laplacian_3;
using namespace benchmarks;

namespace {

constexpr double pi = 3.14159265358979323846;

const char* name_of(RL::Sampling sampling) {
  return sampling == RL::Sampling::stratified ? "stratified" : "independent";
}

/// oriented points, without areas
struct Points {
  std::vector<RL::Point_3> points;
  std::vector<RL::Vector_3> normals;

  std::size_t size() const { return points.size(); }
  void add(const RL::Point_3& p, const RL::Vector_3& n) {
    points.push_back(p);
    normals.push_back(n);
  }
  RL::Triangulated_surface_3 surface() const {
    return {points, normals, RL::estimate_point_areas(points, normals)};
  }
};

RL::Spline_space_3 space_of(const RL::Triangulated_surface_3& surface, int depth, bool is_split) {
  RL::Spline_space_options options;
  options.depth = depth;
  options.split = options.split_point_set = is_split;
  return RL::Spline_space_3(surface, options);
}

// matrices

double slope(const std::vector<double>& x, const std::vector<double>& y) {
  const double n = static_cast<double>(x.size());
  double sum_x = 0, sum_y = 0, xx = 0, xy = 0;
  for(std::size_t i = 0; i < x.size(); ++i) {
    sum_x += std::log(x[i]);
    sum_y += std::log(y[i]);
    xx += std::log(x[i]) * std::log(x[i]);
    xy += std::log(x[i]) * std::log(y[i]);
  }
  return (n * xy - sum_x * sum_y) / (n * xx - sum_x * sum_x);
}

void run_matrices(const char* name, const RL::Triangulated_surface_3& surface, int depth) {
  const RL::Spline_space_3 space = space_of(surface, depth, true);
  const RL::Operators exact = RL::assemble_operators(space);
  std::printf("# %s, %zu triangles, depth %d, %zu unknowns, %zu cells: relative errors in the "
              "Frobenius norm, root mean square over 8 seeds\n",
              name, surface.number_of_faces(), depth, space.dimension(),
              space.number_of_cells(depth));
  std::printf("# %-10s %9s %11s %11s %9s\n", "sampling", "samples", "stiffness", "mass", "seconds");
  for(RL::Sampling sampling : {RL::Sampling::independent, RL::Sampling::stratified}) {
    std::vector<double> numbers, stiffness_errors, mass_errors;
    for(std::size_t number = 1000; number <= 1024000; number *= 4) {
      constexpr int seeds = 8;
      double stiffness = 0, mass = 0, seconds = 0;
      for(int seed = 0; seed < seeds; ++seed) {
        CGAL::Real_timer timer;
        timer.start();
        const RL::Operators operators = RL::assemble_operators(
            space.integrated_by(RL::Monte_carlo(space.octree(), number, seed + number, sampling)));
        seconds += timer.time() / seeds;
        stiffness += (operators.stiffness.coeffs() - exact.stiffness.coeffs()).square().sum() /
                     exact.stiffness.coeffs().square().sum() / seeds;
        mass += (operators.mass.coeffs() - exact.mass.coeffs()).square().sum() /
                exact.mass.coeffs().square().sum() / seeds;
      }
      numbers.push_back(static_cast<double>(number));
      stiffness_errors.push_back(std::sqrt(stiffness));
      mass_errors.push_back(std::sqrt(mass));
      std::printf("%-12s %9zu %11.3e %11.3e %9.3f\n", name_of(sampling), number,
                  stiffness_errors.back(), mass_errors.back(), seconds);
      std::fflush(stdout);
    }
    std::printf("# slopes: stiffness %.3f, mass %.3f\n", slope(numbers, stiffness_errors),
                slope(numbers, mass_errors));
  }
  std::printf("\n\n");
}

// eigenvalues by samples

/// largest relative difference to `expected` of those above 0
double largest_difference(const Eigen::VectorXd& values, const Eigen::VectorXd& expected) {
  double largest = 0;
  for(Eigen::Index i = 1; i < (std::min)(values.size(), expected.size()); ++i)
    largest = (std::max)(largest, std::abs(values[i] / expected[i] - 1));
  return largest;
}

constexpr int sphere_count = 36; // l = 0 .. 5

Eigen::VectorXd sphere_eigenvalues() {
  Eigen::VectorXd values(sphere_count);
  Eigen::Index i = 0;
  for(int l = 0; l <= 5; ++l)
    for(int m = 0; m < 2 * l + 1; ++m)
      values[i++] = l * (l + 1);
  return values;
}

void run_eigenvalues() {
  const int depth = 4;
  const RL::Spline_space_3 space = space_of(sphere(6), depth, true);
  const double stabilization = RL::default_spectrum_stabilization(space);
  const Eigen::VectorXd exact = RL::laplace_eigenpairs(space, sphere_count).eigenvalues;
  std::printf("# sphere, depth %d, %zu unknowns, %zu cells; by cubature the largest relative error "
              "of l = 1 .. 5 is %.2e\n",
              depth, space.dimension(), space.number_of_cells(depth),
              largest_difference(exact, sphere_eigenvalues()));
  std::printf("# largest: relative error; mean: of the mean over each l, largest; estimated: "
              "largest relative standard error, from 10 batches\n");
  std::printf("# %-10s %9s %9s %11s %11s %11s\n", "sampling", "samples", "per_cell", "largest",
              "mean", "estimated");
  for(RL::Sampling sampling : {RL::Sampling::independent, RL::Sampling::stratified})
    for(std::size_t number = 10000; number <= 1000000; number *= 10) {
      RL::Monte_carlo_options options;
      options.samples = number;
      options.sampling = sampling;
      options.seed = 1;
      const RL::Estimated_eigenvalues found =
          RL::estimate_eigenvalues(space, sphere_count, options, stabilization);
      double mean_error = 0;
      for(int l = 1, i = 1; l <= 5; i += 2 * l + 1, ++l)
        mean_error = (std::max)(
            mean_error, std::abs(found.values.segment(i, 2 * l + 1).mean() / (l * (l + 1)) - 1));
      const Eigen::ArrayXd bars = found.standard_errors.array() / exact.array();
      std::printf("%-12s %9zu %9.1f %11.2e %11.2e %11.2e\n", name_of(sampling), number,
                  static_cast<double>(number) / space.number_of_cells(depth),
                  largest_difference(found.values, sphere_eigenvalues()), mean_error,
                  bars.tail(sphere_count - 1).maxCoeff());
      std::fflush(stdout);
    }
  std::printf("\n\n");
}

// points from formulas

Points sphere_points(std::size_t n, bool is_random) {
  Points result;
  std::mt19937_64 generator(n);
  const auto uniform = [&generator] { return std::ldexp(generator() >> 11, -53); };
  for(std::size_t i = 0; i < n; ++i) {
    const double z = 2 * (is_random ? uniform() : (i + 0.5) / n) - 1, r = std::sqrt(1 - z * z),
                 angle = is_random ? 2 * pi * uniform() : pi * (3 - std::sqrt(5.)) * i;
    const RL::Vector_3 v(r * std::cos(angle), r * std::sin(angle), z);
    result.add(CGAL::ORIGIN + v, v);
  }
  return result;
}

/// R = 1, r = 0.4
Points torus_points(std::size_t n, bool is_random) {
  Points result;
  std::mt19937_64 generator(n);
  const auto uniform = [&generator] { return std::ldexp(generator() >> 11, -53); };
  for(std::size_t i = 0; i < n; ++i) {
    const double target = 2 * pi * (is_random ? uniform() : (i + 0.5) / n);
    double v = target;
    for(int k = 0; k < 50; ++k)
      v -= (v + 0.4 * std::sin(v) - target) / (1 + 0.4 * std::cos(v));
    const double u = is_random ? 2 * pi * uniform() : pi * (3 - std::sqrt(5.)) * i;
    const RL::Vector_3 out(std::cos(u), std::sin(u), 0),
        normal = std::cos(v) * out + RL::Vector_3(0, 0, std::sin(v));
    result.add(CGAL::ORIGIN + out + 0.4 * normal, normal);
  }
  return result;
}

void run_areas() {
  constexpr std::size_t n = 100000;
  std::printf("# %zu points; sum: relative error of the sum of all areas; spread: standard "
              "deviation over mean\n",
              n);
  std::printf("# %-6s %-7s %9s %11s %11s %9s\n", "shape", "points", "neighbors", "sum", "spread",
              "seconds");
  for(const std::string shape : {"sphere", "torus"})
    for(bool is_random : {false, true}) {
      const Points p = shape == "sphere" ? sphere_points(n, is_random) : torus_points(n, is_random);
      const double exact = shape == "sphere" ? 4 * pi : 4 * pi * pi * 0.4;
      for(int neighbors : {8, 12, 16, 24}) {
        CGAL::Real_timer timer;
        timer.start();
        const std::vector<double> areas = RL::estimate_point_areas(p.points, p.normals, neighbors);
        const double seconds = timer.time();
        const auto a = Eigen::Map<const Eigen::ArrayXd>(areas.data(), n);
        std::printf("%-8s %-7s %9d %11.2e %11.3f %9.2f\n", shape.c_str(),
                    is_random ? "random" : "regular", neighbors, a.sum() / exact - 1,
                    std::sqrt((a / a.mean() - 1).square().mean()), seconds);
      }
    }
  std::printf("\n\n");
}

void run_points() {
  std::printf("# unit sphere; error: largest relative error of the eigenvalues l = 1 .. 5\n");
  std::printf("# %-8s %9s %6s %9s %9s %11s\n", "points", "number", "depth", "unknowns", "per_cell",
              "error");
  for(bool is_random : {false, true})
    for(std::size_t n = 1000; n <= 1000000; n *= 10) {
      const RL::Triangulated_surface_3 surface = sphere_points(n, is_random).surface();
      for(int depth = 2; depth <= 6; ++depth) {
        const RL::Spline_space_3 space = space_of(surface, depth, false);
        const double per_cell = static_cast<double>(n) / space.number_of_cells(depth);
        if(per_cell < 2)
          break;
        const Eigen::VectorXd found = RL::laplace_eigenpairs(space, sphere_count).eigenvalues;
        std::printf("%-10s %9zu %6d %9zu %9.1f %11.2e\n", is_random ? "random" : "regular", n,
                    depth, space.dimension(), per_cell,
                    largest_difference(found, sphere_eigenvalues()));
        std::fflush(stdout);
      }
    }
  std::printf("\n\n");
}

// scans

struct Soup {
  std::vector<RL::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
};

Soup read_soup(const std::string& name) {
  Soup soup;
  const std::string path = shared_file(name);
  if(!std::ifstream(path) || !CGAL::IO::read_polygon_soup(path, soup.points, soup.faces))
    std::fprintf(stderr, "SKIPPED: cannot read %s\n", path.c_str());
  return soup;
}

RL::Triangulated_surface_3 surface_of(const Soup& soup) {
  return RL::read_surface(RL::soup(soup.points, soup.faces));
}

/// The vertices of each of the scans that a file of poses lists, with normals from the faces around
/// them: faces serve for nothing else.
std::vector<Points> scan_points(const std::string& poses) {
  std::vector<Points> result;
  std::ifstream in(shared_file(poses));
  for(std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string file;
    std::array<double, 16> m;
    if(line.empty() || line[0] == '#' || !(words >> file))
      continue;
    for(double& entry : m)
      words >> entry;
    Soup soup = read_soup(file);
    if(soup.faces.empty())
      continue;
    for(RL::Point_3& p : soup.points)
      p = RL::Point_3(m[0] * p.x() + m[1] * p.y() + m[2] * p.z() + m[3],
                      m[4] * p.x() + m[5] * p.y() + m[6] * p.z() + m[7],
                      m[8] * p.x() + m[9] * p.y() + m[10] * p.z() + m[11]);
    const RL::Triangulated_surface_3 surface = surface_of(soup);
    std::vector<RL::Vector_3> normals(soup.points.size(), RL::Vector_3(0, 0, 0));
    for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
      for(std::uint32_t v : surface.triangle(f))
        normals[v] += surface.area(f) * surface.normal(f);
    result.emplace_back();
    for(std::size_t v = 0; v < normals.size(); ++v)
      if(normals[v] != CGAL::NULL_VECTOR)
        result.back().add(soup.points[v], normals[v]);
  }
  return result;
}

/// whether points are within a distance of some points
std::vector<char> are_near(const std::vector<RL::Point_3>& points,
                           const std::vector<RL::Point_3>& others, double distance) {
  using Traits = CGAL::Search_traits_3<CGAL::Simple_cartesian<double>>;
  using Search = CGAL::Orthogonal_k_neighbor_search<Traits>;
  const Search::Tree tree(others.begin(), others.end());
  std::vector<char> result;
  for(const RL::Point_3& p : points)
    result.push_back(Search(tree, p, 1).begin()->second <= distance * distance);
  return result;
}

/// The largest component, along edges, of the faces all of whose corners are marked.
Soup largest_marked_part(const Soup& soup, const std::vector<char>& is_marked) {
  RL::internal::Disjoint_sets sets(soup.faces.size());
  std::map<std::pair<std::size_t, std::size_t>, std::uint32_t> face_of_edge;
  std::vector<std::uint32_t> faces;
  for(std::uint32_t f = 0; f < soup.faces.size(); ++f) {
    const auto& v = soup.faces[f];
    if(!std::all_of(v.begin(), v.end(), [&](std::size_t i) { return is_marked[i]; }))
      continue;
    faces.push_back(f);
    for(std::size_t k = 0; k < v.size(); ++k)
      sets.unite(f,
                 face_of_edge.insert({std::minmax(v[k], v[(k + 1) % v.size()]), f}).first->second);
  }
  std::vector<std::size_t> sizes(soup.faces.size(), 0);
  for(std::uint32_t f : faces)
    ++sizes[sets.find(f)];
  const auto largest = std::max_element(sizes.begin(), sizes.end()) - sizes.begin();
  Soup part;
  part.points = soup.points;
  for(std::uint32_t f : faces)
    if(sets.find(f) == largest)
      part.faces.push_back(soup.faces[f]);
  return part;
}

std::vector<RL::Point_3> used_points(const Soup& soup) {
  std::vector<char> is_used(soup.points.size(), 0);
  for(const auto& f : soup.faces)
    for(std::size_t v : f)
      is_used[v] = 1;
  std::vector<RL::Point_3> points;
  for(std::size_t v = 0; v < is_used.size(); ++v)
    if(is_used[v])
      points.push_back(soup.points[v]);
  return points;
}

/// \f$\Delta u = y\f$ on a surface
RL::Spline_function_3 poisson_solution(const RL::Spline_space_3& space) {
  const auto y = [](const RL::Surface_point& p) { return p.point.y(); };
  Eigen::VectorXd coefficients;
  static_cast<void>(RL::Poisson_solver(space).solve(Eigen::VectorXd(-RL::assemble_load(space, y)),
                                                    coefficients, 1e-6));
  return RL::Spline_function_3(space, std::move(coefficients));
}

/// How far the solution on points differs from that on a mesh, at the nearest vertices: root mean
/// square, relative to that of the latter.
double poisson_difference(const RL::Spline_space_3& of_points, const RL::Spline_space_3& of_mesh) {
  using Map = CGAL::Pointer_property_map<RL::Point_3>::const_type;
  using Traits = CGAL::Search_traits_adapter<std::size_t, Map,
                                             CGAL::Search_traits_3<CGAL::Simple_cartesian<double>>>;
  using Search = CGAL::Orthogonal_k_neighbor_search<Traits>;
  const std::vector<double> u = poisson_solution(of_points).values_at_vertices(),
                            v = poisson_solution(of_mesh).values_at_vertices();
  std::vector<RL::Point_3> vertices;
  std::vector<std::size_t> numbers;
  for(std::size_t i = 0; i < v.size(); ++i) {
    vertices.push_back(of_mesh.surface().point(i));
    if(std::isfinite(v[i]))
      numbers.push_back(i);
  }
  const Map map = CGAL::make_property_map(std::as_const(vertices));
  const Search::Tree tree(numbers.begin(), numbers.end(), Search::Tree::Splitter(), Traits(map));
  double difference = 0, squares = 0;
  for(std::size_t i = 0; i < u.size(); ++i) {
    const RL::Triangulated_surface_3& surface = of_points.surface();
    const Search search(tree, surface.point(i), 1, 0, true, Search::Distance(map));
    const double expected = v[search.begin()->first];
    difference += surface.area(i) * (u[i] - expected) * (u[i] - expected);
    squares += surface.area(i) * expected * expected;
  }
  return std::sqrt(difference / squares);
}

void run_scans() {
  const std::vector<Points> scans = scan_points("bunscan.conf");
  const Soup bunny = read_soup("bunny_zipper_69k.ply");
  if(scans.size() < 2 || bunny.faces.empty())
    return;
  constexpr double distance = 0.0015;
  constexpr int count = 11;
  Points joined;
  double sum_of_areas = 0;
  for(const Points& scan : scans) {
    sum_of_areas += scan.surface().area();
    for(std::size_t i = 0; i < scan.size(); ++i)
      joined.add(scan.points[i], scan.normals[i]);
  }
  const RL::Triangulated_surface_3 whole = surface_of(bunny);
  std::printf("# range scans of the bunny, %zu points: area %.5f, estimated from all points; the "
              "areas of single scans sum to %.5f\n",
              joined.size(), joined.surface().area(), sum_of_areas);
  const Soup soup = largest_marked_part(bunny, are_near(bunny.points, joined.points, distance));
  const RL::Triangulated_surface_3 part = surface_of(soup);
  const std::vector<char> is_kept = are_near(joined.points, used_points(soup), distance);
  Points kept;
  for(std::size_t i = 0; i < joined.size(); ++i)
    if(is_kept[i])
      kept.add(joined.points[i], joined.normals[i]);
  const RL::Triangulated_surface_3 points = kept.surface();
  std::printf("# mesh of the bunny: area %.5f; part: the largest component of its faces within "
              "%.4f of the points: %.5f\n# points within that distance of the part: %zu, area "
              "%.5f\n",
              whole.area(), distance, part.area(), kept.size(), points.area());
  std::printf("# per_cell: points; poisson: difference of the solution of Laplacian u = y from "
              "that on the part, relative; then the first %d eigenvalues above 0\n",
              count - 1);
  std::printf("# %-6s %-7s %5s %8s %10s %8s %8s\n", "surface", "space", "depth", "unknowns",
              "components", "per_cell", "poisson");
  const auto run = [&](const std::string& name, const RL::Triangulated_surface_3& surface,
                       int depth, bool is_split) {
    const RL::Spline_space_3 space = space_of(surface, depth, is_split);
    const bool has_points = surface.is_point_set();
    std::printf("%-8s %-7s %5d %8zu %10zu ", name.c_str(), is_split ? "split" : "unsplit", depth,
                space.dimension(), space.number_of_sheets(0));
    if(has_points)
      std::printf("%8.1f %8.4f ",
                  static_cast<double>(surface.number_of_faces()) / space.number_of_cells(depth),
                  poisson_difference(space, space_of(part, 6, true)));
    else
      std::printf("%8s %8s ", "-", "-");
    const Eigen::VectorXd values = RL::laplace_eigenpairs(space, count).eigenvalues;
    for(Eigen::Index i = 1; i < values.size(); ++i)
      std::printf(" %.1f", values[i]);
    std::printf("\n");
    std::fflush(stdout);
  };
  for(bool is_split : {false, true})
    for(int depth = 3; depth <= 6; ++depth) {
      run("points", points, depth, is_split);
      run("part", part, depth, is_split);
    }
  run("whole", whole, 6, true);
  std::printf("\n\n");
}

} // namespace

int main(int argc, char* argv[]) {
  std::vector<std::string> parts(argv + 1, argv + argc);
  if(parts.empty())
    parts = {"matrices", "eigenvalues", "areas", "points", "scans"};
  print_header(argc, argv);
  for(const std::string& part : parts) {
    if(part == "matrices") {
      run_matrices("sphere", sphere(5), 3);
      if(const auto bunny = find_mesh("bunny_closed_70k"))
        run_matrices("bunny", *bunny, 5);
    } else if(part == "eigenvalues")
      run_eigenvalues();
    else if(part == "areas")
      run_areas();
    else if(part == "points")
      run_points();
    else if(part == "scans")
      run_scans();
    else {
      std::fprintf(stderr, "there is no part %s\n", part.c_str());
      return 1;
    }
  }
  return 0;
}
