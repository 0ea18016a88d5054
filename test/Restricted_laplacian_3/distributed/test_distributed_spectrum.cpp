// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Eigenpairs on several processes, against those of one process, and the files that they are in.

#include "../catch.h"
#include "../special_shapes.h"
#include "../test_meshes.h"
#include "slices.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_functions.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_spectrum.h>
#include <CGAL/Restricted_laplacian_3/distributed/write_in_order.h>
#include <CGAL/Restricted_laplacian_3/problems/space_spectrum.h>

#include <petscsys.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
using shapes::Triangles;

RL::Laplace_spectrum_options options_of(double tolerance) {
  RL::Laplace_spectrum_options result;
  result.multigrid.tolerance = tolerance;
  return result;
}

RL::Triangulated_surface_3 surface_of(const Triangles& t) {
  return RL::Triangulated_surface_3(t.points, t.faces);
}

// largest difference from the eigenvalues of one process, over them, or over the mean distance of
// two eigenvalues if they are 0
double difference_of_values(const RL::Spline_space_3& whole, const RL::Distributed_spectrum& found,
                            int k) {
  RL::Laplace_spectrum_options options;
  options.eigensolver = RL::Eigensolver::shift_invert;
  const Eigen::VectorXd expected = RL::laplace_eigenpairs(whole, k, options).eigenvalues,
                        &values = found.pairs.values;
  REQUIRE(values.size() == k);
  double result = 0;
  const double distance = 4 * 3.14159265358979323846 / whole.surface().area();
  for(int i = 0; i < k; ++i) {
    const double scale = expected[i] > 1e-8 * distance ? expected[i] : distance;
    result = (std::max)(result, std::abs(values[i] - expected[i]) / scale);
    CHECK((i == 0 || values[i - 1] <= values[i]));
  }
  return result;
}

// largest deviation of X^T M X from the identity
double defect_of_orthonormality(const RL::Distributed_space& space,
                                const RL::Distributed_functions& pairs) {
  const RL::Sparse_matrix mass = RL::assemble_mass_matrix(space.part());
  const Eigen::MatrixXd products = pairs.coefficients.transpose() * (mass * pairs.coefficients);
  std::vector<double> entries(products.data(), products.data() + products.size());
  space.communicator().sum(entries);
  double result = 0;
  for(Eigen::Index i = 0; i < products.rows(); ++i)
    for(Eigen::Index j = 0; j < products.cols(); ++j)
      result = (std::max)(result, std::abs(entries[i + products.rows() * j] - (i == j ? 1 : 0)));
  return result;
}

bool are_signs_right(const RL::Distributed_space& space, const RL::Distributed_functions& pairs) {
  bool result = true;
  for(Eigen::Index i = 0; i < pairs.values.size(); ++i) {
    const double largest = space.communicator().maximum(pairs.coefficients.col(i).maxCoeff()),
                 smallest = space.communicator().minimum(pairs.coefficients.col(i).minCoeff());
    result &= largest >= -smallest;
  }
  return result;
}

// a name that all ranks know
std::string temporary_file(const RL::Communicator& communicator) {
  std::string name = (std::filesystem::temp_directory_path() / "restricted_laplacian_3_").string() +
                     std::to_string(std::filesystem::hash_value(std::filesystem::current_path())) +
                     "_" + std::to_string(communicator.size());
  std::vector<char> text(name.begin(), name.end());
  communicator.broadcast(text, 0);
  return std::string(text.begin(), text.end());
}

} // namespace

TEST_CASE("spectra_of_shapes_on_ranks", "[shapes]") {
  // the last ones have too few unknowns for an iteration
  struct Case {
    std::string name;
    Triangles t;
    int depth, k;
  };
  const std::vector<Case> cases = {
      {"sphere", shapes::sphere(3), 4, 16},
      {"box", shapes::box(1, 1, 0.05, 3, 1), 5, 6},
      {"two", shapes::joined(shapes::sphere(2), shapes::moved(shapes::sphere(2), {3, 0.1, 0})), 4,
       10},
      {"stairs", shapes::stairs(6, 0.1), 6, 1},
      {"small sphere", shapes::sphere(2), 2, 20},
      {"smallest sphere", shapes::sphere(2), 1, 3}};
  for(const auto& [name, t, depth, k] : cases) {
    INFO(name);
    const Spaces spaces(surface_of(t), depth);
    const RL::Distributed_spectrum spectrum =
        RL::laplace_spectrum(spaces.distributed, k, options_of(1e-6));
    CHECK(spectrum.report.converged);
    CHECK(spectrum.number_of_known == 0);
    // with the vectors of the coarser level to begin with
    CHECK(spectrum.report.iterations <= 10);
    CHECK(spectrum.residuals.maxCoeff() <= 1e-6);
    CHECK(difference_of_values(spaces.whole, spectrum, k) <= 1e-10);
    CHECK(defect_of_orthonormality(spaces.distributed, spectrum.pairs) <= 1e-8);
    CHECK(are_signs_right(spaces.distributed, spectrum.pairs));
  }
}

