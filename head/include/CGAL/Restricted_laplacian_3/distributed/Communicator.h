// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_COMMUNICATOR_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_COMMUNICATOR_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>

// the functions of C only
#ifndef OMPI_SKIP_MPICXX
#define OMPI_SKIP_MPICXX 1
#endif
#ifndef MPICH_SKIP_MPICXX
#define MPICH_SKIP_MPICXX 1
#endif
#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <new>
#include <numeric>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Distributed
/// A step of work on several processes has failed on at least one of them. It is thrown by all
/// processes, with the message of the first that failed, so that all of them can end.
class Distributed_error : public std::runtime_error {
public:
  /// \param message what `what()` returns
  /// \param parameter what it begins with, if it is the name of a parameter
  explicit Distributed_error(const std::string& message, const std::string& parameter = {})
    : std::runtime_error(message), m_parameter(parameter) {}

  /// the name of the parameter that is outside its domain; empty if it is something else
  const std::string& parameter() const { return m_parameter; }

private:
  std::string m_parameter;
};

/// \ingroup PkgRestrictedLaplacian3Distributed
/// The processes of an MPI communicator, *ranks*, and what they tell each other. All functions but
/// `rank()` and `size()` are collective: every rank calls them, in the same order.
///
/// MPI must be initialized; the communicator is not copied, and must outlive this object.
class Communicator {
public:
  /// \param communicator all processes, unless another one is given
  explicit Communicator(MPI_Comm communicator = MPI_COMM_WORLD) : m_communicator(communicator) {
    MPI_Comm_rank(communicator, &m_rank);
    MPI_Comm_size(communicator, &m_size);
  }

  /// the communicator
  MPI_Comm get() const { return m_communicator; }
  /// the number of this process, from 0
  int rank() const { return m_rank; }
  /// how many processes there are
  int size() const { return m_size; }

  /// Does a step of the work, which must not be collective itself, and tells all ranks whether it
  /// was done.
  /// \throws Distributed_error on all ranks if it threw an exception on any of them
  template <class Step> void agree(Step&& step) const {
    std::string message, parameter;
    bool has_failed = false;
    try {
      step();
    } catch(const std::exception& error) {
      has_failed = true;
      message = error.what();
      if(dynamic_cast<const std::bad_alloc*>(&error) && !dynamic_cast<const Out_of_memory*>(&error))
        message = "not enough memory on rank " + std::to_string(m_rank);
      if(const auto* of_parameter = dynamic_cast<const Parameter_error*>(&error))
        parameter = of_parameter->parameter();
      if(const auto* of_others = dynamic_cast<const Distributed_error*>(&error))
        parameter = of_others->parameter();
    }
    const int first = minimum(has_failed ? m_rank : m_size);
    if(first == m_size)
      return;
    std::vector<char> text(message.begin(), message.end()),
        name(parameter.begin(), parameter.end());
    broadcast(text, first);
    broadcast(name, first);
    throw Distributed_error(std::string(text.begin(), text.end()),
                            std::string(name.begin(), name.end()));
  }

  /// sum, smallest and largest of the numbers of all ranks
  template <class T> T sum(T value) const { return reduced(value, MPI_SUM); }
  /// \copydoc sum
  template <class T> T minimum(T value) const { return reduced(value, MPI_MIN); }
  /// \copydoc sum
  template <class T> T maximum(T value) const { return reduced(value, MPI_MAX); }

  /// each entry becomes the sum of those of all ranks
  template <class T> void sum(std::vector<T>& values) const { reduce(values, MPI_SUM); }
  /// each entry becomes the largest of those of all ranks
  template <class T> void maximum(std::vector<T>& values) const { reduce(values, MPI_MAX); }

  /// the numbers of all ranks, by rank
  template <class T> std::vector<T> all(T value) const {
    std::vector<T> result(static_cast<std::size_t>(m_size));
    MPI_Allgather(&value, 1, type<T>(), result.data(), 1, type<T>(), m_communicator);
    return result;
  }

  /// sums of the numbers of the ranks before each one, and of all: one more than there are ranks
  std::vector<std::uint64_t> offsets(std::uint64_t value) const {
    std::vector<std::uint64_t> result = all(value);
    result.insert(result.begin(), 0);
    std::partial_sum(result.begin(), result.end(), result.begin());
    return result;
  }

  /// what a rank has, on all of them
  template <class T> void broadcast(std::vector<T>& values, int from) const {
    static_assert(std::is_trivially_copyable_v<T>);
    auto size = static_cast<std::uint64_t>(values.size());
    MPI_Bcast(&size, 1, MPI_UINT64_T, from, m_communicator);
    values.resize(static_cast<std::size_t>(size));
    for_each_part(values.data(), values.size(), [&](char* part, int bytes) {
      MPI_Bcast(part, bytes, MPI_BYTE, from, m_communicator);
    });
  }

