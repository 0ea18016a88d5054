// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_DISTRIBUTED_COMPONENTS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_DISTRIBUTED_COMPONENTS_H

#include <CGAL/Restricted_laplacian_3/distributed/Communicator.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_space.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Element_exchange.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Disjoint_sets.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The connected components of the elements of the finest level, those on a common sheet being
/// neighbors.
struct Distributed_components {
  /// how many there are
  std::size_t number = 0;
  /// of each element that this rank owns
  std::vector<std::uint32_t> of_element;

  Distributed_components(const Distributed_space& space, const Element_exchange& exchange) {
    const Communicator& communicator = space.communicator();
    const int level = space.depth();
    const std::vector<std::uint64_t>& elements = space.level(level).elements;
    Disjoint_sets sets(elements.size());
    for(std::size_t sheet = 0; sheet < space.part().number_of_sheets(level); ++sheet) {
      std::uint32_t first = no_element;
      for(std::uint32_t element : space.part().elements(level, sheet)) {
        if(element != no_element && first != no_element)
          sets.unite(first, element);
        if(element != no_element)
          first = element;
      }
    }
    // The smallest number of an element spreads over each component.
    std::vector<std::uint64_t> labels(elements.size()), own(exchange.own_size());
    for(std::size_t i = 0; i < labels.size(); ++i)
      labels[i] = elements[sets.find(static_cast<std::uint32_t>(i))];
    for(std::size_t i = 0; i < own.size(); ++i)
      own[i] = exchange.first() + i;
    const auto to_smaller = [](std::uint64_t& a, std::uint64_t b) { a = (std::min)(a, b); };
    for(int has_changed = 1; has_changed == 1;) {
      exchange.combine(labels, own, to_smaller);
      const std::vector<std::uint64_t> now = exchange.values(own);
      std::vector<std::uint64_t> of_sets = labels;
      has_changed = 0;
      for(std::size_t i = 0; i < labels.size(); ++i)
        to_smaller(of_sets[sets.find(static_cast<std::uint32_t>(i))], now[i]);
      for(std::size_t i = 0; i < labels.size(); ++i) {
        const std::uint64_t label = of_sets[sets.find(static_cast<std::uint32_t>(i))];
        has_changed |= label < labels[i] ? 1 : 0;
        labels[i] = label;
      }
      has_changed = communicator.maximum(has_changed);
    }
    // They are numbered in the order of these elements.
    std::vector<std::uint64_t> numbers(own.size());
    std::uint64_t count = 0;
    for(std::size_t i = 0; i < own.size(); ++i)
      if(own[i] == exchange.first() + i)
        numbers[i] = count++;
    const std::vector<std::uint64_t> offsets = communicator.offsets(count);
    number = static_cast<std::size_t>(offsets.back());
    const std::uint64_t offset = offsets[static_cast<std::size_t>(communicator.rank())];
    std::vector<std::vector<std::uint64_t>> questions(
        static_cast<std::size_t>(communicator.size()));
    for(std::uint64_t label : own)
      if(std::vector<std::uint64_t>& list = questions[exchange.owner(label)];
         list.empty() || list.back() != label)
        list.push_back(label);
    for(std::vector<std::uint64_t>& list : questions) {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    const auto answers = communicator.ask(questions, [&](std::uint64_t label) {
      return offset + numbers[static_cast<std::size_t>(label - exchange.first())];
    });
    for(std::uint64_t label : own) {
      const std::size_t owner = exchange.owner(label);
      const auto place = std::lower_bound(questions[owner].begin(), questions[owner].end(), label);
      of_element.push_back(static_cast<std::uint32_t>(
          answers[owner][static_cast<std::size_t>(place - questions[owner].begin())]));
    }
  }
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_DISTRIBUTED_COMPONENTS_H
