// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_DISTRIBUTED_SMOOTHER_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_DISTRIBUTED_SMOOTHER_H

#include <CGAL/Restricted_laplacian_3/distributed/Communicator.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_space.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Distributed_patches.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Distributed_rows.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Element_exchange.h>
#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/morton_key.h>
#include <CGAL/Restricted_laplacian_3/solvers/smoothers.h>
#include <CGAL/Restricted_laplacian_3/splines/shared/Element_numbering.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// `Patch_smoother` of a level whose unknowns are divided among ranks: the same patches in the same
/// order, whatever the number of ranks. Between two colors ranks tell each other what has changed.
///
/// A rank has the rows of the unknowns that it owns, and of those in its patches; with the columns
/// in which these have entries they are the unknowns that it knows.
class Distributed_smoother {
public:
  /// \param rows of the matrix, of the unknowns that this rank owns
  Distributed_smoother(const Distributed_space& space, int level, const Distributed_rows& rows)
    : m_communicator(space.communicator()) {
    const Distributed_level& of_level = space.level(level);
    const Distributed_patches patches = distributed_patches(space, level);
    const Element_exchange none(m_communicator, of_level.first_elements, {});
    // rows of others that are needed here
    std::vector<std::uint64_t> far;
    for(std::uint64_t unknown : patches.unknowns)
      if(!none.owns(unknown))
        far.push_back(unknown);
    make_unique(far);
    const Distributed_rows of_others = rows_of_others(m_communicator, none, rows, far);

    std::vector<std::uint64_t> known = far;
    for(std::size_t i = 0; i < rows.size(); ++i)
      known.push_back(none.first() + i);
    for(const Distributed_rows* r : {&rows, &of_others})
      for(PetscInt column : r->columns)
        if(!none.owns(static_cast<std::uint64_t>(column)))
          known.push_back(static_cast<std::uint64_t>(column));
    make_unique(known);
    const Element_exchange exchange(m_communicator, of_level.first_elements, known);
    m_own = exchange.known(static_cast<std::size_t>(m_communicator.rank()));
    const std::uint64_t first = none.first();
    // those that are owned are consecutive, and most of all
    const auto place = [&, first](std::uint64_t element) {
      return none.owns(element)
                 ? static_cast<std::uint32_t>(m_own[0] + (element - first))
                 : static_cast<std::uint32_t>(
                       std::lower_bound(known.begin(), known.end(), element) - known.begin());
    };

    // diagonals and centers of all that are known
    struct Element {
      double diagonal;
      std::uint64_t center;
    };
    std::vector<Element> own(rows.size());
    for(std::size_t i = 0; i < own.size(); ++i) {
      own[i] = {0, of_level.own_centers[i]};
      for(PetscInt k = rows.first[i]; k < rows.first[i + 1]; ++k)
        if(static_cast<std::uint64_t>(rows.columns[k]) == none.first() + i)
          own[i].diagonal = rows.values[k];
    }
    const std::vector<Element> elements = exchange.values(own);
    double largest = 0;
    for(const Element& element : own)
      largest = (std::max)(largest, element.diagonal);
    largest = m_communicator.maximum(largest);

    Smoothing_patches smoothing;
    set_patches(patches, place, smoothing);
    for(const Element& element : elements) {
      std::array<int, 3> corner = Element_numbering::center(level, element.center).index;
      for(int& x : corner)
        x = (x + 1) >> 1;
      smoothing.neighborhoods.push_back(morton_key(corner));
    }
    std::vector<double> diagonals;
    for(const Element& element : elements)
      diagonals.push_back(element.diagonal);
    m_smoother.emplace(upper_half(place, far, rows, of_others, diagonals, largest), smoothing,
                       space.part().options().is_parallel);
    set_lists(exchange, known, patches, place);
  }

  /// One sweep for `K` vectors, 1 or 8, in order or in reverse.
  /// \param b of the unknowns that this rank owns, vector by vector
  /// \param x the same; it is 0 at first if `is_zero`
  template <int K> void smooth(const double* b, double* x, bool is_reversed, bool is_zero) {
    const std::vector<double>& d = m_smoother->scale();
    const std::vector<std::uint32_t>& position = m_smoother->positions().of_unknown;
    const std::size_t size = m_own[1] - m_own[0];
    Vectors<K>& v = vectors<K>();
    v.units.assign(K, 0);
    for(std::size_t c = 0; c < K; ++c)
      for(std::size_t i = 0; i < size; ++i) {
        const double scale = d[m_own[0] + i];
        v.units[c] = (std::max)(v.units[c], std::abs(b[c * size + i] * scale));
        if(!is_zero)
          v.units[c] = (std::max)(v.units[c], std::abs(x[c * size + i] / scale));
      }
    m_communicator.maximum(v.units);
    for(double& unit : v.units)
      unit = unit > 0 ? std::ldexp(1., std::ilogb(unit)) : 1;
    v.b.set_zero(m_smoother->positions().number_of_positions);
    v.x.set_zero(m_smoother->positions().number_of_positions);
    for(std::size_t c = 0; c < K; ++c)
      for(std::size_t i = 0; i < size; ++i) {
        const std::size_t k = m_own[0] + i;
        v.b.position(position[k])[c] = static_cast<float>(b[c * size + i] * d[k] / v.units[c]);
        if(!is_zero)
          v.x.position(position[k])[c] = static_cast<float>(x[c * size + i] / d[k] / v.units[c]);
      }
    m_all->exchange<K>(v.b.data());
    if(!is_zero)
      m_all->exchange<K>(v.x.data());
    const std::size_t colors = m_smoother->number_of_colors();
    for(std::size_t k = 0; k < colors; ++k) {
      const std::size_t color = is_reversed ? colors - 1 - k : k;
      m_smoother->relax_color<K>(color, v.b, v.x, is_reversed);
      m_of_colors[color].exchange<K>(v.x.data());
    }
    for(std::size_t c = 0; c < K; ++c)
      for(std::size_t i = 0; i < size; ++i)
        x[c * size + i] = v.x.position(position[m_own[0] + i])[c] * d[m_own[0] + i] * v.units[c];
  }

