// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What would many processes have to do, and to say to each other? Nothing is solved here: the cells
// of a large surface are found, divided among ranks as by Distributed_surface, and counted.
//
//   partition_study MESH N [--depth D] [--ranks R...] [--threads T]
//                   [--rate NS] [--latency US] [--bandwidth GBS]
//
// Divides the triangles of MESH into N^2 each, on smooth patches (as refine_mesh does, and with N =
// 1 takes them as they are), and cuts all of them into the cells of level D. Elements are those of
// an octree whose cells have one sheet each: 27 around each cell.
//
// Columns: ranks; the largest load over the mean, of the work of a cycle (relaxed unknowns of
// patches, all levels that are divided), of unknowns of the finest level, and of fragments of
// triangles; means of the unknowns, and of those that are relaxed in a cycle, each once for each
// patch that it is in; ghosts, unknowns of all levels that a rank knows of others, mean and
// largest; messages that a rank sends in a cycle, and kB, mean and largest; the model: milliseconds
// of a cycle, those of them for levels that all ranks hold, and the part of the time of one rank
// over that of all (efficiency).
//
// The model. A cycle is one sweep down and one up. Colors follow each other: each takes the longest
// time of all ranks, its relaxed unknowns times the rate, its messages times the latency, and its
// bytes over the bandwidth; then come levels that all ranks hold, each for itself. The rate is the
// time of a cycle of one rank (distributed_comparison) over the unknowns that it relaxes. A rank
// sends what it has relaxed to all that know it, after each color; and to those that know what it
// owns, three times for right-hand sides and first values of the sweeps, and twice for prolongation
// and restriction. Each sum over all ranks takes twice the latency for each factor of two. A
// network is assumed: its latency and bandwidth are not those of this machine.
// (distributed_comparison counts the messages of a cycle where it runs.)

#include "support/driver.h"
#include "support/measure.h"
#include "support/meshes.h"
#include "support/refined_mesh.h"

#include <CGAL/Restricted_laplacian_3/distributed/Rank_ranges.h>
#include <CGAL/Restricted_laplacian_3/foundation/morton_key.h>
#include <CGAL/Restricted_laplacian_3/octree/Octree_3.h>
#include <CGAL/Restricted_laplacian_3/octree/clip_to_cells.h>
#include <CGAL/Restricted_laplacian_3/octree/shared/Octree_builder.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using namespace benchmarks;

