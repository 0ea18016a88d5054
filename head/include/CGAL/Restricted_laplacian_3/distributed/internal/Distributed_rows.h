// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_DISTRIBUTED_ROWS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_DISTRIBUTED_ROWS_H

#include <CGAL/Restricted_laplacian_3/distributed/Communicator.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Element_exchange.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/petsc.h>
#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Rows of a sparse matrix, with columns that are numbers in a whole level.
struct Distributed_rows {
  std::vector<PetscInt> first = {0}; // entry of each row, and one more
  std::vector<PetscInt> columns;     // ascending in a row
  std::vector<double> values;

  std::size_t size() const { return first.size() - 1; }
};

/// an entry of a matrix that another rank owns
struct Matrix_entry {
  std::uint64_t row, column;
  double value;
};

/// The rows of the elements that this rank owns, of the sum of the matrices of all ranks.
/// \param a symmetric, both halves, of the elements that this rank knows
/// \param elements their numbers
inline Distributed_rows sum_of_matrices(const Communicator& communicator,
                                        const Element_exchange& exchange,
                                        const std::vector<std::uint64_t>& elements,
                                        const Sparse_matrix& a) {
  std::vector<std::vector<Matrix_entry>> others(static_cast<std::size_t>(communicator.size()));
  for(std::size_t rank = 0; rank < others.size(); ++rank)
    for(std::size_t i = exchange.known(rank)[0]; i < exchange.known(rank)[1]; ++i)
      if(!exchange.owns(elements[i]))
        for(Sparse_matrix::InnerIterator k(a, static_cast<int>(i)); k; ++k)
          others[rank].push_back(
              {elements[i], elements[static_cast<std::size_t>(k.row())], k.value()});
  std::vector<Matrix_entry> added;
  for(const auto& list : communicator.exchange(others))
    added.insert(added.end(), list.begin(), list.end());
  // Ranks follow each other among those of the same place, so that sums do not depend on luck.
  std::stable_sort(added.begin(), added.end(), [](const Matrix_entry& p, const Matrix_entry& q) {
    return std::tie(p.row, p.column) < std::tie(q.row, q.column);
  });

  Distributed_rows result;
  const auto [own_begin, own_end] = exchange.known(static_cast<std::size_t>(communicator.rank()));
  std::size_t size = added.size();
  for(std::size_t i = own_begin; i < own_end; ++i)
    size += static_cast<std::size_t>(a.outerIndexPtr()[i + 1] - a.outerIndexPtr()[i]);
  result.columns.reserve(size);
  result.values.reserve(size);
  std::size_t next = own_begin, next_added = 0;
  for(std::size_t i = 0; i < exchange.own_size(); ++i) {
    const std::uint64_t row = exchange.first() + i;
    const std::size_t begin = result.columns.size();
    const auto add = [&](std::uint64_t column, double value) {
      const auto c = static_cast<PetscInt>(column);
      if(result.columns.size() > begin && result.columns.back() == c)
        result.values.back() += value;
      else {
        result.columns.push_back(c);
        result.values.push_back(value);
      }
    };
    const auto add_others_up_to = [&](std::uint64_t column) {
      while(next_added < added.size() && added[next_added].row == row &&
            added[next_added].column <= column) {
        add(added[next_added].column, added[next_added].value);
        ++next_added;
      }
    };
    if(next < own_end && elements[next] == row) {
      for(Sparse_matrix::InnerIterator k(a, static_cast<int>(next)); k; ++k) {
        const std::uint64_t column = elements[static_cast<std::size_t>(k.row())];
        if(column > 0)
          add_others_up_to(column - 1);
        add(column, k.value());
        add_others_up_to(column);
      }
      ++next;
    }
    add_others_up_to((std::numeric_limits<std::uint64_t>::max)());
    result.first.push_back(petsc_int(result.columns.size()));
  }
  return result;
}