  /// \f$b - A x\f$ of the last call of `smooth()` for as many vectors
  template <int K> void residual(double* r) {
    const std::vector<double>& d = m_smoother->scale();
    const std::vector<std::uint32_t>& position = m_smoother->positions().of_unknown;
    const std::size_t size = m_own[1] - m_own[0];
    Vectors<K>& v = vectors<K>();
    m_smoother->residual<K>(v.b, v.x, v.r);
    for(std::size_t c = 0; c < K; ++c)
      for(std::size_t i = 0; i < size; ++i)
        r[c * size + i] = v.r.position(position[m_own[0] + i])[c] / d[m_own[0] + i] * v.units[c];
  }

private:
  template <int K> struct Vectors {
    Level_vectors<K> b, x, r;
    std::vector<double> units; // powers of 2, about as large as the vectors
  };
  template <int K> Vectors<K>& vectors() { return std::get<Vectors<K>>(m_vectors); }

  static void make_unique(std::vector<std::uint64_t>& numbers) {
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  }

  template <class Place>
  static void set_patches(const Distributed_patches& from, Place&& place, Smoothing_patches& to) {
    to.number_of_patches = from.patches.size();
    std::vector<std::size_t> first(1, 0);
    std::vector<std::uint32_t> unknowns;
    to.groups.clear();
    to.colors.clear();
    std::uint32_t color = 0;
    const auto begin_colors_up_to = [&](std::uint32_t last) {
      for(; color <= last; ++color)
        to.colors.push_back(static_cast<std::uint32_t>(to.groups.size()));
    };
    for(std::size_t p = 0; p < from.patches.size(); ++p) {
      const Distributed_patches::Patch& patch = from.patches[p];
      begin_colors_up_to(patch.color);
      if(p == 0 || patch.block != from.patches[p - 1].block ||
         patch.color != from.patches[p - 1].color)
        to.groups.push_back(static_cast<std::uint32_t>(p));
      for(std::size_t k = patch.first; k < patch.last; ++k)
        unknowns.push_back(place(from.unknowns[k]));
      first.push_back(unknowns.size());
    }
    begin_colors_up_to(from.number_of_colors);
    to.groups.push_back(static_cast<std::uint32_t>(from.patches.size()));
    to.unknowns = Number_lists(std::move(first), std::move(unknowns));
  }

