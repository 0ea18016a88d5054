// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Solutions and spectra are those of the surface, not of its triangulation. The tests of spectra of
// other meshes are a small version of the benchmark spectrum_study: the paper's figure 3.

#include "catch.h"
#include "shapes.h"

#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;

/// of `count` eigenvalues of the unit sphere the largest relative error of those of degree up to
/// 13, and how many are nearest to each l (l + 1)
struct Sphere_spectrum {
  static constexpr int largest_degree = 13, count = 200;

  explicit Sphere_spectrum(const Eigen::VectorXd& eigenvalues)
    : multiplicity(largest_degree + 2, 0) {
    REQUIRE(eigenvalues.size() == count);
    for(int i = 0; i < count; ++i) {
      // l^2 <= i < (l + 1)^2 for a number, and l (l + 1) is in the middle of the same interval
      const int l = static_cast<int>(std::sqrt(i)),
                found = static_cast<int>(std::sqrt((std::max)(0., eigenvalues[i])));
      if(found < static_cast<int>(multiplicity.size()))
        ++multiplicity[found];
      if(l > 0 && l <= largest_degree)
        error = (std::max)(error, std::abs(eigenvalues[i] / (l * (l + 1)) - 1));
    }
  }

  double error = 0;
  std::vector<int> multiplicity;
};

/// mean relative difference of the eigenvalues above 0
double mean_change(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  const Eigen::Index n = b.size() - 1;
  return ((a - b).tail(n).array() / b.tail(n).array()).abs().mean();
}

/// the same surface with a vertex in each face, near to an edge
shapes::Triangles with_slivers(const shapes::Triangles& t) {
  shapes::Triangles result;
  result.points = t.points;
  for(const auto& f : t.faces) {
    const auto center = static_cast<std::uint32_t>(result.points.size());
    result.points.push_back(
        CGAL::barycenter(t.points[f[0]], 0.7, t.points[f[1]], 0.2999, t.points[f[2]], 0.0001));
    for(int side = 0; side < 3; ++side)
      result.faces.push_back({f[side], f[(side + 1) % 3], center});
  }
  return result;
}

/// The same triangles in another order, each of which begins at another corner. Vertex `i` becomes
/// vertex `numbers[i]`.
shapes::Triangles shuffled(const shapes::Triangles& t, const std::vector<std::uint32_t>& numbers,
                           std::mt19937& generator) {
  shapes::Triangles result = t;
  for(std::size_t i = 0; i < numbers.size(); ++i)
    result.points[numbers[i]] = t.points[i];
  std::shuffle(result.faces.begin(), result.faces.end(), generator);
  for(auto& f : result.faces) {
    for(std::uint32_t& v : f)
      v = numbers[v];
    std::rotate(f.begin(), f.begin() + generator() % 3, f.end());
  }
  return result;
}

/// what is compared between triangulations of a surface
struct Results {
  /// \param numbers of the vertices at which solutions are compared
  Results(const shapes::Triangles& t, const std::vector<std::uint32_t>& numbers) {
    shapes::Mesh mesh = shapes::mesh(t);
    const auto u = mesh.add_property_map<shapes::Mesh::Vertex_index, double>("v:u").first;
    const auto np = params::depth(4).tolerance(1e-12);
    const auto f = [](const RL::Surface_point& p) {
      return 1 + p.point.x() * p.point.y() - p.point.z();
    };
    const auto append = [&](const RL::Solve_report& report) {
      CHECK(report.converged);
      Eigen::VectorXd values(static_cast<Eigen::Index>(numbers.size()));
      for(std::size_t i = 0; i < numbers.size(); ++i)
        values[static_cast<Eigen::Index>(i)] = u[shapes::Mesh::Vertex_index(numbers[i])];
      solutions.push_back(std::move(values));
    };
    append(RL::solve_poisson(mesh, f, u, np));
    append(RL::solve_screened_poisson(mesh, f, 2., u, np));
    const RL::Laplace_spectrum spectrum = RL::laplace_spectrum(mesh, 20, np);
    CHECK(spectrum.report.converged);
    eigenvalues = spectrum.eigenvalues;
  }