TEST_CASE("spectra_of_materials_on_ranks", "[shapes]") {
  const Spaces spaces(surface_of(shapes::sphere(3)), 4, RL::Communicator(), some_material());
  const RL::Distributed_spectrum spectrum =
      RL::laplace_spectrum(spaces.distributed, 16, options_of(1e-6));
  CHECK(spectrum.report.converged);
  CHECK(difference_of_values(spaces.whole, spectrum, 16) <= 1e-10);
  // in the density
  CHECK(defect_of_orthonormality(spaces.distributed, spectrum.pairs) <= 1e-8);
}

TEST_CASE("eigenpairs_that_are_known_are_not_computed_again", "[shapes]") {
  const Spaces spaces(surface_of(shapes::box(1, 0.7, 0.4, 3, 1)), 5);
  const RL::Distributed_space& space = spaces.distributed;
  constexpr int k = 40, first = 9;
  RL::Distributed_spectrum_state state;
  std::vector<RL::Distributed_functions> told;
  state.found = [&](const RL::Distributed_functions& pairs) { told.push_back(pairs); };
  const RL::Distributed_spectrum all = RL::laplace_spectrum(space, k, options_of(1e-4), state);
  REQUIRE(all.pairs.values.size() == k);
  // not all at once, each time more, and all of them pairs
  REQUIRE(!told.empty());
  CHECK(told.front().values.size() < k);
  for(std::size_t i = 0; i < told.size(); ++i) {
    CHECK((i == 0 || told[i - 1].values.size() < told[i].values.size()));
    for(double value : told[i].values) {
      double nearest = 1;
      for(double other : all.pairs.values)
        nearest = (std::min)(nearest, std::abs(value - other) / all.pairs.values[k - 1]);
      CHECK(nearest <= 1e-8);
    }
  }

  told.clear();
  state.known = {all.pairs.values.head(first), all.pairs.coefficients.leftCols(first)};
  const RL::Distributed_spectrum continued =
      RL::laplace_spectrum(space, k, options_of(1e-4), state);
  CHECK(continued.number_of_known == first);
  CHECK(continued.report.converged);
  CHECK((continued.pairs.values - all.pairs.values).cwiseAbs().maxCoeff() <=
        1e-8 * all.pairs.values[k - 1]);
  CHECK((continued.pairs.coefficients - all.pairs.coefficients)
            .leftCols(first)
            .cwiseAbs()
            .maxCoeff() <= 1e-10 * all.pairs.coefficients.cwiseAbs().maxCoeff());
  CHECK(defect_of_orthonormality(space, continued.pairs) <= 1e-4);
  // what was known is told as well
  REQUIRE(!told.empty());
  for(double known : state.known.values)
    CHECK((told.front().values.array() - known).abs().minCoeff() <=
          1e-10 * all.pairs.values[k - 1]);

  // all of them
  state.known = all.pairs;
  const RL::Distributed_spectrum nothing_to_do =
      RL::laplace_spectrum(space, first, options_of(1e-4), state);
  CHECK(nothing_to_do.number_of_known == first);
  CHECK(nothing_to_do.report.iterations == 0);
  CHECK((nothing_to_do.pairs.values - all.pairs.values.head(first)).cwiseAbs().maxCoeff() <=
        1e-12 * all.pairs.values[k - 1]);

  // one of them twice, and a function that is 0
  state.known.values.resize(4);
  state.known.values << all.pairs.values.head(2), all.pairs.values[1], 0;
  state.known.coefficients.setZero(all.pairs.coefficients.rows(), 4);
  state.known.coefficients.leftCols(2) = all.pairs.coefficients.leftCols(2);
  state.known.coefficients.col(2) = -all.pairs.coefficients.col(1);
  const RL::Distributed_spectrum without_copies =
      RL::laplace_spectrum(space, first, options_of(1e-4), state);
  CHECK(without_copies.number_of_known == 2);
  CHECK(without_copies.report.converged);
  CHECK((without_copies.pairs.values - all.pairs.values.head(first)).cwiseAbs().maxCoeff() <=
        1e-8 * all.pairs.values[k - 1]);

  // what is not an eigenpair, or not to the tolerance, is a first guess; many of them
  state.known = all.pairs;
  state.known.coefficients.setRandom();
  const RL::Distributed_spectrum anew = RL::laplace_spectrum(space, first, options_of(1e-4), state);
  CHECK(anew.number_of_known == 0);
  CHECK(anew.report.converged);
  CHECK((anew.pairs.values - all.pairs.values.head(first)).cwiseAbs().maxCoeff() <=
        1e-8 * all.pairs.values[k - 1]);
}