  /// The rows that this rank has, as a symmetric matrix of all that are known; of the others only
  /// the diagonals.
  template <class Place>
  Sparse_matrix upper_half(Place&& place, const std::vector<std::uint64_t>& far,
                           const Distributed_rows& rows, const Distributed_rows& of_others,
                           const std::vector<double>& diagonals, double largest) const {
    const std::size_t n = diagonals.size();
    std::vector<char> has_row(n, 0);
    std::fill(has_row.begin() + static_cast<std::ptrdiff_t>(m_own[0]),
              has_row.begin() + static_cast<std::ptrdiff_t>(m_own[1]), 1);
    for(std::uint64_t element : far)
      has_row[place(element)] = 1;
    // Calls visit(row, column, value) for what is stored, once for each; rows ascend.
    const auto for_each = [&](auto&& visit) {
      const auto of_row = [&](std::size_t i, const Distributed_rows& from, std::size_t k) {
        for(PetscInt e = from.first[k]; e < from.first[k + 1]; ++e) {
          const std::size_t j = place(static_cast<std::uint64_t>(from.columns[e]));
          if(j > i || (j < i && !has_row[j]))
            visit((std::min)(i, j), (std::max)(i, j), from.values[e]);
        }
      };
      std::size_t k = 0;
      for(; k < far.size() && place(far[k]) < m_own[0]; ++k)
        of_row(place(far[k]), of_others, k);
      for(std::size_t i = 0; i < rows.size(); ++i)
        of_row(m_own[0] + i, rows, i);
      for(; k < far.size(); ++k)
        of_row(place(far[k]), of_others, k);
    };
    std::vector<int> next(n + 1, 0);
    for_each([&](std::size_t, std::size_t j, double) { ++next[j + 1]; });
    Sparse_matrix result(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
    int* const first = result.outerIndexPtr();
    for(std::size_t j = 0; j < n; ++j) {
      first[j + 1] = first[j] + next[j + 1] + 1; // with the diagonal
      next[j] = first[j];
    }
    result.resizeNonZeros(first[n]);
    int* const inner = result.innerIndexPtr();
    double* const values = result.valuePtr();
    for_each([&](std::size_t i, std::size_t j, double value) {
      inner[next[j]] = static_cast<int>(i);
      values[next[j]++] = value;
    });
    std::vector<std::pair<int, double>> column;
    for(std::size_t j = 0; j < n; ++j) {
      // Rows that are not here come late.
      if(!std::is_sorted(inner + first[j], inner + next[j])) {
        column.clear();
        for(int k = first[j]; k < next[j]; ++k)
          column.emplace_back(inner[k], values[k]);
        std::sort(column.begin(), column.end());
        for(int k = first[j]; k < next[j]; ++k)
          std::tie(inner[k], values[k]) = column[static_cast<std::size_t>(k - first[j])];
      }
      // the scale of an unknown is the same on all ranks
      inner[next[j]] = static_cast<int>(j);
      values[next[j]] = (std::max)(diagonals[j], 1e-30 * largest);
    }
    return result;
  }

  /// Who must learn what: the ranks that know an unknown, from the one that owns it or has relaxed
  /// it.
  template <class Place>
  void set_lists(const Element_exchange& exchange, const std::vector<std::uint64_t>& known,
                 const Distributed_patches& patches, Place&& place) {
    const std::vector<std::uint32_t>& position = m_smoother->positions().of_unknown;
    const auto ranks = static_cast<std::size_t>(m_communicator.size()),
               me = static_cast<std::size_t>(m_communicator.rank());
    std::vector<std::vector<std::uint32_t>> sent(ranks), received(ranks);
    std::vector<std::vector<std::uint32_t>> known_by(exchange.own_size());
    for(std::size_t rank = 0; rank < ranks; ++rank) {
      if(rank != me)
        for(std::size_t i = exchange.known(rank)[0]; i < exchange.known(rank)[1]; ++i)
          received[rank].push_back(position[i]);
      for(std::uint32_t i : exchange.known_by(rank)) {
        if(rank != me)
          sent[rank].push_back(position[m_own[0] + i]);
        known_by[i].push_back(static_cast<std::uint32_t>(rank));
      }
    }
    m_all.emplace(m_communicator, sent, received);

    // The owner tells each rank who else knows an unknown.
    struct Holder {
      std::uint64_t element, rank;
    };
    std::vector<std::vector<Holder>> lists(ranks);
    for(std::size_t rank = 0; rank < ranks; ++rank)
      for(std::uint32_t i : exchange.known_by(rank))
        for(std::uint32_t other : known_by[i])
          if(other != rank)
            lists[rank].push_back({exchange.first() + i, other});
    std::vector<std::vector<std::uint32_t>> holders(known.size());
    for(const auto& list : m_communicator.exchange(lists))
      for(const Holder& holder : list)
        holders[place(holder.element)].push_back(static_cast<std::uint32_t>(holder.rank));

    struct Change {
      std::uint64_t color, element;
    };
    std::vector<std::vector<Change>> changes(ranks);
    std::vector<std::uint32_t> last_color(known.size(), patches.number_of_colors);
    for(const Distributed_patches::Patch& patch : patches.patches)
      for(std::size_t k = patch.first; k < patch.last; ++k) {
        const std::uint32_t i = place(patches.unknowns[k]);
        if(last_color[i] == patch.color)
          continue;
        last_color[i] = patch.color;
        for(std::uint32_t rank : holders[i])
          changes[rank].push_back({patch.color, patches.unknowns[k]});
      }
    const auto changes_of_others = m_communicator.exchange(changes);
    const auto by_color = [&](const std::vector<std::vector<Change>>& from, std::uint32_t color,
                              std::vector<std::vector<std::uint32_t>>& to) {
      to.assign(ranks, {});
      for(std::size_t rank = 0; rank < ranks; ++rank)
        for(const Change& change : from[rank])
          if(change.color == color)
            to[rank].push_back(position[place(change.element)]);
    };
    for(std::uint32_t color = 0; color < patches.number_of_colors; ++color) {
      by_color(changes, color, sent);
      by_color(changes_of_others, color, received);
      m_of_colors.emplace_back(m_communicator, sent, received);
    }
  }

  Communicator m_communicator;
  std::array<std::size_t, 2> m_own; // those that this rank owns, among those that it knows
  std::optional<Patch_smoother> m_smoother;
  std::optional<Neighbor_lists> m_all;
  std::vector<Neighbor_lists> m_of_colors;
  std::tuple<Vectors<1>, Vectors<vectors_of_a_block>> m_vectors;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_DISTRIBUTED_SMOOTHER_H
