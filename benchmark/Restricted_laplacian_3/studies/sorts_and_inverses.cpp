// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Are a sort and an inverse of our own worth their code? Measures, beside what libraries have,
// - `stable_sort_by_key()`: of the elements of sheets by their centers, and of fragments of
//   triangles by their cells, in rows as a scanner sees them or in random order, at a depth where a
//   sphere has 50,000 cells. Sorts that are not stable break ties by the number of the value.
// - `Symmetric_inverse`: of the blocks of a smoother, which have up to 64 unknowns, most of them
//   49. Of the peers only the decomposition into eigenvectors copes with singular blocks, too.
// Each is the median of eleven runs, which take turns, so that all share what else the machine
// does, and is also given over our own.
//
// usage: sorts_and_inverses [--threads N]
// default: one thread

#include "support/driver.h"
#include "support/measure.h"

#include <CGAL/Restricted_laplacian_3/foundation/internal/stable_sort_by_key.h>
#include <CGAL/Restricted_laplacian_3/foundation/morton_key.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Finest_sheets.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Symmetric_inverse.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <boost/math/constants/constants.hpp>
#include <boost/sort/sort.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_sort.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#ifdef RESTRICTED_LAPLACIAN_3_BENCHMARK_LAPACK
extern "C" {
void dpotrf_(const char* triangle, const int* n, double* a, const int* stride, int* info);
void dpotri_(const char* triangle, const int* n, double* a, const int* stride, int* info);
}
#endif

namespace {

using namespace benchmarks;
namespace RL = CGAL::Restricted_laplacian_3;

constexpr int repetitions = 11;

/// what is measured on the same input; the first one is our own
class Table {
public:
  /// \param prepare makes what `work` works on, and does not count
  /// \param check throws if the result is wrong
  void add(const std::string& what, const std::function<void()>& prepare,
           const std::function<void()>& work, const std::function<void()>& check) {
    m_rows.push_back({what, prepare, work, check, {}});
  }

