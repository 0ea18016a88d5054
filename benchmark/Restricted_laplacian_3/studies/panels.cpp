// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Are panels of eight columns worth the code for them? Measures what an iteration of
// `multigrid_eigenpairs()` does with tall matrices, X in double, P and W in single precision:
// - products: of all columns with those of S W and M W
// - update: X and P become combinations of all columns
// for panels, and for matrices of Eigen, with the columns or the rows one after the other, which
// get all columns of S W and M W at once, and are worked on in the same chunks of rows: with P and
// W in single precision as well, or all in double. Each is the median of nine runs, which take
// turns, so that all share what else the machine does; what it takes is also given over the time
// for panels.
//
// usage: panels [--threads N] [--pairs K] [--processor-time] ROWS...
// default: one thread, 50 pairs, 9093 and 35708 rows (a bunny at depths 5 and 6)

#include "support/driver.h"
#include "support/measure.h"

#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/spectra/internal/Column_panels.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace benchmarks;
namespace RL = CGAL::Restricted_laplacian_3;

constexpr int width = RL::internal::panel_width;

/// numbers of columns
struct Sizes {
  Eigen::Index rows, x, p, w;
  Eigen::Index all() const { return x + p + w; }
};

struct Times {
  double products, update;
};

/// of a second run; the first one finds the memory
template <class Work> double seconds_of(Work&& work) {
  work();
  const double start = seconds_now();
  work();
  return seconds_now() - start;
}

/// coefficients that keep the columns of the order of 1
Eigen::MatrixXd coefficients(Eigen::Index rows, Eigen::Index columns) {
  return Eigen::MatrixXd::Random(rows, columns) / double(rows);
}

double checksum = 0; // so that nothing is left out because nobody reads it

template <class Number> void fill(RL::internal::Column_panels<Number>& panels) {
  for(std::size_t i = 0; i < panels.number_of_panels(); ++i)
    for(Eigen::Index j = 0; j < width * panels.rows(); ++j)
      panels.panel(i)[j] = static_cast<Number>(std::rand()) / static_cast<Number>(RAND_MAX) - 0.5f;
}

Times measure_panels(const Sizes& n, bool is_parallel) {
  RL::internal::Column_panels<double> x(n.rows, n.x);
  RL::internal::Column_panels<float> p(n.rows, n.p), w(n.rows, n.w);
  fill(x);
  fill(p);
  fill(w);
  std::vector<RL::internal::Panel_view> panels;
  add_views(x, panels);
  add_views(p, panels);
  const std::size_t first_w = panels.size();
  add_views(w, panels);
  const RL::internal::Block_vector<width> sw = RL::internal::Block_vector<width>::Random(n.rows,
                                                                                         width),
                                          mw = RL::internal::Block_vector<width>::Random(n.rows,
                                                                                         width);
  Times times;
  times.products = seconds_of([&] {
    for(std::size_t i = first_w; i < panels.size(); ++i)
      checksum += RL::internal::scalar_products(is_parallel, panels, i + 1, sw, mw).first(1, 2);
  });
  const Eigen::MatrixXd c = coefficients(n.all(), n.x), d = coefficients(n.all(), n.p);
  times.update = seconds_of([&] { RL::internal::combine(is_parallel, panels, c, x, d, p); });
  checksum += x.column(3)[0];
  return times;
}