namespace {

using Keys = std::vector<std::uint64_t>;

void sort_unique(Keys& keys) {
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
}

// the finest cells that a surface meets, and what there is in the cells of the level of the ranges
struct Cells {
  int depth, range_level;
  double triangles = 0;
  Keys keys;                            // ascending
  std::vector<double> weights;          // as in Distributed_surface::balanced_ranges()
  std::vector<std::uint32_t> fragments; // counted
};

Cells cells_of(const RL::Triangulated_surface_3& surface, const Refined_mesh* refined,
               std::uint32_t n, int depth, int threads) {
  constexpr double fragments_of_cell_area = 50, cube_scale = 1.1;
  const RL::Octree_3 octree =
      RL::internal::Octree_builder::without_levels(surface, depth, cube_scale, true, false);
  Cells result;
  result.depth = depth;
  result.range_level = RL::Rank_ranges::level_of_ranges(depth);
  const int shift = 3 * (depth - result.range_level);
  const std::size_t number_of_ranges = std::size_t(1) << 3 * result.range_level;
  struct Part {
    Keys keys;
    std::vector<double> weights;
    std::vector<std::uint32_t> fragments;
  };
  std::vector<Part> parts(static_cast<std::size_t>(threads));
  const auto work = [&](std::size_t thread) {
    Part& part = parts[thread];
    part.weights.resize(number_of_ranges);
    part.fragments.resize(number_of_ranges);
    const RL::Cell_clipper clipper(1 << depth, octree.wall_tolerance(depth));
    std::vector<std::array<double, 3>> corners(std::size_t(n + 1) * (n + 1));
    Keys of_face, of_triangle;
    const std::size_t begin = surface.number_of_faces() * thread / parts.size(),
                      end = surface.number_of_faces() * (thread + 1) / parts.size();
    for(std::size_t f = begin; f < end; ++f) {
      if(surface.is_degenerate(f))
        continue;
      const auto place = [n](std::uint32_t i, std::uint32_t j) {
        return std::size_t(i) * (n + 1) + j;
      };
      for(std::uint32_t j = 0; j <= n; ++j)
        for(std::uint32_t i = 0; i + j <= n; ++i) {
          RL::Point_3 p;
          if(refined) {
            const Position x = refined->position(f, i, j);
            p = RL::Point_3(x[0], x[1], x[2]);
          } else
            p = surface.point(f, i == 1 ? 1 : j == 1 ? 2 : 0);
          corners[place(i, j)] = octree.grid_coordinates(depth, p);
        }
      of_face.clear();
      const auto add = [&](const std::array<double, 3>& a, const std::array<double, 3>& b,
                           const std::array<double, 3>& c) {
        of_triangle.clear();
        clipper({a, b, c}, [&](const std::array<int, 3>& cell, const RL::Fragment&) {
          of_triangle.push_back(RL::morton_key(cell));
        });
        double extent = 0;
        std::array<double, 3> u, v;
        for(int axis = 0; axis < 3; ++axis) {
          const auto range = std::minmax({a[axis], b[axis], c[axis]});
          extent += range.second - range.first;
          u[axis] = b[axis] - a[axis];
          v[axis] = c[axis] - a[axis];
        }
        const double area = std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                       u[0] * v[1] - u[1] * v[0]) /
                            2;
        const double weight = 1 + 1.5 * area + extent + fragments_of_cell_area * area;
        for(std::uint64_t key : of_triangle) {
          of_face.push_back(key);
          ++part.fragments[key >> shift];
          part.weights[key >> shift] += weight / static_cast<double>(of_triangle.size());
        }
      };
      for(std::uint32_t j = 0; j < n; ++j)
        for(std::uint32_t i = 0; i + j < n; ++i) {
          add(corners[place(i, j)], corners[place(i + 1, j)], corners[place(i, j + 1)]);
          if(i + j + 2 <= n)
            add(corners[place(i + 1, j)], corners[place(i + 1, j + 1)], corners[place(i, j + 1)]);
        }
      sort_unique(of_face);
      part.keys.insert(part.keys.end(), of_face.begin(), of_face.end());
    }
    sort_unique(part.keys);
  };
  std::vector<std::thread> pool;
  for(std::size_t thread = 0; thread < parts.size(); ++thread)
    pool.emplace_back(work, thread);
  for(std::thread& thread : pool)
    thread.join();
  result.weights.resize(number_of_ranges);
  result.fragments.resize(number_of_ranges);
  for(Part& part : parts) {
    Keys merged;
    std::set_union(result.keys.begin(), result.keys.end(), part.keys.begin(), part.keys.end(),
                   std::back_inserter(merged));
    result.keys = std::move(merged);
    Keys().swap(part.keys);
    for(std::size_t i = 0; i < number_of_ranges; ++i) {
      result.weights[i] += part.weights[i];
      result.fragments[i] += part.fragments[i];
    }
  }
  result.triangles = static_cast<double>(surface.number_of_faces()) * n * n;
  return result;
}

// what ranks have and send on one level
struct Counts {
  Counts(std::size_t ranks, std::size_t colors)
    : owned(ranks), ghosts(ranks), relaxed(colors, std::vector<double>(ranks)), messages(relaxed),
      bytes(relaxed), neighbors(ranks), to_neighbors(ranks) {}

  std::vector<double> owned, ghosts;
  // by color and rank
  std::vector<std::vector<double>> relaxed, messages, bytes;
  // of what is owned: ranks that know some of it, and how much they know
  std::vector<double> neighbors, to_neighbors;
};

