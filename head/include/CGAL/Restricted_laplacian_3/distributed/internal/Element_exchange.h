// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_ELEMENT_EXCHANGE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_ELEMENT_EXCHANGE_H

#include <CGAL/Restricted_laplacian_3/distributed/Communicator.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Values that ranks send to a few others, always the same places of an array.
class Neighbor_lists {
public:
  /// \param sent,received places for each rank; what a rank sends to another comes there in the
  /// same order
  Neighbor_lists(const Communicator& communicator,
                 const std::vector<std::vector<std::uint32_t>>& sent,
                 const std::vector<std::vector<std::uint32_t>>& received)
    : m_communicator(communicator) {
    for(std::size_t rank = 0; rank < sent.size(); ++rank) {
      if(!sent[rank].empty())
        m_sent.push_back({static_cast<int>(rank), sent[rank]});
      if(!received[rank].empty())
        m_received.push_back({static_cast<int>(rank), received[rank]});
    }
  }

  /// Sends values of the array to the neighbors, and puts theirs into it: `K` of each place.
  template <int K = 1, class T> void exchange(T* values) const {
    std::vector<std::vector<T>> buffers(m_sent.size() + m_received.size());
    std::vector<MPI_Request> requests(buffers.size());
    std::size_t k = 0;
    for(const List& list : m_received) {
      buffers[k].resize(K * list.places.size());
      MPI_Irecv(buffers[k].data(), bytes(buffers[k]), MPI_BYTE, list.rank, 1, m_communicator.get(),
                &requests[k]);
      ++k;
    }
    for(const List& list : m_sent) {
      buffers[k].reserve(K * list.places.size());
      for(std::uint32_t place : list.places)
        buffers[k].insert(buffers[k].end(), values + K * std::size_t(place),
                          values + K * (std::size_t(place) + 1));
      MPI_Isend(buffers[k].data(), bytes(buffers[k]), MPI_BYTE, list.rank, 1, m_communicator.get(),
                &requests[k]);
      ++k;
    }
    MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
    k = 0;
    for(const List& list : m_received) {
      for(std::size_t i = 0; i < list.places.size(); ++i)
        std::copy_n(buffers[k].data() + K * i, K, values + K * std::size_t(list.places[i]));
      ++k;
    }
  }

private:
  struct List {
    int rank;
    std::vector<std::uint32_t> places;
  };
  template <class T> static int bytes(const std::vector<T>& buffer) {
    return static_cast<int>(sizeof(T) * buffer.size());
  }

  Communicator m_communicator;
  std::vector<List> m_sent, m_received;
};

/// Elements of a level that this rank knows, each of which is owned by one rank.
class Element_exchange {
public:
  /// \param first_elements of each rank, and of all
  /// \param elements those that this rank knows, ascending
  Element_exchange(const Communicator& communicator, std::vector<std::uint64_t> first_elements,
                   const std::vector<std::uint64_t>& elements)
    : m_communicator(communicator), m_first_elements(std::move(first_elements)) {
    const auto ranks = static_cast<std::size_t>(communicator.size());
    std::vector<std::vector<std::uint64_t>> questions(ranks);
    for(std::size_t rank = 0; rank < ranks; ++rank) {
      const auto begin = std::lower_bound(elements.begin(), elements.end(), m_first_elements[rank]);
      const auto end = std::lower_bound(begin, elements.end(), m_first_elements[rank + 1]);
      m_ranges.push_back({static_cast<std::size_t>(begin - elements.begin()),
                          static_cast<std::size_t>(end - elements.begin())});
      questions[rank].assign(begin, end);
    }
    for(const auto& list : communicator.exchange(questions)) {
      m_asked.emplace_back();
      for(std::uint64_t element : list)
        m_asked.back().push_back(static_cast<std::uint32_t>(element - first()));
    }
  }

  /// number of the first element that this rank owns
  std::uint64_t first() const { return m_first_elements[rank()]; }
  /// how many it owns
  std::size_t own_size() const {
    return static_cast<std::size_t>(m_first_elements[rank() + 1] - first());
  }
  /// whether this rank owns an element
  bool owns(std::uint64_t element) const {
    return element >= first() && element < m_first_elements[rank() + 1];
  }
  /// which rank owns it
  std::size_t owner(std::uint64_t element) const {
    const auto after = std::upper_bound(m_first_elements.begin(), m_first_elements.end(), element);
    return static_cast<std::size_t>(after - m_first_elements.begin()) - 1;
  }
  /// which of the known elements a rank owns, a half-open range
  const std::array<std::size_t, 2>& known(std::size_t rank) const { return m_ranges[rank]; }
  /// which of the elements of this rank another rank knows, counted from `first()`
  const std::vector<std::uint32_t>& known_by(std::size_t rank) const { return m_asked[rank]; }

  /// values of the known elements, from those of the elements that each rank owns
  template <class T> std::vector<T> values(const std::vector<T>& own) const {
    std::vector<std::vector<T>> answers;
    for(const auto& list : m_asked) {
      answers.emplace_back();
      for(std::uint32_t i : list)
        answers.back().push_back(own[i]);
    }
    std::vector<T> result;
    for(const auto& list : m_communicator.exchange(answers))
      result.insert(result.end(), list.begin(), list.end());
    return result;
  }

  /// Calls `add(own value, value)` for all values that ranks have of elements that this rank owns,
  /// in the order of ranks.
  template <class T, class Add>
  void combine(const std::vector<T>& known, std::vector<T>& own, Add&& add) const {
    std::vector<std::vector<T>> lists;
    for(const auto& [begin, end] : m_ranges)
      lists.emplace_back(known.begin() + static_cast<std::ptrdiff_t>(begin),
                         known.begin() + static_cast<std::ptrdiff_t>(end));
    const auto received = m_communicator.exchange(lists);
    for(std::size_t rank = 0; rank < received.size(); ++rank)
      for(std::size_t k = 0; k < received[rank].size(); ++k)
        add(own[m_asked[rank][k]], received[rank][k]);
  }

  /// values of the elements that this rank owns, from those that ranks have of the elements they
  /// know, which agree
  std::vector<double> own_values(const Eigen::Ref<const Eigen::VectorXd>& known) const {
    std::vector<double> own(own_size(), 0.);
    combine(std::vector<double>(known.data(), known.data() + known.size()), own,
            [](double& value, double other) { value = other; });
    return own;
  }

  /// the sums of the values that ranks have of the elements that they know
  std::vector<double> own_sums(const Eigen::Ref<const Eigen::VectorXd>& known) const {
    std::vector<double> own(own_size(), 0.);
    combine(std::vector<double>(known.data(), known.data() + known.size()), own,
            [](double& sum, double value) { sum += value; });
    return own;
  }

  /// values of the known elements, as a vector
  Eigen::VectorXd known_values(const std::vector<double>& own) const {
    const std::vector<double> known = values(own);
    return Eigen::Map<const Eigen::VectorXd>(known.data(), static_cast<Eigen::Index>(known.size()));
  }

private:
  std::size_t rank() const { return static_cast<std::size_t>(m_communicator.rank()); }

  Communicator m_communicator;
  std::vector<std::uint64_t> m_first_elements;
  std::vector<std::array<std::size_t, 2>> m_ranges;
  std::vector<std::vector<std::uint32_t>> m_asked;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_ELEMENT_EXCHANGE_H
