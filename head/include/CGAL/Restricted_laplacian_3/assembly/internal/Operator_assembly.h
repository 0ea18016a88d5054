// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_INTERNAL_OPERATOR_ASSEMBLY_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_INTERNAL_OPERATOR_ASSEMBLY_H

#include <CGAL/Restricted_laplacian_3/assembly/Operator_sink.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/integration/Surface_integration.h>
#include <CGAL/Restricted_laplacian_3/integration/shared/sheet_integrals.h>
#include <CGAL/Restricted_laplacian_3/integration/shared/sheet_kernels.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// What is assembled on a level; a null pointer is left out.
struct Assembly_targets {
  Operator_sink* sink = nullptr;
  /// \f$\int b_i\f$, and \f$\int w\, b_i\f$ with the weight of the mass
  Eigen::VectorXd *integrals = nullptr, *weighted_integrals = nullptr;

  bool is_empty() const { return !sink && !integrals && !weighted_integrals; }
};

/// of the time of an assembly, that of the patterns of the matrices
constexpr double part_of_pattern = 0.2;

/// Assembles the operators of several levels in one pass over the surface.
///
/// *Stages.* A stage computes the moments and adds the blocks of two levels, top and top - 1, and
/// hands the moments of level top - 2 to the next stage; the first one starts from the surface. Its
/// unit of work is a cell of level top - 2 with all that it contains, up to 4 x 4 x 4 cells of the
/// top level: the moments of these few sheets are the only ones held besides those of top - 2.
///
/// *Colors.* Cells of level top - 2 of the same parity along all axes, one of 8 colors, are at
/// least 2 cells of level top - 1 (4 of top) apart. Elements reach one cell beyond the sheets that
/// they act on, so no two cells of a color add to the same entry: they can be done at once. The
/// colors follow one after the other, also on one thread. So all sums are formed in the same
/// order, whatever the number of threads.
class Operator_assembly {
public:
  /// \param mass_weight of the mass matrix; may be null
  Operator_assembly(const Spline_space_3& space, const Mass_weight* mass_weight,
                    double stabilization, bool stabilizes_mass)
    : m_space(space), m_octree(space.octree()), m_integration(space.integration_with_material()),
      m_mass_weight(mass_weight), m_normal_stabilization(stabilization),
      m_stabilizes_mass(stabilizes_mass) {}

  /// Assembles everything in one pass over the surface.
  /// \param targets of each level of the octree
  void run(const std::vector<Assembly_targets>& targets, const Progress& progress) {
    m_targets = targets;
    int coarsest = 0;
    while(coarsest < m_octree.depth() && m_targets[coarsest].is_empty())
      ++coarsest;
    bool wants_mass = false;
    for(const Assembly_targets& t : m_targets)
      wants_mass = wants_mass || (t.sink && t.sink->wants_mass());
    m_keeps_stabilization = wants_mass && m_stabilizes_mass && m_normal_stabilization != 0;
    // Where the metric is not constant on each face, the degree is not known.
    m_degree = wants_mass || !m_integration.adds_moments() ? degree_of_mass : degree_of_stiffness;
    double done = 0, remaining = 1;
    for(int top = m_octree.depth(); top >= coarsest; top -= 2) {
      Moments next;
      if(top - 2 >= coarsest)
        next.resize(m_octree.number_of_sheets(top - 2), m_keeps_stabilization);
      run_stage(top, coarsest, next, progress.part(done, 1 - remaining * sixteenth));
      m_moments = std::move(next);
      remaining *= sixteenth;
      done = 1 - remaining;
    }
    for(const Assembly_targets& t : m_targets)
      if(t.sink)
        t.sink->finish();
    progress(1);
  }

private:
  /// of the cells of a level the next stage has that many
  static constexpr double sixteenth = 1. / 16;
  /// products of elements, and of their derivatives, on a plane
  static constexpr int degree_of_mass = 12, degree_of_stiffness = 10;
  /// cells of one color after which the progress is told
  static constexpr std::size_t cells_of_a_step = 256;

  /// moments of sheets, and those of the stabilization alone, if the mass matrix takes it
  struct Moments {
    std::vector<Sheet_moments> values, stabilization;

    void resize(std::size_t size, bool keeps_stabilization) {
      values.resize(size);
      for(Sheet_moments& m : values)
        m.clear();
      stabilization.resize(keeps_stabilization ? size : 0);
      for(Sheet_moments& m : stabilization)
        m.clear();
    }
  };

  /// what a thread needs for one unit of work
  struct Scratch {
    Moments top, middle;
    Packed_blocks stiffness, mass, plain_mass, stabilization;
  };

  /// half-open range of numbers of sheets
  struct Range {
    std::size_t begin, end;
    std::size_t size() const { return end - begin; }
  };