// The cells of a window around a cell of the level of the ranges, with what is known about each.
template <class T> class Window {
public:
  Window(int width, int halo) : m_halo(halo), m_size(width + 2 * halo) {
    m_values.resize(std::size_t(m_size) * m_size * m_size);
  }
  T& at(int x, int y, int z) {
    return m_values[(std::size_t(z + m_halo) * m_size + (y + m_halo)) * m_size + (x + m_halo)];
  }
  void clear() { std::fill(m_values.begin(), m_values.end(), T(0)); }
  // each becomes the union of those that are at most `radius` away along each axis
  void dilate(int radius, std::vector<T>& other) {
    const std::ptrdiff_t strides[3] = {1, m_size, std::ptrdiff_t(m_size) * m_size};
    for(std::ptrdiff_t stride : strides) {
      other = m_values;
      const auto n = static_cast<std::ptrdiff_t>(m_values.size());
      for(int r = 1; r <= radius; ++r) {
        const std::ptrdiff_t d = r * stride;
        for(std::ptrdiff_t i = 0; i + d < n; ++i)
          m_values[i] |= other[i + d];
        for(std::ptrdiff_t i = d; i < n; ++i)
          m_values[i] |= other[i - d];
      }
    }
  }

private:
  int m_halo, m_size;
  std::vector<T> m_values;
};