/// The rows of the elements that this rank owns, of a matrix of which each rank has whole rows of
/// the elements that it knows.
/// \param elements,columns numbers of the rows and columns of `a`
inline Distributed_rows rows_of_owner(const Communicator& communicator,
                                      const Element_exchange& exchange,
                                      const std::vector<std::uint64_t>& elements,
                                      const std::vector<std::uint64_t>& columns,
                                      const Sparse_matrix& a) {
  const Eigen::SparseMatrix<double, Eigen::RowMajor> by_rows = a;
  using Row = decltype(by_rows)::InnerIterator;
  const auto me = static_cast<std::size_t>(communicator.rank());
  std::vector<std::vector<Matrix_entry>> lists(static_cast<std::size_t>(communicator.size()));
  for(std::size_t rank = 0; rank < lists.size(); ++rank)
    for(std::size_t i = exchange.known(rank)[0]; i < exchange.known(rank)[1] && rank != me; ++i)
      for(Row k(by_rows, static_cast<int>(i)); k; ++k)
        lists[rank].push_back({elements[i], columns[static_cast<std::size_t>(k.col())], k.value()});
  const auto received = communicator.exchange(lists);
  // where rows are that are not known here: the first rank that has one
  constexpr std::size_t nowhere = (std::numeric_limits<std::size_t>::max)();
  std::vector<std::size_t> rank_of_row(exchange.own_size(), nowhere),
      place_of_row(exchange.own_size());
  for(std::size_t i = exchange.known(me)[0]; i < exchange.known(me)[1]; ++i) {
    const auto row = static_cast<std::size_t>(elements[i] - exchange.first());
    rank_of_row[row] = me;
    place_of_row[row] = i;
  }
  for(std::size_t rank = 0; rank < received.size(); ++rank)
    for(std::size_t k = 0; k < received[rank].size(); ++k) {
      const auto row = static_cast<std::size_t>(received[rank][k].row - exchange.first());
      if(rank_of_row[row] != nowhere)
        continue;
      rank_of_row[row] = rank;
      place_of_row[row] = k;
    }
  Distributed_rows result;
  const auto add = [&](std::uint64_t column, double value) {
    result.columns.push_back(petsc_int(column));
    result.values.push_back(value);
  };
  for(std::size_t i = 0; i < exchange.own_size(); ++i) {
    const std::size_t rank = rank_of_row[i];
    if(rank == me)
      for(Row k(by_rows, static_cast<int>(place_of_row[i])); k; ++k)
        add(columns[static_cast<std::size_t>(k.col())], k.value());
    else if(rank != nowhere)
      for(std::size_t k = place_of_row[i];
          k < received[rank].size() && received[rank][k].row == exchange.first() + i; ++k)
        add(received[rank][k].column, received[rank][k].value);
    result.first.push_back(petsc_int(result.columns.size()));
  }
  return result;
}

/// Rows that other ranks own.
/// \param wanted numbers of rows, ascending, none of this rank
inline Distributed_rows rows_of_others(const Communicator& communicator,
                                       const Element_exchange& exchange,
                                       const Distributed_rows& own,
                                       const std::vector<std::uint64_t>& wanted) {
  std::vector<std::vector<std::uint64_t>> questions(static_cast<std::size_t>(communicator.size()));
  for(std::uint64_t row : wanted)
    questions[exchange.owner(row)].push_back(row);
  std::vector<std::vector<PetscInt>> sizes, columns;
  std::vector<std::vector<double>> values;
  for(const auto& list : communicator.exchange(questions)) {
    sizes.emplace_back();
    columns.emplace_back();
    values.emplace_back();
    for(std::uint64_t row : list) {
      const auto i = static_cast<std::size_t>(row - exchange.first());
      sizes.back().push_back(own.first[i + 1] - own.first[i]);
      columns.back().insert(columns.back().end(), own.columns.begin() + own.first[i],
                            own.columns.begin() + own.first[i + 1]);
      values.back().insert(values.back().end(), own.values.begin() + own.first[i],
                           own.values.begin() + own.first[i + 1]);
    }
  }
  Distributed_rows result;
  for(const auto& list : communicator.exchange(sizes))
    for(PetscInt size : list)
      result.first.push_back(result.first.back() + size);
  for(const auto& list : communicator.exchange(columns))
    result.columns.insert(result.columns.end(), list.begin(), list.end());
  for(const auto& list : communicator.exchange(values))
    result.values.insert(result.values.end(), list.begin(), list.end());
  return result;
}

