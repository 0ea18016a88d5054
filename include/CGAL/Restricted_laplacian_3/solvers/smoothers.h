// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SMOOTHERS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SMOOTHERS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_lists.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/solvers/Level_vectors.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Cluster_matrix.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Symmetric_inverse.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/block_kernels.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/renumbering.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Solvers
/// Sets of unknowns of one level that are relaxed together, in the order in which this is done.
///
/// Patches that follow each other form a *group*, groups that follow each other a *colour*. No
/// unknown of a patch is coupled with one of a patch in another group of the same colour, so groups
/// of a colour can be relaxed at the same time, with the same result.
struct Smoothing_patches {
  /// the unknowns of each patch
  internal::Number_lists unknowns;
  /// how many patches there are
  std::size_t number_of_patches = 0;
  /// first patch of each group, and one more
  std::vector<std::uint32_t> groups = {0};
  /// first group of each colour, and one more
  std::vector<std::uint32_t> colors = {0};
  /// For each unknown the number of a neighbourhood; unknowns of one are stored together,
  /// neighbourhoods by their numbers. It has no influence on results beyond rounding. May be empty.
  std::vector<std::uint64_t> neighborhoods;
};

/// \ingroup PkgRestrictedLaplacian3Solvers
/// Powers of two \f$d_i\f$ with \f$1/2 \le d_i^2 A_{ii} \le 2\f$; 1 where the diagonal entry is not
/// positive. \f$D A D\f$ fits into single precision, also where elements hardly reach the surface.
inline std::vector<double> balancing_scale(const Eigen::SparseMatrix<double>& a) {
  const Eigen::VectorXd diagonal = a.diagonal();
  const double largest = diagonal.size() > 0 ? diagonal.maxCoeff() : 0;
  std::vector<double> scale(diagonal.size(), 1.);
  for(Eigen::Index i = 0; i < diagonal.size(); ++i)
    // What is smaller than this has no significant digit left beside the large entries.
    if(diagonal[i] > 1e-30 * largest)
      scale[i] = std::ldexp(1., -static_cast<int>(std::lround(std::log2(diagonal[i]) / 2)));
  return scale;
}