  void measure_and_print(const std::string& input, std::size_t size) {
    for(int repetition = 0; repetition < repetitions; ++repetition)
      for(Row& row : m_rows) {
        row.prepare();
        const double start = seconds_now();
        row.work();
        row.seconds.push_back(seconds_now() - start);
        row.check();
      }
    for(const Row& row : m_rows) {
      const double seconds = median(row.seconds);
      std::printf("%-34s %-20s %9zu %12.3g %9.2f\n", row.what.c_str(), input.c_str(), size, seconds,
                  seconds / median(m_rows.front().seconds));
    }
    std::fflush(stdout);
  }

private:
  struct Row {
    std::string what;
    std::function<void()> prepare, work, check;
    std::vector<double> seconds;
  };
  std::vector<Row> m_rows;
};

/// `Tail` stands for what else a value has
template <std::size_t Tail> struct Value {
  std::uint64_t key;
  std::uint32_t number;
  std::array<std::uint32_t, Tail> tail;

  bool operator<(const Value& other) const {
    return key != other.key ? key < other.key : number < other.number;
  }
  friend bool operator==(const Value& a, const Value& b) {
    return a.key == b.key && a.number == b.number;
  }
};

using Element = Value<1>;
using Fragment = Value<(sizeof(RL::internal::Cell_fragment) - 12) / 4>;
static_assert(sizeof(Fragment) == sizeof(RL::internal::Cell_fragment), "as much to move");

struct By_key {
  template <class V> bool operator()(const V& a, const V& b) const { return a.key < b.key; }
};

template <class V>
void compare_sorts(const std::string& input, const std::vector<V>& values, int bits, int threads) {
  std::vector<V> expected = values, copy;
  std::sort(expected.begin(), expected.end());
  Table table;
  const auto measure = [&](const char* what, const std::function<void(std::vector<V>&)>& sort) {
    table.add(
        what, [&] { copy = values; }, [&copy, sort] { sort(copy); },
        [&, what] {
          if(copy != expected)
            throw std::runtime_error(std::string(what) + " did not sort");
        });
  };
  measure("own radix sort", [&](std::vector<V>& v) {
    RL::internal::stable_sort_by_key(v, bits, threads > 1, [](const V& a) { return a.key; });
  });
  const auto n = static_cast<std::uint32_t>(threads);
  measure("std::stable_sort",
          [](std::vector<V>& v) { std::stable_sort(v.begin(), v.end(), By_key()); });
  measure("std::sort", [](std::vector<V>& v) { std::sort(v.begin(), v.end()); });
  measure("boost::sort::spinsort",
          [](std::vector<V>& v) { boost::sort::spinsort(v.begin(), v.end(), By_key()); });
  measure("boost::sort::flat_stable_sort",
          [](std::vector<V>& v) { boost::sort::flat_stable_sort(v.begin(), v.end(), By_key()); });
  measure("boost::sort::pdqsort",
          [](std::vector<V>& v) { boost::sort::pdqsort(v.begin(), v.end()); });
  measure("boost::sort::integer_sort", [](std::vector<V>& v) {
    // not stable: values of the same key are put in order afterwards
    boost::sort::spreadsort::integer_sort(
        v.begin(), v.end(), [](const V& a, unsigned offset) { return a.key >> offset; }, By_key());
    for(auto begin = v.begin(), end = begin; begin != v.end(); begin = end) {
      while(end != v.end() && end->key == begin->key)
        ++end;
      std::sort(begin, end);
    }
  });
  if(threads > 1) {
    measure("boost::sort::sample_sort",
            [n](std::vector<V>& v) { boost::sort::sample_sort(v.begin(), v.end(), By_key(), n); });
    measure("boost::sort::parallel_stable_sort", [n](std::vector<V>& v) {
      boost::sort::parallel_stable_sort(v.begin(), v.end(), By_key(), n);
    });
    measure("boost::sort::block_indirect_sort", [n](std::vector<V>& v) {
      boost::sort::block_indirect_sort(v.begin(), v.end(), std::less<V>(), n);
    });
#ifdef CGAL_LINKED_WITH_TBB
    measure("tbb::parallel_sort", [](std::vector<V>& v) { tbb::parallel_sort(v); });
#endif
  }
  table.measure_and_print(input, values.size());
}

constexpr int depth = 7;

std::array<int, 3> cell_of(double x, double y, double z) {
  const auto index = [](double t) { return static_cast<int>((t * 0.4 + 0.5) * (1 << depth)); };
  return {index(x), index(y), index(z)};
}

/// the cells of fragments on a sphere, in rows
std::vector<Fragment> fragments_in_rows(int rows) {
  std::vector<Fragment> result;
  for(int i = 0; i < rows; ++i) {
    const double latitude = boost::math::constants::pi<double>() * (i + 0.5) / rows;
    const int columns = static_cast<int>(2 * rows * std::sin(latitude)) + 1;
    for(int j = 0; j < columns; ++j) {
      const double longitude = boost::math::constants::two_pi<double>() * (j + 0.5) / columns;
      result.push_back(
          {RL::morton_key(cell_of(std::sin(latitude) * std::cos(longitude),
                                  std::sin(latitude) * std::sin(longitude), std::cos(latitude))),
           static_cast<std::uint32_t>(result.size()),
           {}});
    }
  }
  return result;
}

/// the centers of the 27 elements of each cell, in the order of cells
std::vector<Element> elements_of_cells(const std::vector<Fragment>& fragments) {
  std::vector<std::uint64_t> cells;
  for(const auto& fragment : fragments)
    cells.push_back(fragment.key);
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  std::vector<Element> result;
  for(std::uint64_t cell : cells) {
    const std::array<int, 3> index = RL::morton_index(cell);
    for(int dz = 0; dz < 3; ++dz)
      for(int dy = 0; dy < 3; ++dy)
        for(int dx = 0; dx < 3; ++dx)
          result.push_back({RL::morton_key({index[0] + dx, index[1] + dy, index[2] + dz}),
                            static_cast<std::uint32_t>(result.size()),
                            {}});
  }
  return result;
}

void compare_all_sorts(int threads) {
  std::vector<Fragment> fragments = fragments_in_rows(560);
  compare_sorts("elements", elements_of_cells(fragments), 3 * (depth + 2), threads);
  compare_sorts("fragments, rows", fragments, 3 * depth, threads);
  std::mt19937 generator(1);
  std::shuffle(fragments.begin(), fragments.end(), generator);
  for(std::size_t i = 0; i < fragments.size(); ++i)
    fragments[i].number = static_cast<std::uint32_t>(i);
  compare_sorts("fragments, random", fragments, 3 * depth, threads);
}

/// inverses of as many blocks as a patch smoother has at depth 7
void compare_inverses(int size) {
  constexpr std::size_t number_of_blocks = 256; // of them, again and again
  const int stride = (size + 7) / 8 * 8;
  // Functions of few degrees of freedom at many points, as splines on a surface.
  std::vector<Eigen::MatrixXd> blocks;
  for(std::size_t i = 0; i < number_of_blocks; ++i) {
    const Eigen::MatrixXd factor = Eigen::MatrixXd::Random(4 * size, size);
    blocks.push_back(factor.transpose() * factor / (4. * size));
    blocks.back().diagonal().array() += 1e-5;
  }
  std::vector<Eigen::MatrixXd> results;
  std::vector<std::vector<double>> stored(number_of_blocks);
  Table table;

  // the largest error of the first block
  const auto check = [&](const char* what, const Eigen::MatrixXd& inverse) {
    const Eigen::MatrixXd whole = inverse.selfadjointView<Eigen::Lower>();
    if(!((blocks[0] * whole - Eigen::MatrixXd::Identity(size, size)).norm() < 1e-9))
      throw std::runtime_error(std::string(what) + " did not invert");
  };
  table.add(
      "own inverse",
      [&] {
        for(std::size_t i = 0; i < number_of_blocks; ++i) {
          stored[i].assign(static_cast<std::size_t>(stride) * stride, 0.);
          for(int row = 0; row < size; ++row)
            for(int column = 0; column <= row; ++column)
              stored[i][static_cast<std::size_t>(stride * row + column)] = blocks[i](row, column);
        }
      },
      [&] {
        RL::internal::Symmetric_inverse invert;
        for(auto& block : stored)
          invert(block.data(), size, stride, 5e-6);
      },
      [&] {
        // rows there are columns here
        check("own inverse", Eigen::Map<Eigen::MatrixXd>(stored[0].data(), stride, stride)
                                 .topLeftCorner(size, size)
                                 .transpose());
      });
  const auto measure = [&](const char* what, const std::function<void(Eigen::MatrixXd&)>& invert) {
    table.add(
        what, [&] { results = blocks; },
        [&results, invert] {
          for(Eigen::MatrixXd& block : results)
            invert(block);
        },
        [&results, check, what] { check(what, results[0]); });
  };

  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(size, size);
  measure("Eigen::LLT", [&](Eigen::MatrixXd& a) { a = Eigen::MatrixXd(a.llt().solve(identity)); });
  measure("Eigen::LDLT",
          [&](Eigen::MatrixXd& a) { a = Eigen::MatrixXd(a.ldlt().solve(identity)); });
  measure("Eigen::PartialPivLU",
          [](Eigen::MatrixXd& a) { a = Eigen::MatrixXd(a.partialPivLu().inverse()); });
  measure("Eigen::SelfAdjointEigenSolver", [](Eigen::MatrixXd& a) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(a);
    a = Eigen::MatrixXd(solver.eigenvectors() * solver.eigenvalues().cwiseInverse().asDiagonal() *
                        solver.eigenvectors().transpose());
  });
#ifdef RESTRICTED_LAPLACIAN_3_BENCHMARK_LAPACK
  set_blas_threads(1);
  measure("LAPACK dpotrf, dpotri", [size](Eigen::MatrixXd& a) {
    int info = 0;
    dpotrf_("L", &size, a.data(), &size, &info);
    dpotri_("L", &size, a.data(), &size, &info);
  });
#endif
  table.measure_and_print("blocks of " + std::to_string(size), number_of_blocks);
}

} // namespace

int main(int argc, char* argv[]) {
  return run_benchmark("sorts_and_inverses", [&] {
    int threads = 1;
    for(int i = 1; i < argc; ++i)
      if(std::strcmp(argv[i], "--threads") == 0 && i + 1 < argc)
        threads = std::atoi(argv[++i]);
      else
        threads = 0;
    if(threads < 1)
      throw std::runtime_error("usage: sorts_and_inverses [--threads N]");
#ifdef CGAL_LINKED_WITH_TBB
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(threads));
#endif
    print_header(argc, argv);
    std::printf("# %-32s %-20s %9s %12s %9s\n", "what", "input", "values", "seconds", "over own");
    compare_all_sorts(threads);
    // Each block is inverted by one thread, however many there are.
    if(threads == 1)
      for(int size : {27, 49, 64})
        compare_inverses(size);
  });
}