Counts count(const Keys& keys, int level, int range_level, const RL::Rank_ranges& ranges) {
  constexpr int halo = 4;
  const int width = 1 << (level - range_level), side = 1 << range_level;
  const int log_width = std::max(std::min(level - 1 - range_level, 3), 0),
            period = log_width > 0 ? 2 : 3;
  Counts result(ranges.size(), static_cast<std::size_t>(period * period * period));
  const int shift = 3 * (level - range_level);
  const std::size_t number_of_ranges = std::size_t(1) << 3 * range_level;
  // first key of each cell of the level of the ranges; cells with elements; owners
  std::vector<std::size_t> first(number_of_ranges + 1, keys.size());
  for(std::size_t i = keys.size(); i > 0; --i)
    first[keys[i - 1] >> shift] = i - 1;
  for(std::size_t i = number_of_ranges; i > 0; --i)
    first[i - 1] = std::min(first[i - 1], first[i]);
  std::vector<std::uint32_t> owner(number_of_ranges);
  for(std::size_t rank = 0; rank < ranges.size(); ++rank) {
    const auto [begin, end] = ranges.cells(rank, range_level);
    std::fill(owner.begin() + static_cast<std::ptrdiff_t>(begin),
              owner.begin() + static_cast<std::ptrdiff_t>(end), static_cast<std::uint32_t>(rank));
  }
  Window<std::uint8_t> is_there(width, halo), has_element(width, halo);
  Window<std::uint64_t> owners(width, halo), knows(width, halo), near(width, halo);
  std::vector<std::uint8_t> other;
  std::vector<std::uint64_t> other_sets;
  Keys sent, told; // (from, to, color)
  std::vector<std::uint32_t> local;
  const int reach = (halo + width - 1) / width;
  for(std::size_t cell = 0; cell < number_of_ranges; ++cell) {
    const std::array<int, 3> index = RL::morton_index(cell);
    const auto for_each_near = [&](int distance, auto&& visit) {
      std::array<int, 3> i;
      for(i[2] = std::max(index[2] - distance, 0); i[2] <= std::min(index[2] + distance, side - 1);
          ++i[2])
        for(i[1] = std::max(index[1] - distance, 0);
            i[1] <= std::min(index[1] + distance, side - 1); ++i[1])
          for(i[0] = std::max(index[0] - distance, 0);
              i[0] <= std::min(index[0] + distance, side - 1); ++i[0])
            visit(i, RL::morton_key(i));
    };
    bool is_empty = true;
    for_each_near(1, [&](const auto&, std::uint64_t k) { is_empty &= first[k] == first[k + 1]; });
    if(is_empty)
      continue;
    is_there.clear();
    local.clear();
    for_each_near(reach, [&](const std::array<int, 3>&, std::uint64_t k) {
      local.push_back(owner[k]);
      for(std::size_t i = first[k]; i < first[k + 1]; ++i) {
        std::array<int, 3> c = RL::morton_index(keys[i]);
        bool is_inside = true;
        for(int axis = 0; axis < 3; ++axis) {
          c[axis] -= index[axis] * width;
          is_inside &= c[axis] >= -halo && c[axis] < width + halo;
        }
        if(is_inside)
          is_there.at(c[0], c[1], c[2]) = 1;
      }
    });
    std::sort(local.begin(), local.end());
    local.erase(std::unique(local.begin(), local.end()), local.end());
    if(local.size() > 64)
      throw std::runtime_error("more than 64 ranks are near to a cell");
    const auto number_of = [&](std::uint32_t rank) {
      return static_cast<int>(std::lower_bound(local.begin(), local.end(), rank) - local.begin());
    };
    has_element = is_there;
    has_element.dilate(1, other);
    const bool is_shared = local.size() > 1;
    if(is_shared) {
      // who owns a center; who has a sheet at most 2 cells away, or a center one cell away
      owners.clear();
      near.clear();
      for_each_near(reach, [&](const std::array<int, 3>& i, std::uint64_t k) {
        const std::uint64_t bit = std::uint64_t(1) << number_of(owner[k]);
        std::array<int, 3> low, high, c;
        for(int axis = 0; axis < 3; ++axis) {
          low[axis] = std::max((i[axis] - index[axis]) * width, -halo);
          high[axis] = std::min((i[axis] - index[axis] + 1) * width, width + halo);
        }
        for(c[2] = low[2]; c[2] < high[2]; ++c[2])
          for(c[1] = low[1]; c[1] < high[1]; ++c[1])
            for(c[0] = low[0]; c[0] < high[0]; ++c[0]) {
              owners.at(c[0], c[1], c[2]) = bit;
              near.at(c[0], c[1], c[2]) = is_there.at(c[0], c[1], c[2]) ? bit : 0;
            }
      });
      near.dilate(2, other_sets);
      knows = owners;
      knows.dilate(1, other_sets);
      for(int z = -halo; z < width + halo; ++z)
        for(int y = -halo; y < width + halo; ++y)
          for(int x = -halo; x < width + halo; ++x)
            knows.at(x, y, z) =
                is_there.at(x, y, z) ? knows.at(x, y, z) | near.at(x, y, z) : std::uint64_t(0);
      knows.dilate(1, other_sets);
    }
    const std::uint32_t me = owner[cell];
    const std::uint64_t my_bit = std::uint64_t(1) << number_of(me);
    const auto for_each_rank = [&](std::uint64_t set, auto&& visit) {
      for(; set != 0; set &= set - 1) {
        int bit = 0;
        while(!(set >> bit & 1))
          ++bit;
        visit(local[static_cast<std::size_t>(bit)]);
      }
    };
    for(int z = 0; z < width; ++z)
      for(int y = 0; y < width; ++y)
        for(int x = 0; x < width; ++x) {
          if(!has_element.at(x, y, z))
            continue;
          ++result.owned[me];
          const std::uint64_t all = is_shared ? knows.at(x, y, z) | my_bit : my_bit;
          for_each_rank(all & ~my_bit, [&](std::uint32_t rank) {
            ++result.ghosts[rank];
            ++result.to_neighbors[me];
            told.push_back(std::uint64_t(me) << 32 | rank);
          });
          // the patches that it is in: cells of the next coarser level with a sheet beside it
          std::array<std::pair<std::uint32_t, std::uint32_t>, 8> relaxed_by; // color, rank
          std::size_t number = 0;
          for(int corner = 0; corner < 8; ++corner) {
            std::array<int, 3> parent, from, to;
            const std::array<int, 3> at = {x, y, z};
            for(int axis = 0; axis < 3; ++axis) {
              const int global = at[axis] + index[axis] * width, low = (global - 1) >> 1,
                        high = (global + 1) >> 1;
              parent[axis] = (corner >> axis & 1) ? high : low;
              if((corner >> axis & 1) && high == low)
                parent[axis] = -1; // only once
              from[axis] = std::max(2 * parent[axis], global - 1) - index[axis] * width;
              to[axis] = std::min(2 * parent[axis] + 1, global + 1) - index[axis] * width;
            }
            bool has_sheet = false;
            if(parent[0] >= 0 && parent[1] >= 0 && parent[2] >= 0)
              for(int c = from[2]; c <= to[2]; ++c)
                for(int b = from[1]; b <= to[1]; ++b)
                  for(int a = from[0]; a <= to[0]; ++a)
                    has_sheet = has_sheet || is_there.at(a, b, c);
            if(!has_sheet)
              continue;
            std::uint32_t color = 0;
            std::array<int, 3> of_range;
            for(int axis = 2; axis >= 0; --axis) {
              color = static_cast<std::uint32_t>(period) * color +
                      static_cast<std::uint32_t>((parent[axis] >> log_width) % period);
              of_range[axis] = 2 * parent[axis] / width;
            }
            const std::uint32_t by = owner[RL::morton_key(of_range)];
            ++result.relaxed[color][by];
            const auto pair = std::make_pair(color, by);
            if(std::find(relaxed_by.begin(), relaxed_by.begin() + number, pair) ==
               relaxed_by.begin() + number)
              relaxed_by[number++] = pair;
          }
          if(!is_shared)
            continue;
          for(std::size_t i = 0; i < number; ++i) {
            const std::uint32_t color = relaxed_by[i].first, by = relaxed_by[i].second;
            for_each_rank(all & ~(std::uint64_t(1) << number_of(by)), [&](std::uint32_t rank) {
              result.bytes[color][by] += sizeof(float);
              sent.push_back((std::uint64_t(by) << 32 | rank) << 5 | color);
            });
          }
        }
    if(sent.size() > 10000000)
      sort_unique(sent);
    if(told.size() > 10000000)
      sort_unique(told);
  }
  sort_unique(sent);
  sort_unique(told);
  for(std::uint64_t message : sent)
    ++result.messages[message & 31][message >> 37];
  for(std::uint64_t message : told)
    ++result.neighbors[message >> 32];
  return result;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for(double x : values)
    sum += x;
  return sum / static_cast<double>(values.size());
}
double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

