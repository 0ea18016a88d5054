// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_PETSC_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_PETSC_H

#include <CGAL/Restricted_laplacian_3/distributed/Communicator.h>

#include <petsc/private/petscimpl.h>
#include <petscksp.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// what PETSc says of an error; the last type differs from version to version
template <class Char>
std::string petsc_message(PetscErrorCode (*message)(PetscErrorCode, const char*[], Char*[]),
                          PetscErrorCode code) {
  const char* text = nullptr;
  Char* specific = nullptr;
  message(code, &text, &specific);
  std::string result = "PETSc: ";
  if(text)
    result += text;
  if(specific && *specific)
    result += std::string(": ") + specific;
  return result;
}

/// \throws std::bad_alloc if PETSc has no memory, which other ranks may not know of
/// \throws Distributed_error if a function of PETSc has failed for another reason
inline void petsc_check(PetscErrorCode code) {
  if(code == 0)
    return;
  if(code == PETSC_ERR_MEM)
    throw std::bad_alloc();
  throw Distributed_error(petsc_message(PetscErrorMessage, code));
}

/// Owns an object of PETSc.
template <class Object, PetscErrorCode (*destroy)(Object*)> class Petsc_handle {
public:
  Petsc_handle() = default;
  Petsc_handle(const Petsc_handle&) = delete;
  Petsc_handle& operator=(const Petsc_handle&) = delete;
  Petsc_handle(Petsc_handle&& other) noexcept : m_object(other.m_object) {
    other.m_object = nullptr;
  }
  Petsc_handle& operator=(Petsc_handle&& other) noexcept {
    std::swap(m_object, other.m_object);
    return *this;
  }
  ~Petsc_handle() {
    if(m_object)
      destroy(&m_object);
  }

  /// for a function that makes an object
  Object* address() { return &m_object; }
  operator Object() const { return m_object; }

private:
  Object m_object = nullptr;
};

using Petsc_matrix = Petsc_handle<Mat, MatDestroy>;
using Petsc_vector = Petsc_handle<Vec, VecDestroy>;
using Petsc_solver = Petsc_handle<KSP, KSPDestroy>;
using Petsc_scatter = Petsc_handle<VecScatter, VecScatterDestroy>;
using Petsc_null_space = Petsc_handle<MatNullSpace, MatNullSpaceDestroy>;

/// \throws Parameter_error if there are more numbers than PETSc's indices can hold
inline PetscInt petsc_int(std::uint64_t number) {
  if(number > static_cast<std::uint64_t>((std::numeric_limits<PetscInt>::max)()))
    throw Parameter_error("depth", "gives more unknowns or entries, " + std::to_string(number) +
                                       ", than this PETSc can number: it needs one with "
                                       "indices of 64 bits");
  return static_cast<PetscInt>(number);
}

/// the entries of a vector that this rank has
inline std::vector<double> values_of(Vec v) {
  PetscInt size = 0;
  const PetscScalar* values = nullptr;
  petsc_check(VecGetLocalSize(v, &size));
  petsc_check(VecGetArrayRead(v, &values));
  std::vector<double> result(values, values + size);
  petsc_check(VecRestoreArrayRead(v, &values));
  return result;
}

/// What a function returns of the entries on this rank: those of `b`, and of `x`, to be written.
template <class Function> PetscErrorCode with_entries(Vec b, Vec x, Function&& function) {
  const PetscScalar* from = nullptr;
  PetscScalar* to = nullptr;
  PetscCall(VecGetArrayRead(b, &from));
  PetscCall(VecGetArrayWrite(x, &to));
  const PetscErrorCode result = function(from, to);
  PetscCall(VecRestoreArrayWrite(x, &to));
  PetscCall(VecRestoreArrayRead(b, &from));
  return result;
}

/// \param values the entries that this rank has
inline void set_values(Vec v, const std::vector<double>& values) {
  PetscScalar* entries = nullptr;
  petsc_check(VecGetArrayWrite(v, &entries));
  std::copy(values.begin(), values.end(), entries);
  petsc_check(VecRestoreArrayWrite(v, &entries));
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_PETSC_H