namespace internal {

/// What smoothers that relax groups of unknowns one after the other have in common.
/// \tparam Derived has `residual()`, and `relax_group()`, which relaxes a group in order or in
/// reverse
template <class Derived> class Group_smoother {
public:
  /// where unknowns are in the vectors of this level
  const Level_positions& positions() const { return m_positions; }
  /// the vectors of this level belong to \f$D A D\f$ with this diagonal matrix
  const std::vector<double>& scale() const { return m_scale; }

  /// starts from \f$x = 0\f$; on return \f$r = b - A x\f$
  template <int K>
  void pre_smooth(const Level_vectors<K>& b, Level_vectors<K>& x, Level_vectors<K>& r,
                  int steps) const {
    x.set_zero(m_positions.number_of_positions);
    for(int step = 0; step < steps; ++step)
      sweep<K>(b, x, false);
    derived().template residual<K>(b, x, r);
  }

  /// makes the transposes of the steps of `pre_smooth()`, from the given `x`
  template <int K>
  void post_smooth(const Level_vectors<K>& b, Level_vectors<K>& x, int steps) const {
    for(int step = 0; step < steps; ++step)
      sweep<K>(b, x, true);
  }

protected:
  Group_smoother(const Eigen::SparseMatrix<double>& a, std::vector<std::uint32_t> colors,
                 bool is_parallel)
    : m_is_parallel(is_parallel), m_scale(balancing_scale(a)), m_colors(std::move(colors)) {}

  bool m_is_parallel;
  std::vector<double> m_scale;
  Level_positions m_positions;
  std::vector<std::uint32_t> m_colors; // first group of each, and one more

private:
  const Derived& derived() const { return static_cast<const Derived&>(*this); }

  /// relaxes the groups of all colours, in order or in reverse
  template <int K>
  void sweep(const Level_vectors<K>& b, Level_vectors<K>& x, bool is_reversed) const {
    const std::size_t number_of_colors = m_colors.size() - 1;
    for(std::size_t i = 0; i < number_of_colors; ++i) {
      const std::size_t color = is_reversed ? number_of_colors - 1 - i : i;
      parallel_for(m_is_parallel, m_colors[color], m_colors[color + 1], 1,
                   [&](std::size_t group, std::size_t) {
                     derived().template relax_group<K>(group, b, x, is_reversed);
                   });
    }
  }
};

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Solvers
/// Point Gauss-Seidel, in single precision. Unknowns are relaxed group by group (see
/// `Smoothing_patches`), and in a group by decreasing octave of the diagonal entry, see
/// `internal::order_by_octave_of_diagonal()`; in reverse after the coarse correction, which makes a
/// cycle a symmetric operator. A row whose diagonal entry is not positive is left out: its unknown
/// stays 0.
///
/// One sweep takes one pass over the matrix.
///
/// \cgalModels `MultigridSmoother_3`
class Gauss_seidel_smoother : public internal::Group_smoother<Gauss_seidel_smoother> {
public:
  /// \param a the matrix, see `MultigridSmoother_3`
  /// \param patches unknowns of a group are relaxed one after the other, groups of a colour at the
  /// same time; there may be none
  /// \param is_parallel whether several threads are used; results do not depend on that
  /// \param matrix_is_read called when `a` is no longer read
  Gauss_seidel_smoother(const Eigen::SparseMatrix<double>& a, const Smoothing_patches& patches,
                        bool is_parallel = false, const std::function<void()>& matrix_is_read = {})
    : Group_smoother(a, patches.colors, is_parallel) {
    const std::size_t n = static_cast<std::size_t>(a.cols());
    const std::vector<int> by_octave = internal::order_by_octave_of_diagonal(a);
    const std::vector<int> rank = internal::ranks(by_octave);
    // Each unknown belongs to the first group that has it, the others to one more group at the end.
    std::vector<char> is_placed(n, 0);
    std::vector<int> order;
    order.reserve(n);
    m_groups.push_back(0);
    for(std::size_t group = 0; group + 1 < patches.groups.size(); ++group) {
      for(std::uint32_t p = patches.groups[group]; p < patches.groups[group + 1]; ++p)
        for(std::uint32_t i : patches.unknowns[p])
          if(!is_placed[i]) {
            is_placed[i] = 1;
            order.push_back(static_cast<int>(i));
          }
      std::sort(order.begin() + m_groups.back(), order.end(),
                [&rank](int i, int j) { return rank[i] < rank[j]; });
      m_groups.push_back(static_cast<std::uint32_t>(order.size()));
    }
    if(order.size() < n) {
      for(int i : by_octave)
        if(!is_placed[i])
          order.push_back(i);
      m_groups.push_back(static_cast<std::uint32_t>(n));
      m_colors.push_back(static_cast<std::uint32_t>(m_groups.size() - 1));
    }
    m_positions = Level_positions::consecutive(n);
    for(std::size_t i = 0; i < n; ++i)
      m_positions.of_unknown[order[i]] = static_cast<std::uint32_t>(i);
    m_matrix = Level_matrix::of(a, m_positions, m_scale, m_positions, m_scale);
    m_inverse_diagonal.assign(n, 0.f);
    for(std::size_t i = 0; i < n; ++i) {
      const double diagonal = a.coeff(order[i], order[i]) * m_scale[order[i]] * m_scale[order[i]];
      if(diagonal > std::numeric_limits<float>::epsilon())
        m_inverse_diagonal[i] = static_cast<float>(1 / diagonal);
    }
    if(matrix_is_read)
      matrix_is_read();
  }

  /// \f$r = b - A x\f$
  template <int K>
  void residual(const Level_vectors<K>& b, const Level_vectors<K>& x, Level_vectors<K>& r) const {
    m_matrix.template multiply<K, false>(m_is_parallel, x, r);
    for(std::size_t i = 0; i < r.size(); ++i)
      r.data()[i] = b.data()[i] - r.data()[i];
  }

private:
  friend class internal::Group_smoother<Gauss_seidel_smoother>;

