# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Says at the end of a configuration what was found and what is off. The libraries that only our
# own programs use are looked for again by those who use them: they can be built on their own.

find_package(TBB QUIET)
find_package(OpenMesh CONFIG QUIET)
find_package(PNG QUIET)
find_package(Boost QUIET COMPONENTS program_options)
find_package(Catch2 CONFIG QUIET)
find_package(benchmark CONFIG QUIET)
find_package(Doxygen QUIET)
find_path(HYPRE_INCLUDE_DIR NAMES HYPRE.h PATH_SUFFIXES hypre)
mark_as_advanced(HYPRE_INCLUDE_DIR)

function(summarize name value)
  string(LENGTH "${name}" length)
  foreach(i RANGE ${length} 18)
    string(APPEND name " ")
  endforeach()
  message(STATUS "  ${name}${value}")
endfunction()

# summarize_package(name found value_if_found value_if_not)
function(summarize_package name found value_if_found value_if_not)
  if(found)
    summarize("${name}" "${value_if_found}")
  else()
    summarize("${name}" "not found; ${value_if_not}")
  endif()
endfunction()

message(STATUS "Restricted_laplacian_3 ${PROJECT_VERSION}:")
summarize("build type" "${CMAKE_BUILD_TYPE}")
summarize("sanitizers" "${RESTRICTED_LAPLACIAN_3_SANITIZE}")
summarize("CGAL" "${CGAL_VERSION}")
# CGAL 5 finds Eigen by a module of its own.
summarize("Eigen" "${EIGEN3_VERSION}${Eigen3_VERSION}")
summarize_package("CHOLMOD" "${CHOLMOD_FOUND}" "${CHOLMOD_LIBRARY}"
  "direct factors are Eigen's")
if(CHOLMOD_FOUND)
  if(CHOLMOD_BLAS MATCHES "openblas")
    summarize("BLAS of CHOLMOD" "OpenBLAS (${CHOLMOD_BLAS})")
  elseif(CHOLMOD_BLAS)
    summarize("BLAS of CHOLMOD" "${CHOLMOD_BLAS}; not OpenBLAS: direct factors are slower")
  else()
    summarize("BLAS of CHOLMOD" "unknown")
  endif()
endif()
summarize_package("Spectra" "${Spectra_INCLUDE_DIR}" "${Spectra_INCLUDE_DIR}"
  "laplace_spectrum, its example and its tests are off")
summarize_package("TBB" "${TBB_FOUND}" "${TBB_VERSION}" "programs run on one thread")
summarize_package("PETSc over MPI" "${RESTRICTED_LAPLACIAN_3_PETSC}"
  "${RESTRICTED_LAPLACIAN_3_PETSC}" "programs for several machines are off")
summarize_package("OpenMesh" "${OpenMesh_FOUND}" "found"
  "examples and tests on OpenMesh meshes are off")
summarize_package("libpng" "${PNG_FOUND}" "${PNG_VERSION_STRING}"
  "the tool draw_mesh, which draws pictures, is off")
find_package(ZLIB QUIET)
set(npm_program "")
if(NODE_PROGRAM AND NPM_PROGRAM)
  set(npm_program "${NPM_PROGRAM}")
endif()
summarize_package("Node.js and npm" "${npm_program}" "${npm_program}"
  "HTML pages (--html) are off")
summarize_package("zlib" "${ZLIB_FOUND}" "${ZLIB_VERSION_STRING}"
  "programs for the command line are off")
summarize_package("program_options" "${Boost_PROGRAM_OPTIONS_FOUND}" "Boost ${Boost_VERSION}"
  "programs for the command line are off")
summarize_package("Catch2" "${Catch2_FOUND}" "${Catch2_VERSION}" "unit tests are off")
summarize_package("Google Benchmark" "${benchmark_FOUND}" "${benchmark_VERSION}"
  "micro-benchmarks are off")
summarize_package("hypre" "${HYPRE_INCLUDE_DIR}" "${HYPRE_INCLUDE_DIR}"
  "the benchmark against BoomerAMG is off")
summarize_package("Doxygen" "${DOXYGEN_FOUND}" "${DOXYGEN_VERSION}" "the manual is off")
if(needs_meshes)
  summarize_package("CGAL's data" "${RESTRICTED_LAPLACIAN_3_DATA_DIR}"
    "${RESTRICTED_LAPLACIAN_3_DATA_DIR}" "tests on its meshes are skipped")
  summarize_package("shared meshes" "${RESTRICTED_LAPLACIAN_3_SHARED_MESHES}"
    "${RESTRICTED_LAPLACIAN_3_SHARED_MESHES}" "tests on them are skipped")
endif()
foreach(part PROGRAMS TESTS EXAMPLES BENCHMARKS VIEWER DOC)
  string(TOLOWER "${part}" name)
  summarize("${name}" "${RESTRICTED_LAPLACIAN_3_BUILD_${part}}")
endforeach()