  void run_stage(int top, int coarsest, Moments& next, const Progress& progress) {
    const int level = (std::max)(top - 2, 0);
    std::array<std::vector<std::uint32_t>, 8> cells_of_color;
    const std::size_t number_of_cells = m_octree.number_of_cells(level);
    for(std::size_t i = 0; i < number_of_cells; ++i)
      cells_of_color[m_octree.cell(level, m_octree.sheets(level, i)[0]).octant()].push_back(
          static_cast<std::uint32_t>(i));
    std::size_t done = 0;
    for(const auto& cells : cells_of_color)
      for(std::size_t first = 0; first < cells.size(); first += cells_of_a_step) {
        const std::size_t last = (std::min)(first + cells_of_a_step, cells.size());
        progress(static_cast<double>(done) / static_cast<double>(number_of_cells));
        parallel_for(m_space.options().is_parallel, first, last, 2,
                     [&](std::size_t begin, std::size_t end) {
                       std::unique_ptr<Scratch> scratch = take_scratch();
                       for(std::size_t i = begin; i < end; ++i)
                         run_cell(top, coarsest, level, cells[i], next, *scratch);
                       give_back(std::move(scratch));
                     });
        done += last - first;
      }
  }

  void run_cell(int top, int coarsest, int level, std::size_t cell, Moments& next,
                Scratch& scratch) {
    // The sheets of a cell have consecutive numbers, on all finer levels.
    const auto sheets = m_octree.sheets(level, cell);
    std::array<Range, 3> ranges;
    ranges[0] = {sheets[0], sheets[1]};
    for(int l = level; l < top; ++l)
      ranges[l + 1 - level] = children(l, ranges[l - level]);
    const Range of_top = ranges[top - level];

    const bool is_finest = top == m_octree.depth();
    if(is_finest)
      integrate(of_top, scratch.top);
    const std::size_t offset = is_finest ? of_top.begin : 0;
    const Moments& moments = is_finest ? scratch.top : m_moments;
    add_blocks(top, of_top, moments, offset, scratch);
    if(top - 1 < coarsest)
      return;

    const Range of_middle = ranges[top - 1 - level];
    scratch.middle.resize(of_middle.size(), m_keeps_stabilization);
    add_to_parents(top, of_top, moments, offset, scratch.middle, of_middle.begin);
    add_blocks(top - 1, of_middle, scratch.middle, of_middle.begin, scratch);
    if(top - 2 >= coarsest)
      add_to_parents(top - 1, of_middle, scratch.middle, of_middle.begin, next, 0);
  }

  Range children(int level, const Range& sheets) const {
    Range result = {m_octree.number_of_sheets(level + 1), 0};
    for(std::size_t sheet = sheets.begin; sheet < sheets.end; ++sheet) {
      const auto children = m_octree.children(level, sheet);
      if(children.empty()) // in a part of an octree
        continue;
      result.begin = (std::min)(result.begin, static_cast<std::size_t>(children.front()));
      result.end = (std::max)(result.end, static_cast<std::size_t>(children.back()) + 1);
    }
    result.begin = (std::min)(result.begin, result.end);
    return result;
  }

  void integrate(const Range& sheets, Moments& moments) const {
    moments.resize(sheets.size(), m_keeps_stabilization);
    Sheet_integrals integrals;
    integrals.degree = m_degree;
    for(std::size_t i = 0; i < sheets.size(); ++i) {
      integrals.clear();
      add_sheet_integrals(m_space.surface(), m_integration, m_mass_weight, sheets.begin + i,
                          integrals);
      Sheet_moments& m = moments.values[i];
      m = integrals.moments;
      if(m_normal_stabilization == 0)
        continue;
      const Sheet_stabilization added(integrals, m_normal_stabilization, walls(sheets.begin + i));
      // the means in the sheet; no sample in the cell
      const double area = integrals.area(), diffusion = integrals.mean_diffusion(),
                   mass_weight = area > 0 ? m.sum(Sheet_moments::mass) / area : 0;
      for(int j = 0; j < number_of_moments; ++j)
        for(int k = 0; k < 6; ++k) {
          m.values[j][k] += diffusion * added(j, k);
          if(m_keeps_stabilization)
            moments.stabilization[i].values[j][k] = mass_weight * added(j, k);
        }
    }
  }

  /// The walls in which a sheet of the finest level lies. An element beside its cell vanishes on
  /// the walls opposite to it, and only there: where the sheet does not meet it, it lies in these
  /// walls. Of several such elements that with the fewest walls counts.
  Sheet_stabilization::Walls walls(std::size_t sheet) const {
    Sheet_stabilization::Walls result = {0, 0, 0};
    int fewest = 4;
    for(int dz = -1; dz <= 1; ++dz)
      for(int dy = -1; dy <= 1; ++dy)
        for(int dx = -1; dx <= 1; ++dx) {
          const int number = std::abs(dx) + std::abs(dy) + std::abs(dz);
          if(number < fewest && !m_octree.meets_element(m_octree.depth(), sheet, dx, dy, dz)) {
            fewest = number;
            result = {-dx, -dy, -dz};
          }
        }
    return result;
  }