  template <int K>
  void relax_group(std::size_t group, const Level_vectors<K>& b, Level_vectors<K>& x,
                   bool is_reversed) const {
    const std::uint32_t begin = m_groups[group], end = m_groups[group + 1];
    for(std::uint32_t k = 0; k < end - begin; ++k) {
      const std::size_t i = is_reversed ? end - 1 - k : begin + k;
      const float* const load = b.position(i);
      float* const value = x.position(i);
      float residual[K];
      std::copy(load, load + K, residual);
      m_matrix.template add_row_product<K>(i, -1, x, residual);
      for(int c = 0; c < K; ++c)
        value[c] += residual[c] * m_inverse_diagonal[i];
    }
  }

  std::vector<std::uint32_t> m_groups;
  Level_matrix m_matrix;
  std::vector<float> m_inverse_diagonal;
};

/// \ingroup PkgRestrictedLaplacian3Solvers
/// Overlapping multiplicative Schwarz: the unknowns of each patch in turn are set to the solution
/// of their equations, the others fixed; in reverse order after the coarse correction, which makes
/// a cycle a symmetric operator.
///
/// Restricted splines are nearly dependent, which is why point Gauss-Seidel stalls; but a
/// combination that nearly vanishes on the surface does so on a few cells, and a patch that
/// contains its elements removes it at once. The usual patches are those of `smoothing_patches()`.
///
/// In single precision, with the inverses of the blocks stored: about 600 bytes an unknown for the
/// matrix and 500 for the inverses.
///
/// \cgalModels `MultigridSmoother_3`
class Patch_smoother : public internal::Group_smoother<Patch_smoother> {
public:
  /// Added to the diagonals, which are near 1, before a block is inverted: well above the rounding
  /// errors of single precision, times the number of entries in a row. Without it a combination of
  /// elements whose energy is only rounding error would be amplified by the inverse of that error.
  /// With it the inverse is never too large, so the smoother converges for any matrix.
  static constexpr double relative_regularization = 1e-5;

  /// \param a the matrix, see `MultigridSmoother_3`
  /// \param patches what is relaxed together
  /// \param is_parallel whether several threads are used; results do not depend on that
  /// \param matrix_is_read called when `a` is no longer read, before the inverses are computed
  Patch_smoother(const Eigen::SparseMatrix<double>& a, const Smoothing_patches& patches,
                 bool is_parallel = false, const std::function<void()>& matrix_is_read = {})
    : Group_smoother(a, patches.colors, is_parallel), m_groups(patches.groups) {
    find_clusters(static_cast<std::size_t>(a.cols()), patches);
    find_parts(patches);
    m_matrix = internal::Cluster_matrix(is_parallel, a, m_positions, m_scale);
    if(matrix_is_read)
      matrix_is_read();
    m_inverses.resize(m_patches.back().inverse);
    invert_blocks();
  }

  /// \f$r = b - A x\f$
  template <int K>
  void residual(const Level_vectors<K>& b, const Level_vectors<K>& x, Level_vectors<K>& r) const {
    m_matrix.template residual<K>(m_is_parallel, b, x, r);
  }

private:
  friend class internal::Group_smoother<Patch_smoother>;

  struct Patch {
    std::uint32_t first_part;
    std::uint32_t size;  // number of unknowns
    std::size_t inverse; // place in m_inverses
  };

  /// what a patch has of a cluster
  struct Part {
    std::uint32_t cluster;
    std::uint32_t mask;
  };

  static int rounded_up(int size, int multiple) {
    return (size + multiple - 1) / multiple * multiple;
  }

  /// Unknowns of a neighbourhood go into the same cluster, those of one patch first if they are
  /// more than eight.
  void find_clusters(std::size_t n, const Smoothing_patches& patches) {
    constexpr std::size_t lanes = internal::lanes_of_floats;
    std::vector<std::uint32_t> last_patch(n, 0);
    for(std::size_t p = 0; p < patches.number_of_patches; ++p)
      for(std::uint32_t i : patches.unknowns[p])
        last_patch[i] = static_cast<std::uint32_t>(p);
    struct Place {
      std::uint64_t neighborhood;
      std::uint32_t patch, unknown;
    };
    std::vector<Place> places(n);
    for(std::size_t i = 0; i < n; ++i)
      places[i] = {patches.neighborhoods.empty() ? 0 : patches.neighborhoods[i],
                   patches.neighborhoods.empty() ? 0 : last_patch[i],
                   static_cast<std::uint32_t>(i)};
    std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
      return std::tie(a.neighborhood, a.patch, a.unknown) <
             std::tie(b.neighborhood, b.patch, b.unknown);
    });

