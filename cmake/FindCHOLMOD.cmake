# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Finds CHOLMOD of SuiteSparse, which has no CMake package of its own before version 7.
# Sets CHOLMOD_FOUND, CHOLMOD_INCLUDE_DIR, CHOLMOD_LIBRARY, and CHOLMOD_BLAS: the BLAS library that
# a shared CHOLMOD loads on this machine, all symbolic links resolved, empty if unknown.

find_path(CHOLMOD_INCLUDE_DIR NAMES cholmod.h PATH_SUFFIXES suitesparse)
find_library(CHOLMOD_LIBRARY NAMES cholmod)
find_library(CHOLMOD_BLAS_LIBRARY NAMES libblas.so.3 blas openblas)
mark_as_advanced(CHOLMOD_INCLUDE_DIR CHOLMOD_LIBRARY CHOLMOD_BLAS_LIBRARY)

set(CHOLMOD_BLAS "")
if(CHOLMOD_BLAS_LIBRARY)
  get_filename_component(CHOLMOD_BLAS "${CHOLMOD_BLAS_LIBRARY}" REALPATH)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CHOLMOD REQUIRED_VARS CHOLMOD_LIBRARY CHOLMOD_INCLUDE_DIR)