struct Model {
  double rate = 80, latency = 2, bandwidth = 10; // ns, us, GB/s
};

void study(const Cells& cells, std::size_t number_of_ranks, const Model& model) {
  const RL::Rank_ranges ranges(cells.range_level, cells.weights, number_of_ranks);
  std::vector<double> work(number_of_ranks), ghosts(work), messages(work), kilobytes(work),
      fragments(work), unknowns;
  double seconds = 0, of_one = 0, gathered = 0;
  const double latency = 1e-6 * model.latency, bandwidth = 1e9 * model.bandwidth,
               rate = 1e-9 * model.rate;
  const double sum_over_ranks =
      2 * latency * std::ceil(std::log2(static_cast<double>(number_of_ranks)));
  Keys keys = cells.keys;
  for(int level = cells.depth; level >= cells.range_level; --level) {
    const Counts counts = count(keys, level, cells.range_level, ranges);
    if(level == cells.depth)
      unknowns = counts.owned;
    for(std::size_t color = 0; color < counts.relaxed.size(); ++color) {
      double slowest = 0;
      for(std::size_t rank = 0; rank < number_of_ranks; ++rank) {
        work[rank] += 2 * counts.relaxed[color][rank];
        messages[rank] += 2 * counts.messages[color][rank];
        kilobytes[rank] += 2e-3 * counts.bytes[color][rank];
        slowest = std::max(slowest, rate * counts.relaxed[color][rank] +
                                        latency * counts.messages[color][rank] +
                                        counts.bytes[color][rank] / bandwidth);
        of_one += 2 * rate * counts.relaxed[color][rank];
      }
      seconds += 2 * slowest;
    }
    // right-hand sides and first values of the sweeps, in single precision; then prolongation and
    // restriction, to and from the next finer level
    constexpr double times = 3;
    const double of_transfers = level < cells.depth ? 2 : 0;
    double slowest = 0;
    for(std::size_t rank = 0; rank < number_of_ranks; ++rank) {
      const double number = (times + of_transfers) * counts.neighbors[rank],
                   bytes = (times * sizeof(float) + of_transfers * sizeof(double)) *
                           counts.to_neighbors[rank];
      ghosts[rank] += counts.ghosts[rank];
      messages[rank] += number;
      kilobytes[rank] += 1e-3 * bytes;
      slowest = std::max(slowest, latency * number + bytes / bandwidth);
    }
    seconds += slowest + 2 * sum_over_ranks;
    for(std::uint64_t& key : keys)
      key >>= 3;
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  }
  for(std::size_t rank = 0; rank < number_of_ranks; ++rank) {
    const auto [begin, end] = ranges.cells(rank, cells.range_level);
    for(std::uint64_t cell = begin; cell < end; ++cell)
      fragments[rank] += cells.fragments[cell];
  }
  // Levels that all ranks hold: three unknowns for each cell, each in about four patches, which are
  // relaxed twice; and each level has about a quarter of the unknowns of the next finer one.
  // Conjugate gradients sum twice.
  gathered = 2 * rate * 4 * 3 * static_cast<double>(keys.size()) * (4. / 3);
  seconds += gathered + 2 * sum_over_ranks;
  of_one += gathered;
  std::printf("%6zu %6.3f %6.3f %6.3f %10.0f %10.0f %9.0f %9.0f %8.0f %8.0f %8.0f %8.0f %9.2f "
              "%8.2f %5.3f\n",
              number_of_ranks, largest(work) / mean(work), largest(unknowns) / mean(unknowns),
              largest(fragments) / mean(fragments), mean(unknowns), mean(work), mean(ghosts),
              largest(ghosts), mean(messages), largest(messages), mean(kilobytes),
              largest(kilobytes), 1e3 * seconds, 1e3 * gathered,
              of_one / (static_cast<double>(number_of_ranks) * seconds));
  std::fflush(stdout);
}

} // namespace