  /// what all ranks have, one after the other
  template <class T> std::vector<T> concatenation(const std::vector<T>& values) const {
    const std::vector<std::vector<T>> lists =
        exchange(std::vector<std::vector<T>>(static_cast<std::size_t>(m_size), values));
    std::vector<T> result;
    for(const std::vector<T>& list : lists)
      result.insert(result.end(), list.begin(), list.end());
    return result;
  }

  /// Sends a list of values to each rank.
  /// \param lists one for each rank, this one included
  /// \return the lists that came, by rank
  template <class T>
  std::vector<std::vector<T>> exchange(const std::vector<std::vector<T>>& lists) const {
    static_assert(std::is_trivially_copyable_v<T>);
    const auto size = static_cast<std::size_t>(m_size);
    std::vector<std::uint64_t> sent(size), received(size);
    for(std::size_t i = 0; i < size; ++i)
      sent[i] = lists[i].size();
    MPI_Alltoall(sent.data(), 1, MPI_UINT64_T, received.data(), 1, MPI_UINT64_T, m_communicator);
    std::vector<std::vector<T>> result(size);
    std::vector<MPI_Request> requests;
    for(std::size_t i = 0; i < size; ++i) {
      if(static_cast<int>(i) == m_rank) {
        result[i] = lists[i];
        continue;
      }
      result[i].resize(static_cast<std::size_t>(received[i]));
      for_each_part(result[i].data(), result[i].size(), [&](char* part, int bytes) {
        requests.emplace_back();
        MPI_Irecv(part, bytes, MPI_BYTE, static_cast<int>(i), 0, m_communicator, &requests.back());
      });
    }
    for(std::size_t i = 0; i < size; ++i)
      if(static_cast<int>(i) != m_rank)
        for_each_part(const_cast<T*>(lists[i].data()), lists[i].size(), [&](char* part, int bytes) {
          requests.emplace_back();
          MPI_Isend(part, bytes, MPI_BYTE, static_cast<int>(i), 0, m_communicator,
                    &requests.back());
        });
    MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
    return result;
  }

  /// Asks other ranks.
  /// \param questions for each rank
  /// \param answer what this rank answers to a question
  /// \return the answers, in the order of the questions
  template <class Question, class Answer>
  auto ask(const std::vector<std::vector<Question>>& questions, Answer&& answer) const {
    using Result = std::decay_t<decltype(answer(std::declval<const Question&>()))>;
    std::vector<std::vector<Result>> answers;
    for(const std::vector<Question>& list : exchange(questions)) {
      answers.emplace_back();
      answers.back().reserve(list.size());
      for(const Question& question : list)
        answers.back().push_back(answer(question));
    }
    return exchange(answers);
  }

private:
  // MPI counts with 32 bits
  static constexpr std::size_t most_at_once = std::size_t(1) << 30;

  /// calls `visit(part, bytes)` for parts that one message can hold
  template <class T, class Visitor>
  static void for_each_part(T* values, std::size_t size, Visitor&& visit) {
    char* const bytes = reinterpret_cast<char*>(values);
    const std::size_t number = size * sizeof(T);
    for(std::size_t begin = 0; begin < number; begin += most_at_once)
      visit(bytes + begin, static_cast<int>((std::min)(number - begin, most_at_once)));
  }

  template <class T> static MPI_Datatype type() {
    if constexpr(std::is_same_v<T, double>)
      return MPI_DOUBLE;
    else if constexpr(std::is_same_v<T, int>)
      return MPI_INT;
    else {
      static_assert(std::is_same_v<T, std::uint64_t>, "double, int or std::uint64_t");
      return MPI_UINT64_T;
    }
  }

  template <class T> T reduced(T value, MPI_Op operation) const {
    T result;
    MPI_Allreduce(&value, &result, 1, type<T>(), operation, m_communicator);
    return result;
  }

  template <class T> void reduce(std::vector<T>& values, MPI_Op operation) const {
    for(std::size_t begin = 0; begin < values.size(); begin += most_at_once)
      MPI_Allreduce(MPI_IN_PLACE, values.data() + begin,
                    static_cast<int>((std::min)(values.size() - begin, most_at_once)), type<T>(),
                    operation, m_communicator);
  }

  MPI_Comm m_communicator;
  int m_rank = 0, m_size = 1;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_COMMUNICATOR_H
