// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_LEVEL_EXCHANGE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_LEVEL_EXCHANGE_H

#include <CGAL/Restricted_laplacian_3/distributed/Communicator.h>
#include <CGAL/Restricted_laplacian_3/distributed/Rank_ranges.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_lists.h>
#include <CGAL/Restricted_laplacian_3/octree/shared/Octree_builder.h>
#include <CGAL/Restricted_laplacian_3/octree/shared/Octree_level.h>
#include <CGAL/Restricted_laplacian_3/octree/shared/Sheet_sorter.h>
#include <CGAL/Restricted_laplacian_3/splines/shared/Element_numbering.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The sheets of a level in the cells of one rank.
struct Own_sheets {
  /// number in the whole level of the first sheet of each rank, and of all
  std::vector<std::uint64_t> first_sheets;
  /// the sheets, with the links among them
  Octree_level level;
  std::vector<Place> places;
  /// links to sheets of other ranks: a sheet of `level`, and a number in the whole level
  std::vector<std::pair<std::uint32_t, std::uint64_t>> outer_links;

  std::uint64_t first_sheet(int rank) const { return first_sheets[static_cast<std::size_t>(rank)]; }
  /// the rank of a sheet
  std::size_t owner(std::uint64_t sheet) const {
    const auto after = std::upper_bound(first_sheets.begin(), first_sheets.end(), sheet);
    return static_cast<std::size_t>(after - first_sheets.begin()) - 1;
  }
};

/// What ranks tell each other about the levels of their parts of an octree.
class Level_exchange {
public:
  /// \param is_paper_space whether only elements centered inside the grid exist
  Level_exchange(const Communicator& communicator, const Rank_ranges& ranges, bool is_split,
                 bool is_paper_space, bool is_parallel)
    : m_communicator(communicator), m_ranges(ranges),
      m_rank(static_cast<std::size_t>(communicator.rank())), m_is_split(is_split),
      m_is_paper_space(is_paper_space), m_is_parallel(is_parallel) {}

  /// The sheets of this rank, of a finest level that has those of the cells beside as well.
  Own_sheets own_sheets(const Octree_level& with_neighbors,
                        const std::vector<Place>& places) const {
    const Octree_level& from = with_neighbors;
    const auto [first_key, last_key] = m_ranges.cells(m_rank, from.level);
    const auto position = [&](std::uint64_t key) {
      return static_cast<std::size_t>(std::lower_bound(from.keys.begin(), from.keys.end(), key) -
                                      from.keys.begin());
    };
    const std::size_t cell = position(first_key), last_cell = position(last_key);
    const std::uint32_t first = from.first_sheets[cell], last = from.first_sheets[last_cell];
    Own_sheets result;
    result.first_sheets = m_communicator.offsets(last - first);
    const std::uint64_t offset = result.first_sheet(m_communicator.rank());

    // The first sheets of the other cells, and those after them, have numbers of their owners.
    std::vector<std::vector<std::uint64_t>> questions(m_ranges.size());
    std::vector<std::vector<std::uint32_t>> places_of_questions(m_ranges.size());
    for(std::size_t i = 0; i < from.number_of_cells(); ++i)
      if(i < cell || i >= last_cell) {
        const std::size_t owner = m_ranges.owner(from.level, from.keys[i]);
        questions[owner].push_back(from.keys[i]);
        places_of_questions[owner].push_back(static_cast<std::uint32_t>(i));
      }
    const auto answers = m_communicator.ask(questions, [&](std::uint64_t key) {
      const std::size_t i = position(key);
      const bool is_there = i < from.number_of_cells() && from.keys[i] == key;
      return is_there ? Cell_answer{offset + from.first_sheets[i] - first,
                                    from.first_sheets[i + 1] - from.first_sheets[i]}
                      : Cell_answer{0, 0};
    });
    std::vector<std::uint64_t> numbers(from.number_of_sheets());
    for(std::size_t sheet = first; sheet < last; ++sheet)
      numbers[sheet] = offset + sheet - first;
    m_communicator.agree([&] {
      for(std::size_t rank = 0; rank < answers.size(); ++rank)
        for(std::size_t k = 0; k < answers[rank].size(); ++k) {
          const std::uint32_t i = places_of_questions[rank][k];
          check_same(answers[rank][k].number == from.first_sheets[i + 1] - from.first_sheets[i]);
          for(std::uint32_t sheet = from.first_sheets[i]; sheet < from.first_sheets[i + 1]; ++sheet)
            numbers[sheet] = answers[rank][k].first + sheet - from.first_sheets[i];
        }
    });

    Octree_level& to = result.level;
    to.level = from.level;
    const auto part = [](const auto& all, std::size_t begin, std::size_t end) {
      using Numbers = std::decay_t<decltype(all)>;
      return Numbers(all.begin() + static_cast<std::ptrdiff_t>(begin),
                     all.begin() + static_cast<std::ptrdiff_t>(end));
    };
    to.keys = part(from.keys, cell, last_cell);
    to.first_sheets = part(from.first_sheets, cell, last_cell + 1);
    for(std::uint32_t& sheet : to.first_sheets)
      sheet -= first;
    to.cells = part(from.cells, first, last);
    for(std::uint32_t& i : to.cells)
      i -= static_cast<std::uint32_t>(cell);
    to.element_masks = part(from.element_masks, first, last);
    result.places = part(places, first, last);
    std::vector<std::size_t> first_faces;
    for(std::size_t sheet = first; sheet <= last; ++sheet)
      first_faces.push_back(from.faces.first(sheet) - from.faces.first(first));
    to.faces =
        Number_lists(std::move(first_faces),
                     part(from.faces.numbers(), from.faces.first(first), from.faces.first(last)));
    std::vector<Number_lists::Pair> links;
    for(std::uint32_t sheet = first; sheet < last; ++sheet)
      for(std::uint32_t other : from.links[sheet])
        if(other >= first && other < last)
          links.emplace_back(sheet - first, other - first);
        else
          result.outer_links.emplace_back(sheet - first, numbers[other]);
    to.links = Number_lists(to.cells.size(), links);
    to.index_keys();
    return result;
  }