int main(int argc, char* argv[]) {
  return run_benchmark("partition_study", [&] {
    std::vector<std::size_t> ranks = {16, 64, 256, 1024, 4096};
    int depth = 12, threads = 2;
    std::uint32_t n = 1;
    Model model;
    std::string mesh;
    Command_line line("usage: partition_study [OPTION]... MESH N");
    line.add("depth", depth);
    line.add("ranks", ranks);
    line.add("threads", threads);
    line.add("rate", model.rate);
    line.add("latency", model.latency);
    line.add("bandwidth", model.bandwidth);
    line.add("mesh", mesh);
    line.add("n", n);
    line.add_positional("mesh", 1);
    line.add_positional("n", 1);
    if(!line.read(argc, argv))
      return 0;
    line.require("mesh");
    line.require("n");

    const auto flat = find_mesh(mesh);
    if(!flat)
      return 1;
    print_header(argc, argv);
    const RL::Triangulated_surface_3 curved = n > 1 ? RL::curved_surface(*flat) : *flat;
    std::optional<Refined_mesh> refined;
    if(n > 1)
      refined.emplace(curved, n);
    const Cells cells = cells_of(curved, refined ? &*refined : nullptr, n, depth, threads);
    double fragments = 0;
    for(std::uint32_t number : cells.fragments)
      fragments += number;
    std::printf("# %.0f triangles, %zu cells of level %d with %.0f fragments, ranges of level %d\n",
                cells.triangles, cells.keys.size(), depth, fragments, cells.range_level);
    std::printf("# model: %g ns an unknown of a patch, latency %g us, %g GB/s\n", model.rate,
                model.latency, model.bandwidth);
    std::printf("# ranks   work unkns  fragm   unknowns    relaxed    ghosts  most_gh. messages "
                "most_me.       kB  most_kB  cycle_ms  held_ms effic\n");
    for(std::size_t number : ranks)
      study(cells, number, model);
    return 0;
  });
}