/// The rows of a matrix of PETSc, which it uses where they are: of a matrix on several ranks those
/// columns that belong to vectors of this rank, counted from the first one, and the others.
struct Petsc_arrays {
  Distributed_rows own, others;

  /// \param rows are used up
  /// \param begin,end which columns belong to vectors of this rank
  Petsc_arrays(Distributed_rows rows, std::uint64_t begin, std::uint64_t end)
    : own(std::move(rows)) {
    std::size_t next = 0, read = 0;
    for(std::size_t i = 0; i < own.size(); ++i) {
      const auto last = static_cast<std::size_t>(own.first[i + 1]);
      for(; read < last; ++read) {
        const auto column = static_cast<std::uint64_t>(own.columns[read]);
        if(column >= begin && column < end) {
          own.columns[next] = static_cast<PetscInt>(column - begin);
          own.values[next++] = own.values[read];
        } else {
          others.columns.push_back(own.columns[read]);
          others.values.push_back(own.values[read]);
        }
      }
      own.first[i + 1] = static_cast<PetscInt>(next);
      others.first.push_back(static_cast<PetscInt>(others.columns.size()));
    }
    own.columns.resize(next);
    own.values.resize(next);
  }

  static PetscErrorCode destroy(void* arrays) {
    delete static_cast<Petsc_arrays*>(arrays);
    return 0;
  }
};

/// a matrix of PETSc
/// \param rows are used up
/// \param columns how many columns this rank has, with the entries of vectors that they belong to
inline Petsc_matrix petsc_matrix(const Communicator& communicator, Distributed_rows rows,
                                 std::size_t columns) {
  const PetscInt m = petsc_int(rows.size()), n = petsc_int(columns);
  const std::vector<std::uint64_t> offsets = communicator.offsets(columns);
  const auto rank = static_cast<std::size_t>(communicator.rank());
  auto arrays = std::make_unique<Petsc_arrays>(std::move(rows), offsets[rank], offsets[rank + 1]);
  Distributed_rows &own = arrays->own, &others = arrays->others;
  Petsc_matrix result;
  petsc_check(
      communicator.size() == 1
          ? MatCreateSeqAIJWithArrays(communicator.get(), m, n, own.first.data(),
                                      own.columns.data(), own.values.data(), result.address())
          : MatCreateMPIAIJWithSplitArrays(
                communicator.get(), m, n, PETSC_DETERMINE, PETSC_DETERMINE, own.first.data(),
                own.columns.data(), own.values.data(), others.first.data(), others.columns.data(),
                others.values.data(), result.address()));
  // they live as long as the matrix
  PetscContainer container = nullptr;
  petsc_check(PetscContainerCreate(communicator.get(), &container));
  petsc_check(PetscContainerSetPointer(container, arrays.release()));
#if PETSC_VERSION_LT(3, 23, 0)
  petsc_check(PetscContainerSetUserDestroy(container, Petsc_arrays::destroy));
#else
  // the type of what it is called with, the place of a pointer, differs from version to version
  petsc_check(PetscContainerSetCtxDestroy(
      container, [](auto arrays) { return Petsc_arrays::destroy(*static_cast<void**>(arrays)); }));
#endif
  petsc_check(PetscObjectCompose(reinterpret_cast<PetscObject>(static_cast<Mat>(result)),
                                 "Restricted_laplacian_3_arrays",
                                 reinterpret_cast<PetscObject>(container)));
  petsc_check(PetscContainerDestroy(&container));
  return result;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_DISTRIBUTED_ROWS_H
