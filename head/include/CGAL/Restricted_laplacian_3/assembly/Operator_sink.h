// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_OPERATOR_SINK_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_OPERATOR_SINK_H

#include <CGAL/Restricted_laplacian_3/basis/Tensor_basis_3.h>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Operators
/// A symmetric block of the integrals over one sheet: an entry for each pair of elements of the
/// cell, numbered as in `Tensor_basis_3`.
class Sheet_block {
public:
  /// \cond
  explicit Sheet_block(const double* upper_half) : m_upper_half(upper_half) {}
  // the entries (i, j), at element_pairs[i][j]
  const double* upper_half() const { return m_upper_half; }
  /// \endcond

  /// entry \f$(i, j)\f$
  double operator()(int i, int j) const { return m_upper_half[internal::element_pairs[i][j]]; }

private:
  const double* m_upper_half;
};

/// \ingroup PkgRestrictedLaplacian3Operators
/// Where assembled matrices of a level go: a base class for what stores them.
/// `assemble_operators()` goes through the sheets of the level and gives their blocks to `add()`;
/// the matrices are the sums of all blocks. Which elements are coupled is known beforehand: those
/// that act on the same sheet.
class Operator_sink {
public:
  virtual ~Operator_sink() = default;

  /// whether stiffness blocks are needed
  virtual bool wants_stiffness() const { return true; }
  /// whether mass blocks are needed
  virtual bool wants_mass() const { return true; }

  /// Adds the blocks of a sheet. With several threads it is called at the same time only for sheets
  /// that have no element in common; elements of one may be coupled with those of another.
  /// \param elements the elements of the sheet, `no_element` where there is none
  /// \param stiffness without unit; not to be read unless `wants_stiffness()`
  /// \param mass in units of area; not to be read unless `wants_mass()`
  virtual void add(const Cell_elements& elements, const Sheet_block& stiffness,
                   const Sheet_block& mass) = 0;

  /// \cond
  // The same, also with the mass before it is stabilized; this is what is called.
  virtual void add_all(const Cell_elements& elements, const Sheet_block& stiffness,
                       const Sheet_block& mass, const Sheet_block& /* plain_mass */) {
    add(elements, stiffness, mass);
  }
  /// \endcond

  /// called once, after the last block
  virtual void finish() {}
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_OPERATOR_SINK_H