TEST_CASE("other_eigensolvers_of_slepc_find_the_same_pairs", "[shapes]") {
  constexpr int k = 9;
  constexpr double tolerance = 1e-6;
  // an ellipsoid: of equal eigenvalues, as a sphere has, Krylov-Schur may miss one
  Triangles ellipsoid = shapes::sphere(3);
  for(auto& p : ellipsoid.points)
    p = {1.3 * p[0], p[1], 0.8 * p[2]};
  const Spaces spaces(surface_of(ellipsoid), 4);
  const std::vector<std::pair<const char*, const char*>> direct = {
      {"-st_type", "shift"}, {"-st_ksp_type", "preonly"}, {"-st_pc_type", "redundant"}};
  for(const char* type : {"gd", "krylovschur"}) {
    const bool is_direct = std::string(type) == "krylovschur";
    REQUIRE(PetscOptionsSetValue(nullptr, "-eps_type", type) == 0);
    for(const auto& [option, value] : direct)
      if(is_direct)
        REQUIRE(PetscOptionsSetValue(nullptr, option, value) == 0);
    const RL::Distributed_spectrum spectrum =
        RL::laplace_spectrum(spaces.distributed, k, options_of(tolerance));
    REQUIRE(PetscOptionsClearValue(nullptr, "-eps_type") == 0);
    for(const auto& option : direct)
      if(is_direct)
        REQUIRE(PetscOptionsClearValue(nullptr, option.first) == 0);
    INFO(type);
    CHECK(spectrum.report.converged);
    CHECK(spectrum.residuals.maxCoeff() <= tolerance);
    CHECK(difference_of_values(spaces.whole, spectrum, k) <= 1e-6);
  }
}