    m_positions.of_unknown.resize(n);
    std::size_t position = 0;
    for(std::size_t begin = 0, end = 0; begin < n; begin = end) {
      while(end < n && places[end].neighborhood == places[begin].neighborhood &&
            places[end].patch == places[begin].patch)
        ++end;
      const bool is_new = begin > 0 && places[begin].neighborhood != places[begin - 1].neighborhood;
      const std::size_t left = (lanes - position % lanes) % lanes;
      if(is_new || end - begin > left)
        position += left;
      for(std::size_t i = begin; i < end; ++i)
        m_positions.of_unknown[places[i].unknown] = static_cast<std::uint32_t>(position++);
    }
    m_positions.number_of_positions = (position + lanes - 1) / lanes * lanes;
  }

  /// the clusters of each patch, and which of their unknowns belong to it
  void find_parts(const Smoothing_patches& patches) {
    m_patches.reserve(patches.number_of_patches + 1);
    std::size_t inverse = 0;
    std::vector<std::uint32_t> sorted;
    for(std::size_t p = 0; p < patches.number_of_patches; ++p) {
      const int size = static_cast<int>(patches.unknowns[p].size());
      m_patches.push_back(
          {static_cast<std::uint32_t>(m_parts.size()), static_cast<std::uint32_t>(size), inverse});
      sorted.clear();
      for(std::uint32_t i : patches.unknowns[p])
        sorted.push_back(m_positions.of_unknown[i]);
      std::sort(sorted.begin(), sorted.end());
      for(std::uint32_t position : sorted) {
        const std::uint32_t cluster = position / internal::lanes_of_floats;
        if(m_parts.size() == m_patches.back().first_part || m_parts.back().cluster != cluster)
          m_parts.push_back({cluster, 0});
        m_parts.back().mask |= 1u << position % internal::lanes_of_floats;
      }
      m_largest_size = (std::max)(m_largest_size, size);
      const std::size_t blocks = static_cast<std::size_t>(rounded_up(size, 8) / 8);
      inverse += 64 * blocks * (blocks + 1) / 2;
    }
    m_patches.push_back({static_cast<std::uint32_t>(m_parts.size()), 0, inverse});
  }

  void invert_blocks() {
    constexpr std::size_t grain = 256;
    internal::parallel_for(
        m_is_parallel, 0, m_patches.size() - 1, grain, [&](std::size_t begin, std::size_t end) {
          internal::Symmetric_inverse invert;
          std::vector<double> block;
          // number of a position in the block of a patch
          std::vector<std::uint32_t> local(m_positions.number_of_positions, no_number);
          for(std::size_t p = begin; p < end; ++p) {
            const Patch& patch = m_patches[p];
            const int size = static_cast<int>(patch.size), stride = rounded_up(size, 8);
            extract(p, stride, local, block);
            for(int i = 0; i < size; ++i) {
              double& diagonal = block[static_cast<std::size_t>(stride) * i + i];
              // Where it is 0 the row is 0, and the unknown remains 0.
              diagonal = diagonal > 0 ? diagonal + relative_regularization : 0;
            }
            invert(block.data(), size, stride, relative_regularization / 2);
            pack(block, stride, m_inverses.data() + patch.inverse);
          }
        });
  }

  /// the lower triangle of a matrix, as `multiply_symmetric()` wants it
  static void pack(std::vector<double>& matrix, int stride, float* to) {
    const auto row = [&matrix, stride](int i) {
      return matrix.data() + static_cast<std::size_t>(stride) * i;
    };
    for(int first = 0; first < stride; first += 8) {
      for(int i = first; i < first + 8; ++i)
        for(int j = first; j < i; ++j)
          row(j)[i] = row(i)[j];
      for(int column = 0; column <= first; column += 8)
        for(int i = first; i < first + 8; ++i, to += 8)
          std::copy(row(i) + column, row(i) + column + 8, to);
    }
  }

  /// calls `visit(position)` for the positions of a part
  template <class Visitor> static void for_each_position(const Part& part, Visitor&& visit) {
    for(std::uint32_t lane = 0; lane < internal::lanes_of_floats; ++lane)
      if(part.mask >> lane & 1)
        visit(internal::lanes_of_floats * part.cluster + lane);
  }

  /// the lower triangle of the dense block of a patch, with as many rows as columns in memory
  void extract(std::size_t p, int stride, std::vector<std::uint32_t>& local,
               std::vector<double>& block) const {
    const std::uint32_t first = m_patches[p].first_part, last = m_patches[p + 1].first_part;
    block.assign(static_cast<std::size_t>(stride) * stride, 0.);
    std::uint32_t number = 0;
    for(std::uint32_t k = first; k < last; ++k)
      for_each_position(m_parts[k], [&](std::uint32_t position) { local[position] = number++; });
    for(std::uint32_t k = first; k < last; ++k) {
      const Part part = m_parts[k];
      m_matrix.for_each_column(part.cluster, [&](std::uint32_t column, const float* values) {
        if(local[column] == no_number)
          return;
        // The block is transposed, so that a row of the result is read from consecutive numbers.
        double* const to = block.data() + static_cast<std::size_t>(stride) * local[column];
        for_each_position(part, [&](std::uint32_t position) {
          to[local[position]] = values[position % internal::lanes_of_floats];
        });
      });
    }
    for(std::uint32_t k = first; k < last; ++k)
      for_each_position(m_parts[k], [&](std::uint32_t position) { local[position] = no_number; });
  }

  template <int K>
  void relax_group(std::size_t group, const Level_vectors<K>& b, Level_vectors<K>& x,
                   bool is_reversed) const {
    const std::size_t size = static_cast<std::size_t>(K) * rounded_up(m_largest_size, 8);
    internal::Aligned_floats residuals(size), update(size);
    const std::uint32_t begin = m_groups[group], end = m_groups[group + 1];
    for(std::uint32_t k = 0; k < end - begin; ++k)
      relax<K>(is_reversed ? end - 1 - k : begin + k, b, x, residuals.data(), update.data());
  }

  /// \param residuals,update room for `K` vectors
  template <int K>
  void relax(std::size_t p, const Level_vectors<K>& b, Level_vectors<K>& x, float* residuals,
             float* update) const {
    const Patch& patch = m_patches[p];
    const std::uint32_t first = patch.first_part, last = m_patches[p + 1].first_part;
    // residuals of the unknowns, one after the other
    float* place = residuals;
    for(std::uint32_t k = first; k < last; ++k) {
      const Part part = m_parts[k];
      float sum[internal::lanes_of_floats * K];
      std::copy(b.cluster(part.cluster), b.cluster(part.cluster) + internal::lanes_of_floats * K,
                sum);
      m_matrix.template subtract_rows<K>(part.cluster, x, sum);
      for(int lane = 0; lane < internal::lanes_of_floats; ++lane)
        if(part.mask >> lane & 1)
          place = std::copy(sum + K * lane, sum + K * lane + K, place);
    }
    const int blocks = rounded_up(static_cast<int>(patch.size), 8) / 8;
    std::fill(place, residuals + 8 * K * blocks, 0.f);
    internal::multiply_symmetric<K>(m_inverses.data() + patch.inverse, blocks, residuals, update);
    const float* from = update;
    for(std::uint32_t k = first; k < last; ++k)
      for_each_position(m_parts[k], [&](std::uint32_t position) {
        float* const value = x.position(position);
        for(int c = 0; c < K; ++c)
          value[c] += *from++;
      });
  }

  static constexpr std::uint32_t no_number = (std::numeric_limits<std::uint32_t>::max)();

  internal::Cluster_matrix m_matrix;
  std::vector<std::uint32_t> m_groups;
  std::vector<Patch> m_patches; // and one more
  std::vector<Part> m_parts;
  internal::Aligned_floats m_inverses;
  int m_largest_size = 0;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SMOOTHERS_H