  /// \param offset,parent_offset numbers of the sheets whose moments are the first ones
  void add_to_parents(int level, const Range& sheets, const Moments& moments, std::size_t offset,
                      Moments& parents, std::size_t parent_offset) const {
    for(std::size_t sheet = sheets.begin; sheet < sheets.end; ++sheet) {
      const std::size_t parent = m_octree.parent(level, sheet) - parent_offset;
      const int octant = m_octree.cell(level, sheet).octant();
      add_child_moments(moments.values[sheet - offset], octant, parents.values[parent]);
      if(m_keeps_stabilization)
        add_child_moments(moments.stabilization[sheet - offset], octant,
                          parents.stabilization[parent]);
    }
  }

  /// adds the blocks of some sheets to the targets of their level, four at once
  void add_blocks(int level, const Range& sheets, const Moments& moments, std::size_t offset,
                  Scratch& scratch) const {
    const Assembly_targets& targets = m_targets[level];
    if(targets.is_empty())
      return;
    const double h = m_octree.cell_width(level), finest_h = m_octree.cell_width(m_octree.depth());
    const Packed_blocks& plain_mass = m_keeps_stabilization ? scratch.plain_mass : scratch.mass;
    for(std::size_t first = sheets.begin; first < sheets.end; first += 4) {
      const std::size_t count = (std::min)(std::size_t(4), sheets.end - first);
      std::array<const Sheet_moments*, 4> of_sheets, of_stabilization;
      for(std::size_t lane = 0; lane < 4; ++lane) {
        const std::size_t i = first - offset + (std::min)(lane, count - 1);
        of_sheets[lane] = &moments.values[i];
        of_stabilization[lane] = m_keeps_stabilization ? &moments.stabilization[i] : nullptr;
      }
      if(targets.sink && targets.sink->wants_stiffness())
        stiffness_blocks(of_sheets, scratch.stiffness);
      if(targets.sink && targets.sink->wants_mass()) {
        mass_blocks(of_sheets, scratch.mass);
        if(m_keeps_stabilization)
          stiffness_blocks(of_stabilization, scratch.stabilization);
        for(std::size_t lane = 0; lane < count; ++lane) {
          auto& values = scratch.mass.values[lane];
          for(double& entry : values)
            entry *= h * h;
          if(!m_keeps_stabilization)
            continue;
          scratch.plain_mass.values[lane] = values;
          for(std::size_t i = 0; i < values.size(); ++i)
            values[i] += finest_h * finest_h * scratch.stabilization.values[lane][i];
        }
      }
      for(std::size_t lane = 0; lane < count; ++lane) {
        const Cell_elements& elements = m_space.elements(level, first + lane);
        if(targets.sink)
          targets.sink->add_all(elements, Sheet_block(scratch.stiffness.values[lane].data()),
                                Sheet_block(scratch.mass.values[lane].data()),
                                Sheet_block(plain_mass.values[lane].data()));
        if(targets.integrals)
          add_integrals(elements, *of_sheets[lane], Sheet_moments::area, h * h, *targets.integrals);
        if(targets.weighted_integrals)
          add_integrals(elements, *of_sheets[lane], Sheet_moments::mass, h * h,
                        *targets.weighted_integrals);
      }
    }
  }

  static void add_integrals(const Cell_elements& elements, const Sheet_moments& moments,
                            int component, double factor, Eigen::VectorXd& sums) {
    const Tensor_basis_3::Values integrals = element_integrals(moments, component);
    for_each_element(elements,
                     [&](int i, std::uint32_t element) { sums[element] += factor * integrals[i]; });
  }

  std::unique_ptr<Scratch> take_scratch() {
    const std::lock_guard<std::mutex> lock(m_mutex);
    if(m_scratch.empty())
      return std::make_unique<Scratch>();
    std::unique_ptr<Scratch> scratch = std::move(m_scratch.back());
    m_scratch.pop_back();
    return scratch;
  }

  void give_back(std::unique_ptr<Scratch> scratch) {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_scratch.push_back(std::move(scratch));
  }

  const Spline_space_3& m_space;
  const Octree_3& m_octree;
  Surface_integration m_integration;
  const Mass_weight* m_mass_weight;
  double m_normal_stabilization;
  bool m_stabilizes_mass;
  std::vector<Assembly_targets> m_targets;
  bool m_keeps_stabilization = false;
  int m_degree = degree_of_mass;
  Moments m_moments; // of the top level of a stage, but the first
  std::mutex m_mutex;
  std::vector<std::unique_ptr<Scratch>> m_scratch;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_INTERNAL_OPERATOR_ASSEMBLY_H