TEST_CASE("functions_are_read_by_any_number_of_ranks", "[shapes]") {
  const RL::Communicator communicator;
  const RL::Triangulated_surface_3 surface = surface_of(shapes::stairs(6, 0.1));
  const Spaces spaces(surface, 5), own(surface, 5, RL::Communicator(MPI_COMM_SELF));
  const std::string file = temporary_file(communicator);
  const int depth = spaces.distributed.depth();
  // a value for each element that tells which one it is
  const std::vector<std::uint64_t>& elements = spaces.distributed.level(depth).elements;
  RL::Distributed_functions functions;
  functions.values = Eigen::Vector2d(0.5, 1e300);
  functions.coefficients.resize(static_cast<Eigen::Index>(elements.size()), 2);
  for(std::size_t i = 0; i < elements.size(); ++i)
    for(int j = 0; j < 2; ++j)
      functions.coefficients(static_cast<Eigen::Index>(i), j) =
          1. / (3. + j + static_cast<double>(elements[i]));
  RL::save_functions(spaces.distributed, file, functions);

  const RL::Distributed_functions again = RL::load_functions(spaces.distributed, file),
                                  whole = RL::load_functions(own.distributed, file);
  CHECK(again.values == functions.values);
  CHECK(again.coefficients == functions.coefficients);
  REQUIRE(whole.coefficients.rows() == static_cast<Eigen::Index>(own.whole.dimension()));
  bool are_equal = true;
  for(Eigen::Index i = 0; i < whole.coefficients.rows(); ++i)
    for(int j = 0; j < 2; ++j)
      are_equal &= whole.coefficients(i, j) == 1. / (3. + j + static_cast<double>(i));
  CHECK(are_equal);

  const auto message = [&](const RL::Distributed_space& space) {
    try {
      static_cast<void>(RL::load_functions(space, file));
    } catch(const RL::Distributed_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const auto is_in = [](const std::string& part, const std::string& text) {
    return text.find(part) != std::string::npos;
  };
  // the same elements on a surface that is elsewhere; other elements
  Triangles moved = shapes::stairs(6, 0.1);
  for(auto& p : moved.points)
    p = RL::Point_3(p.x() + 1, p.y(), p.z());
  CHECK(is_in("another surface", message(Spaces(surface_of(moved), 5).distributed)));
  CHECK(is_in("other elements", message(Spaces(surface, 4).distributed)));
  std::string content;
  {
    std::ifstream in(file, std::ios::binary);
    content.assign(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  const auto write = [&](const std::string& text) {
    RL::write_in_order(communicator, file, {communicator.rank() == 0 ? text : std::string()});
  };
  write(content.substr(0, content.size() - 1));
  CHECK(is_in("cut off", message(spaces.distributed)));
  write(content + "x");
  CHECK(is_in("damaged", message(spaces.distributed)));
  write("ply\n" + content);
  CHECK(is_in("not a file of functions", message(spaces.distributed)));
  std::string with_nan = content;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  with_nan.replace(with_nan.size() - sizeof nan, sizeof nan,
                   std::string(reinterpret_cast<const char*>(&nan), sizeof nan));
  write(with_nan);
  CHECK(is_in("not a finite number", message(spaces.distributed)));
  write("");
  CHECK(is_in("not a file of functions", message(spaces.distributed)));
  communicator.agree([&] {
    if(communicator.rank() == 0)
      std::filesystem::remove(file);
  });
  CHECK(is_in("cannot open", message(spaces.distributed)));
  functions.values.resize(1);
  CHECK_THROWS_AS(RL::save_functions(spaces.distributed, file, functions), RL::Distributed_error);
}

TEST_CASE("what_is_wrong_with_a_spectrum_on_ranks", "[shapes]") {
  const RL::Communicator communicator;
  const Spaces spaces(surface_of(shapes::sphere(2)), 4);
  const RL::Distributed_space& space = spaces.distributed;
  const auto fails = [&](const std::string& parameter, int k, const RL::Laplace_spectrum_options& o,
                         const RL::Distributed_spectrum_state& state = {}) {
    try {
      static_cast<void>(RL::laplace_spectrum(space, k, o, state));
    } catch(const RL::Distributed_error& error) {
      return error.parameter() == parameter;
    }
    return false;
  };
  RL::Laplace_spectrum_options options;
  CHECK(fails("count", 0, options));
  CHECK(fails("count", 1000000, options));
  options.multigrid.tolerance = 1.;
  CHECK(fails("tolerance", 3, options));
  options = {};
  options.multigrid.smoothing_steps = 0;
  CHECK(fails("smoothing_steps", 3, options));
  options = {};
  options.multigrid.maximum_iterations = -1;
  CHECK(fails("maximum_iterations", 3, options));
  options = {};
  options.stabilization = -1;
  CHECK(fails("stabilization", 3, options));
  options = {};
  // on one rank only
  RL::Distributed_spectrum_state state;
  state.known.values = Eigen::VectorXd::Ones(1);
  state.known.coefficients.setOnes(static_cast<Eigen::Index>(space.part().dimension()) +
                                       (communicator.rank() == communicator.size() - 1 ? 1 : 0),
                                   1);
  CHECK(fails("known", 3, options, state));
  // an error of the functor ends the iteration
  state.known = {};
  int calls = 0;
  state.found = [&](const RL::Distributed_functions&) {
    ++calls;
    throw RL::Distributed_error("cannot write");
  };
  options.multigrid.tolerance = 1e-4;
  CHECK_THROWS_AS(static_cast<void>(RL::laplace_spectrum(space, 3, options, state)),
                  RL::Distributed_error);
  CHECK(calls == 1);
  // the largest number of iterations
  options = options_of(1e-13);
  options.multigrid.maximum_iterations = 1;
  const RL::Distributed_spectrum spectrum = RL::laplace_spectrum(space, 3, options);
  CHECK(!spectrum.report.converged);
  CHECK(spectrum.pairs.values.size() < 3);
  CHECK(spectrum.pairs.coefficients.cols() == spectrum.pairs.values.size());
}

TEST_CASE("spectra_of_real_meshes_on_ranks", "[meshes]") {
  for(const std::string name : {"moebius.ply", "rgbd5_scan1.ply", "bunny_uniform_18k.ply"}) {
    const std::string path = shared_mesh(name);
    if(path.empty()) {
      SKIP_PART(name << " is not there");
      continue;
    }
    INFO(name);
    std::vector<RL::Point_3> points;
    std::vector<std::vector<std::size_t>> faces;
    REQUIRE(CGAL::IO::read_polygon_soup(path, points, faces));
    const Spaces spaces(RL::read_surface(RL::soup(points, faces)), 5);
    const RL::Distributed_spectrum spectrum =
        RL::laplace_spectrum(spaces.distributed, 8, options_of(1e-6));
    CHECK(spectrum.report.converged);
    CHECK(difference_of_values(spaces.whole, spectrum, 8) <= 1e-10);
  }
}