/// \tparam Order `Eigen::ColMajor` or `Eigen::RowMajor`
/// \tparam Number of P and W
template <int Order, class Number> Times measure_eigen(const Sizes& n, bool is_parallel) {
  using Doubles = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Order>;
  using Numbers = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic, Order>;
  constexpr std::size_t parts = 16, rows_of_a_chunk = 256;
  Doubles x = Doubles::Random(n.rows, n.x);
  Numbers p = Numbers::Random(n.rows, n.p), w = Numbers::Random(n.rows, n.w);
  const Doubles sw = Doubles::Random(n.rows, n.w), mw = Doubles::Random(n.rows, n.w);
  const std::size_t rows = static_cast<std::size_t>(n.rows), grain = rows / parts + 1;
  // all columns of some rows, in double precision
  const auto gather = [&](std::size_t row, std::size_t size, Doubles& all) {
    const auto first = static_cast<Eigen::Index>(row), count = static_cast<Eigen::Index>(size);
    all.resize(count, n.all());
    all.leftCols(n.x) = x.middleRows(first, count);
    all.middleCols(n.x, n.p) = p.middleRows(first, count).template cast<double>();
    all.rightCols(n.w) = w.middleRows(first, count).template cast<double>();
  };
  const auto for_each_chunk = [&](auto&& work) {
    RL::internal::parallel_for(is_parallel, 0, rows, grain,
                               [&](std::size_t begin, std::size_t end) {
                                 Doubles all;
                                 for(std::size_t row = begin; row < end; row += rows_of_a_chunk) {
                                   const std::size_t size = (std::min)(rows_of_a_chunk, end - row);
                                   gather(row, size, all);
                                   work(begin / grain, static_cast<Eigen::Index>(row),
                                        static_cast<Eigen::Index>(size), all);
                                 }
                               });
  };
  Times times;
  times.products = seconds_of([&] {
    std::vector<Eigen::MatrixXd> s(parts, Eigen::MatrixXd::Zero(n.all(), n.w)), m = s;
    for_each_chunk([&](std::size_t part, Eigen::Index row, Eigen::Index size, const Doubles& all) {
      s[part].noalias() += all.transpose() * sw.middleRows(row, size);
      m[part].noalias() += all.transpose() * mw.middleRows(row, size);
    });
    for(std::size_t part = 1; part < parts; ++part)
      s[0] += s[part], m[0] += m[part];
    checksum += s[0](1, 2) + m[0](1, 2);
  });
  const Eigen::MatrixXd c = coefficients(n.all(), n.x), d = coefficients(n.all(), n.p);
  times.update = seconds_of([&] {
    for_each_chunk([&](std::size_t, Eigen::Index row, Eigen::Index size, const Doubles& all) {
      x.middleRows(row, size).noalias() = all * c;
      p.middleRows(row, size) = (all * d).template cast<Number>();
    });
  });
  checksum += x(0, 3);
  return times;
}

void print(const char* what, const Sizes& n, int threads, const Times& times, const Times& panels) {
  std::printf("%-28s %7td %4td %4td %4td %7d %9.4f %9.4f %8.2f %8.2f\n", what, n.rows, n.x, n.p,
              n.w, threads, times.products, times.update, times.products / panels.products,
              times.update / panels.update);
  std::fflush(stdout);
}

void compare(Eigen::Index rows, int pairs, int threads) {
  // as many columns as multigrid_eigenpairs() has in its second iteration
  const Eigen::Index block = (pairs + (std::max)(8, pairs / 3) + width - 1) / width * width,
                     own = (pairs + width - 1) / width * width;
  const Sizes n = {rows, block, own, own};
  const bool is_parallel = threads > 1;
  struct Method {
    const char* what;
    Times (*measure)(const Sizes&, bool);
    std::vector<double> products, update;
    Times times() const { return {median(products), median(update)}; }
  };
  std::vector<Method> methods = {
      {"panels", measure_panels, {}, {}},
      {"columns, single precision", measure_eigen<Eigen::ColMajor, float>, {}, {}},
      {"rows, single precision", measure_eigen<Eigen::RowMajor, float>, {}, {}},
      {"columns, double precision", measure_eigen<Eigen::ColMajor, double>, {}, {}},
      {"rows, double precision", measure_eigen<Eigen::RowMajor, double>, {}, {}}};
  for(int repetition = 0; repetition < 9; ++repetition)
    for(Method& method : methods) {
      const Times times = method.measure(n, is_parallel);
      method.products.push_back(times.products);
      method.update.push_back(times.update);
    }
  for(const Method& method : methods)
    print(method.what, n, threads, method.times(), methods.front().times());
}

} // namespace

int main(int argc, char* argv[]) {
  return run_benchmark("panels", [&] {
    int threads = 1, pairs = 50;
    std::vector<Eigen::Index> rows;
    for(int i = 1; i < argc; ++i)
      if(std::strcmp(argv[i], "--threads") == 0 && i + 1 < argc)
        threads = std::atoi(argv[++i]);
      else if(std::strcmp(argv[i], "--processor-time") == 0)
        counts_processor_time() = true;
      else if(std::strcmp(argv[i], "--pairs") == 0 && i + 1 < argc)
        pairs = std::atoi(argv[++i]);
      else
        rows.push_back(std::atoi(argv[i]));
    if(rows.empty())
      rows = {9093, 35708};
    if(threads < 1 || pairs < 1 || *std::min_element(rows.begin(), rows.end()) < 1)
      throw std::runtime_error(
          "usage: panels [--threads N] [--pairs K] [--processor-time] ROWS...");
#ifdef CGAL_LINKED_WITH_TBB
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(threads));
#endif
    print_header(argc, argv);
    std::printf("# what                            rows    X    P    W threads  products    update"
                "  over panels\n");
    for(Eigen::Index n : rows)
      compare(n, pairs, threads);
    std::fprintf(stderr, "checksum %g\n", checksum);
  });
}
