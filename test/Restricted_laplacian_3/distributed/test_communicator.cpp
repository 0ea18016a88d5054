// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../catch.h"

#include <CGAL/Restricted_laplacian_3/distributed/Communicator.h>

#include <cstddef>
#include <cstdint>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace RL = CGAL::Restricted_laplacian_3;

TEST_CASE("ranks_tell_each_other_numbers", "[shapes]") {
  const RL::Communicator ranks;
  const int me = ranks.rank(), size = ranks.size();
  int expected_size = 0;
  MPI_Comm_size(ranks.get(), &expected_size);
  REQUIRE(size == expected_size);
  CHECK(ranks.sum(me + 1) == size * (size + 1) / 2);
  CHECK(ranks.minimum(1. * me) == 0);
  CHECK(ranks.maximum(1. * me) == size - 1);
  std::vector<std::uint64_t> counts = {1, static_cast<std::uint64_t>(me)};
  ranks.sum(counts);
  CHECK(counts[0] == static_cast<std::uint64_t>(size));
  CHECK(counts[1] == static_cast<std::uint64_t>(size * (size - 1) / 2));
  std::vector<double> largest = {1, -1. * me};
  ranks.maximum(largest);
  CHECK(largest == std::vector<double>{1, 0});
  const std::vector<int> all = ranks.all(3 * me);
  REQUIRE(all.size() == static_cast<std::size_t>(size));
  const std::vector<std::uint64_t> offsets = ranks.offsets(static_cast<std::uint64_t>(me));
  REQUIRE(offsets.size() == static_cast<std::size_t>(size) + 1);
  for(int rank = 0; rank < size; ++rank) {
    CHECK(all[rank] == 3 * rank);
    CHECK(offsets[rank + 1] - offsets[rank] == static_cast<std::uint64_t>(rank));
  }

  std::vector<int> values(me == size - 1 ? 5 : 0, 7);
  ranks.broadcast(values, size - 1);
  CHECK(values == std::vector<int>(5, 7));
  const std::vector<int> together = ranks.concatenation(std::vector<int>(me, me));
  REQUIRE(together.size() == static_cast<std::size_t>(size * (size - 1) / 2));
  for(std::size_t i = 1; i < together.size(); ++i)
    CHECK(together[i - 1] <= together[i]);
}

TEST_CASE("ranks_exchange_lists_of_different_lengths", "[shapes]") {
  const RL::Communicator ranks;
  const auto me = static_cast<std::size_t>(ranks.rank()),
             size = static_cast<std::size_t>(ranks.size());
  std::vector<std::vector<double>> lists;
  for(std::size_t to = 0; to < size; ++to)
    lists.emplace_back(me * to, 100. * me + to);
  const auto received = ranks.exchange(lists);
  REQUIRE(received.size() == size);
  for(std::size_t from = 0; from < size; ++from)
    CHECK(received[from] == std::vector<double>(me * from, 100. * from + me));

  std::vector<std::vector<int>> questions;
  for(std::size_t to = 0; to < size; ++to)
    questions.push_back({1, static_cast<int>(to)});
  const auto answers = ranks.ask(questions, [&](int question) { return question + 10. * me; });
  for(std::size_t to = 0; to < size; ++to)
    CHECK(answers[to] == std::vector<double>{1 + 10. * to, 11. * to});
}

TEST_CASE("all_ranks_learn_what_has_failed_on_one", "[shapes]") {
  const RL::Communicator ranks;
  bool was_done = false;
  ranks.agree([&] { was_done = true; });
  CHECK(was_done);
  const int last = ranks.size() - 1;
  const auto message = [&](auto&& step) {
    try {
      ranks.agree(step);
    } catch(const RL::Distributed_error& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  CHECK(message([&] {
          if(ranks.rank() == last)
            throw std::runtime_error("the last one");
        }) == "the last one");
  // the first one of several
  CHECK(message([&] { throw std::runtime_error("rank " + std::to_string(ranks.rank())); }) ==
        "rank 0");
  CHECK(message([&] {
          if(ranks.rank() == last)
            throw std::bad_alloc();
        }) == "not enough memory on rank " + std::to_string(last));
  try {
    ranks.agree([&] {
      if(ranks.rank() == last)
        throw RL::Parameter_error("depth", "is 99");
    });
    CHECK(false);
  } catch(const RL::Distributed_error& error) {
    CHECK(std::string(error.what()) == "depth is 99");
    CHECK(error.parameter() == "depth");
  }
}
