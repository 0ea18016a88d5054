// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_INTERNAL_SPARSE_SINK_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_INTERNAL_SPARSE_SINK_H

#include <CGAL/Restricted_laplacian_3/assembly/Operator_sink.h>
#include <CGAL/Restricted_laplacian_3/assembly/internal/Element_matrix_pattern.h>
#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Object_pool.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Sparse matrices of Eigen, each a combination of stiffness and mass. They have the same pattern,
/// which is made first; then the upper halves are filled, and copied to the lower ones if these are
/// stored.
class Sparse_sink : public Operator_sink {
public:
  struct Target {
    Sparse_matrix* matrix;
    double stiffness_factor, mass_factor;
    /// of the mass without stabilization
    double plain_mass_factor = 0;
  };

  /// \param targets at least one; the matrices must outlive this object, their old content is lost
  Sparse_sink(const Spline_space_3& space, int level, std::vector<Target> targets,
              Stored_entries stored = Stored_entries::all)
    : m_targets(std::move(targets)), m_stored(stored), m_is_parallel(space.options().is_parallel),
      m_dimension(space.dimension(level)) {
    Element_matrix_pattern(space, level).zero_matrix(stored).swap(*m_targets.front().matrix);
    for(std::size_t i = 1; i < m_targets.size(); ++i)
      *m_targets[i].matrix = *m_targets.front().matrix;
  }

  bool wants_stiffness() const override {
    return std::any_of(m_targets.begin(), m_targets.end(),
                       [](const Target& t) { return t.stiffness_factor != 0; });
  }
  bool wants_mass() const override {
    return std::any_of(m_targets.begin(), m_targets.end(), [](const Target& t) {
      return t.mass_factor != 0 || t.plain_mass_factor != 0;
    });
  }

  void add(const Cell_elements& elements, const Sheet_block& stiffness,
           const Sheet_block& mass) override {
    add_all(elements, stiffness, mass, mass);
  }

  /// Goes once through the columns of the elements, down to the diagonal, and adds 0 to rows of
  /// other sheets: one sum for each row costs less than a search for the rows of this sheet.
  void add_all(const Cell_elements& elements, const Sheet_block& stiffness, const Sheet_block& mass,
               const Sheet_block& plain_mass) override {
    m_pool.borrow([&] { return Numbers(m_dimension, not_of_this_sheet); },
                  [&](Numbers& numbers) {
                    for_each_element(elements, [&](int i, std::uint32_t element) {
                      numbers[element] = static_cast<unsigned char>(i);
                    });
                    add_columns(elements, numbers.data(), stiffness, mass, plain_mass);
                    for_each_element(elements, [&](int, std::uint32_t element) {
                      numbers[element] = not_of_this_sheet;
                    });
                  });
  }

  void finish() override {
    if(m_stored == Stored_entries::upper_half)
      return;
    std::vector<Sparse_matrix*> matrices;
    for(const Target& target : m_targets)
      matrices.push_back(target.matrix);
    mirror_upper_half(matrices, m_is_parallel);
  }

private:
  /// of each element of the level, its number in the sheet that is added
  using Numbers = std::vector<unsigned char>;
  static constexpr unsigned char not_of_this_sheet = Tensor_basis_3::size;

  void add_columns(const Cell_elements& elements, const unsigned char* numbers,
                   const Sheet_block& stiffness, const Sheet_block& mass,
                   const Sheet_block& plain_mass) const {
    const int* const outer = m_targets.front().matrix->outerIndexPtr();
    const int* const inner = m_targets.front().matrix->innerIndexPtr();
    for_each_element(elements, [&](int j, std::uint32_t element) {
      const int begin = outer[element];
      const int end = static_cast<int>(
          std::upper_bound(inner + begin, inner + outer[element + 1], static_cast<int>(element)) -
          inner);
      for(const Target& target : m_targets) {
        double* const values = target.matrix->valuePtr();
        const auto add_times = [&](double factor, const double* entries) {
          if(factor == 0)
            return;
          std::array<double, Tensor_basis_3::size + 1> column;
          for(int i = 0; i < Tensor_basis_3::size; ++i)
            column[i] = factor * entries[element_pairs[j][i]];
          column[not_of_this_sheet] = 0;
          for(int k = begin; k < end; ++k)
            values[k] += column[numbers[inner[k]]];
        };
        add_times(target.stiffness_factor, stiffness.upper_half());
        add_times(target.mass_factor, mass.upper_half());
        add_times(target.plain_mass_factor, plain_mass.upper_half());
      }
    });
  }

  std::vector<Target> m_targets;
  Stored_entries m_stored;
  bool m_is_parallel;
  std::size_t m_dimension;
  Object_pool<Numbers> m_pool;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_INTERNAL_SPARSE_SINK_H