  /// the largest one, relative to the largest value
  double difference_of_solutions(const Results& other) const {
    double result = 0;
    for(std::size_t i = 0; i < solutions.size(); ++i)
      result = (std::max)(result, (solutions[i] - other.solutions[i]).cwiseAbs().maxCoeff() /
                                      solutions[i].cwiseAbs().maxCoeff());
    return result;
  }
  /// the largest relative one, without the eigenvalue 0
  double difference_of_eigenvalues(const Results& other) const {
    const Eigen::Index n = eigenvalues.size() - 1;
    return ((eigenvalues - other.eigenvalues).tail(n).array() / eigenvalues.tail(n).array())
        .abs()
        .maxCoeff();
  }

  std::vector<Eigen::VectorXd> solutions;
  Eigen::VectorXd eigenvalues;
};

} // namespace

TEST_CASE("solutions_and_eigenvalues_do_not_depend_on_the_triangulation", "[spectrum]") {
  const shapes::Triangles box = shapes::box(1, 0.7, 0.45, 4, 1), sphere = shapes::sphere(2);
  const auto check = [](const char* name, const Results& a, const Results& b) {
    const double of_solutions = a.difference_of_solutions(b),
                 of_eigenvalues = a.difference_of_eigenvalues(b);
    INFO(name << ": solutions differ by " << of_solutions << ", eigenvalues by " << of_eigenvalues);
    CHECK(of_solutions <= 1e-12);
    CHECK(of_eigenvalues <= 1e-12);
  };
  for(const shapes::Triangles* t : {&box, &sphere}) {
    std::vector<std::uint32_t> numbers(t->points.size());
    std::iota(numbers.begin(), numbers.end(), 0u);
    const Results reference(*t, numbers);
    const shapes::Triangles split = shapes::split_in_four(*t);
    check("refined", Results(split, numbers), reference);
    check("with slivers", Results(with_slivers(split), numbers), reference);
    if(t == &box)
      check("with other diagonals", Results(shapes::box(1, 0.7, 0.45, 4, 2), numbers), reference);
    std::mt19937 generator(5);
    std::shuffle(numbers.begin(), numbers.end(), generator);
    check("reordered", Results(shuffled(*t, numbers, generator), numbers), reference);
  }
}

TEST_CASE("multiplicities_of_the_sphere_up_to_degree_13", "[spectrum][slow]") {
  const shapes::Mesh mesh = shapes::mesh(shapes::sphere(6));
  const RL::Laplace_spectrum spectrum =
      RL::laplace_spectrum(mesh, Sphere_spectrum::count, params::depth(4));
  REQUIRE(spectrum.report.converged);
  const Sphere_spectrum sphere(spectrum.eigenvalues);
  for(int l = 0; l <= Sphere_spectrum::largest_degree; ++l) {
    INFO("degree " << l);
    CHECK(sphere.multiplicity[l] == 2 * l + 1);
  }
  CHECK(sphere.error <= 2e-3);
}

TEST_CASE("spectrum_stays_when_a_mesh_is_simplified", "[spectrum][slow]") {
  // QSlim moves the surface a little; what the spectrum changes beyond that is the fault of the
  // elements.
  const shapes::Mesh fine = shapes::read(cgal_mesh("bear.off"));
  if(fine.is_empty())
    SKIP_TEST("no such file: bear.off");
  const shapes::Mesh coarse = shapes::simplified(fine, fine.number_of_vertices() * 3 / 10);
  REQUIRE(coarse.number_of_vertices() == fine.number_of_vertices() * 3 / 10);
  REQUIRE(CGAL::is_closed(coarse));
  constexpr int count = 100;
  const double restricted =
      mean_change(RL::laplace_spectrum(coarse, count, params::depth(4)).eigenvalues,
                  RL::laplace_spectrum(fine, count, params::depth(4)).eigenvalues);
  const double cotangent = mean_change(RL::cotangent_spectrum(coarse, count).eigenvalues,
                                       RL::cotangent_spectrum(fine, count).eigenvalues);
  INFO("mean change: restricted " << restricted << ", cotangent " << cotangent);
  CHECK(restricted <= 1e-3);
  CHECK(restricted <= cotangent / 50);
}