  /// The next coarser level of the sheets of this rank, which must have whole cells of it; parents
  /// of the finer one are set.
  Own_sheets coarser(Own_sheets& fine) const {
    Own_sheets result;
    result.places = fine.places;
    result.level = Octree_builder::coarser_level(fine.level, result.places, m_is_split);
    result.first_sheets = m_communicator.offsets(result.level.number_of_sheets());
    const std::uint64_t fine_offset = fine.first_sheet(m_communicator.rank()),
                        offset = result.first_sheet(m_communicator.rank());
    // the parents of the outer sheets
    std::vector<std::vector<std::uint64_t>> questions(m_ranges.size());
    for(const auto& link : fine.outer_links)
      questions[fine.owner(link.second)].push_back(link.second);
    for(std::vector<std::uint64_t>& list : questions) {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    const auto answers = m_communicator.ask(questions, [&](std::uint64_t sheet) {
      return offset + fine.level.parents[static_cast<std::size_t>(sheet - fine_offset)];
    });
    for(const auto& [sheet, other] : fine.outer_links) {
      const std::size_t owner = fine.owner(other);
      const auto& list = questions[owner];
      const auto place = std::lower_bound(list.begin(), list.end(), other) - list.begin();
      result.outer_links.emplace_back(fine.level.parents[sheet],
                                      answers[owner][static_cast<std::size_t>(place)]);
    }
    std::sort(result.outer_links.begin(), result.outer_links.end());
    result.outer_links.erase(std::unique(result.outer_links.begin(), result.outer_links.end()),
                             result.outer_links.end());
    return result;
  }

  /// The whole level, of the sheets of all ranks, and their places; without parents and children.
  Octree_level gathered(const Own_sheets& own, std::vector<Place>& places) const {
    std::vector<Sheet_record> sheets;
    std::vector<Link_record> links;
    for(std::uint32_t sheet = 0; sheet < own.level.number_of_sheets(); ++sheet)
      add_records(own, sheet, sheets, links);
    places = m_communicator.concatenation(own.places);
    return level_of(own.level.level, m_communicator.concatenation(sheets),
                    m_communicator.concatenation(links));
  }

  /// The sheets of this rank, and those at most two cells away from its cells: they determine the
  /// elements that act on sheets of this rank, or are centered in its cells.
  /// \param numbers receives the numbers of the sheets in the whole level
  Octree_level with_neighbors(const Own_sheets& own, std::vector<std::uint64_t>& numbers) const {
    constexpr int distance = 2;
    std::vector<std::vector<Sheet_record>> sheets(m_ranges.size());
    std::vector<std::vector<Link_record>> links(m_ranges.size());
    std::vector<std::size_t> ranks;
    for(std::size_t i = 0; i < own.level.number_of_cells(); ++i) {
      ranks.assign(1, m_rank);
      m_ranges.for_each_rank_near(own.level.level, own.level.keys[i], distance,
                                  [&](std::size_t rank) { ranks.push_back(rank); });
      std::sort(ranks.begin(), ranks.end());
      ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
      for(std::size_t rank : ranks)
        for(std::uint32_t sheet = own.level.first_sheets[i]; sheet < own.level.first_sheets[i + 1];
            ++sheet)
          add_records(own, sheet, sheets[rank], links[rank]);
    }
    std::vector<Sheet_record> all_sheets;
    std::vector<Link_record> all_links;
    for(const auto& list : m_communicator.exchange(sheets))
      all_sheets.insert(all_sheets.end(), list.begin(), list.end());
    for(const auto& list : m_communicator.exchange(links))
      all_links.insert(all_links.end(), list.begin(), list.end());
    numbers.clear();
    for(const Sheet_record& record : all_sheets)
      numbers.push_back(record.sheet);
    return level_of(own.level.level, all_sheets, all_links);
  }

  /// Numbers of the elements of a level, in the whole and in the part of this rank.
  struct Elements {
    /// of the sheets of this rank
    Level_elements part;
    /// first element of each rank, and of all
    std::vector<std::uint64_t> first_elements;
    std::uint64_t number_of_split_elements = 0;
    /// the numbers in the whole level of the elements of `part`
    std::vector<std::uint64_t> numbers;
    /// `Element_numbering::center_key()` of the elements that this rank owns
    std::vector<std::uint64_t> own_centers;
  };

  Elements elements(const Own_sheets& own) const {
    std::vector<std::uint64_t> numbers;
    const Octree_level level = with_neighbors(own, numbers);
    const Level_elements all =
        Element_numbering(level, m_is_split, m_is_paper_space, m_is_parallel)();
    const std::size_t size = all.first_slots.size();
    const std::uint64_t first_own = own.first_sheet(m_communicator.rank());
    const auto first_sheet = static_cast<std::size_t>(
        std::lower_bound(numbers.begin(), numbers.end(), first_own) - numbers.begin());
    const std::size_t number_of_sheets = own.level.number_of_sheets();

    const std::vector<Center> centers = centers_of(all, level);
    // Those that this rank owns are consecutive.
    const auto [first_key, last_key] = m_ranges.cells(m_rank, own.level.level);
    const auto first_of = [&](std::uint64_t key) {
      return static_cast<std::size_t>(
          std::lower_bound(centers.begin(), centers.end(), key,
                           [](const Center& c, std::uint64_t k) { return c.key < k; }) -
          centers.begin());
    };
    const std::size_t begin = first_of(first_key << 3), end = first_of(last_key << 3);
    Elements result;
    result.first_elements = m_communicator.offsets(end - begin);
    const std::uint64_t offset = result.first_elements[m_rank];
    std::uint64_t number_of_split_elements = 0;
    for(std::size_t i = begin; i < end; ++i)
      number_of_split_elements +=
          centers[i].position > 0 || (i + 1 < size && centers[i + 1].key == centers[i].key);
    result.number_of_split_elements = m_communicator.sum(number_of_split_elements);

    // the elements of the part, in the order of their numbers
    result.part.elements.assign(all.elements.begin() + static_cast<std::ptrdiff_t>(first_sheet),
                                all.elements.begin() +
                                    static_cast<std::ptrdiff_t>(first_sheet + number_of_sheets));
    const std::vector<std::uint32_t> first_slots = first_slots_of(result.part.elements, size);
    std::vector<std::uint32_t> number_in_part(size, no_element);
    std::vector<std::vector<Center>> questions(m_ranges.size());
    std::vector<std::vector<std::uint32_t>> places(m_ranges.size());
    for(std::size_t i = 0; i < size; ++i) {
      if(first_slots[i] == no_element)
        continue;
      number_in_part[i] = static_cast<std::uint32_t>(result.part.first_slots.size());
      result.part.first_slots.push_back(first_slots[i]);
      result.numbers.push_back(offset + i - begin);
      if(i >= begin && i < end)
        continue;
      const std::size_t owner = m_ranges.owner(own.level.level, centers[i].key >> 3);
      questions[owner].push_back(centers[i]);
      places[owner].push_back(number_in_part[i]);
    }
    for(Cell_elements& elements : result.part.elements)
      for(std::uint32_t& element : elements)
        if(element != no_element)
          element = number_in_part[element];
    const auto answers = m_communicator.ask(questions, [&](const Center& center) {
      const std::size_t i = first_of(center.key) + center.position;
      const bool is_there = i >= begin && i < end && centers[i].key == center.key;
      return is_there ? offset + i - begin : unknown;
    });
    m_communicator.agree([&] {
      for(std::size_t rank = 0; rank < answers.size(); ++rank)
        for(std::size_t k = 0; k < answers[rank].size(); ++k) {
          check_same(answers[rank][k] != unknown);
          result.numbers[places[rank][k]] = answers[rank][k];
        }
    });
    for(std::size_t i = begin; i < end; ++i)
      result.own_centers.push_back(centers[i].key);
    return result;
  }

private:
  struct Sheet_record {
    std::uint64_t sheet, key;
    std::uint32_t element_mask, unused;
  };
  struct Link_record {
    std::uint64_t sheet, other;
  };
  struct Center {
    std::uint64_t key, position;
  };
  /// the sheets of a cell: the first one, and their number
  struct Cell_answer {
    std::uint64_t first, number;
  };
  /// the center of each element, and its position among those of the same center
  static std::vector<Center> centers_of(const Level_elements& elements, const Octree_level& level) {
    std::vector<Center> result(elements.first_slots.size());
    for(std::size_t i = 0; i < result.size(); ++i) {
      const std::uint32_t slot = elements.first_slots[i];
      const auto [dx, dy, dz] =
          Tensor_basis_3::offset(static_cast<int>(slot % Tensor_basis_3::size));
      result[i].key = Element_numbering::center_key(
          level.cell(slot / Tensor_basis_3::size).neighbor(dx, dy, dz));
      result[i].position =
          i > 0 && result[i - 1].key == result[i].key ? result[i - 1].position + 1 : 0;
    }
    return result;
  }

  /// of each element the first of its slots in a part, or `no_element` if it has none there
  static std::vector<std::uint32_t> first_slots_of(const std::vector<Cell_elements>& part,
                                                   std::size_t number_of_elements) {
    std::vector<std::uint32_t> result(number_of_elements, no_element);
    for(std::size_t sheet = 0; sheet < part.size(); ++sheet)
      for_each_element(part[sheet], [&](int k, std::uint32_t element) {
        const std::size_t slot = Tensor_basis_3::size * sheet + static_cast<std::size_t>(k);
        result[element] = (std::min)(result[element], static_cast<std::uint32_t>(slot));
      });
    return result;
  }

  static constexpr std::uint64_t unknown = (std::numeric_limits<std::uint64_t>::max)();

  /// Ranks see the same faces near their common boundary, but may take those for united that others
  /// do not, where very thin faces connect what is far apart.
  static void check_same(bool is_same) {
    if(!is_same)
      throw Numerical_error(
          "ranks do not find the same pieces of the surface in a cell, because of "
          "faces without width: remove these from the mesh");
  }

  void add_records(const Own_sheets& own, std::uint32_t sheet, std::vector<Sheet_record>& sheets,
                   std::vector<Link_record>& links) const {
    const std::uint64_t offset = own.first_sheet(m_communicator.rank());
    sheets.push_back({offset + sheet, own.level.keys[own.level.cells[sheet]],
                      own.level.element_masks[sheet], 0});
    for(std::uint32_t other : own.level.links[sheet])
      links.push_back({offset + sheet, offset + other});
    auto link = std::lower_bound(own.outer_links.begin(), own.outer_links.end(),
                                 std::pair<std::uint32_t, std::uint64_t>(sheet, 0));
    for(; link != own.outer_links.end() && link->first == sheet; ++link)
      links.push_back({offset + sheet, link->second});
  }

  /// \param sheets in the order of their numbers
  /// \param links of which those to other sheets are left out
  static Octree_level level_of(int level, const std::vector<Sheet_record>& sheets,
                               const std::vector<Link_record>& links) {
    Octree_level result;
    result.level = level;
    for(const Sheet_record& sheet : sheets) {
      if(result.keys.empty() || result.keys.back() != sheet.key) {
        result.keys.push_back(sheet.key);
        result.first_sheets.push_back(static_cast<std::uint32_t>(result.cells.size()));
      }
      result.cells.push_back(static_cast<std::uint32_t>(result.keys.size() - 1));
      result.element_masks.push_back(sheet.element_mask);
    }
    result.first_sheets.push_back(static_cast<std::uint32_t>(result.cells.size()));
    result.index_keys();
    const auto position = [&](std::uint64_t sheet) {
      const auto it = std::lower_bound(
          sheets.begin(), sheets.end(), sheet,
          [](const Sheet_record& record, std::uint64_t number) { return record.sheet < number; });
      return it == sheets.end() || it->sheet != sheet
                 ? sheets.size()
                 : static_cast<std::size_t>(it - sheets.begin());
    };
    std::vector<Number_lists::Pair> pairs;
    for(const Link_record& link : links) {
      const std::size_t a = position(link.sheet), b = position(link.other);
      if(a < sheets.size() && b < sheets.size())
        pairs.emplace_back(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
    }
    result.links = Number_lists(sheets.size(), pairs);
    return result;
  }

  const Communicator& m_communicator;
  const Rank_ranges& m_ranges;
  std::size_t m_rank;
  bool m_is_split, m_is_paper_space, m_is_parallel;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_LEVEL_EXCHANGE_H
