// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Restricted_laplacian_3/spectra/heat_kernel_signature_impl.h>
#include <CGAL/Restricted_laplacian_3/spectra/shape_dna_impl.h>
#include <CGAL/Restricted_laplacian_3/spectra/shared/Factorized_matrix_impl.h>
#include <CGAL/Restricted_laplacian_3/spectra/smallest_eigenpairs_impl.h>
#include <CGAL/Restricted_laplacian_3/spectra/spectral_embedding_impl.h>
#include <CGAL/Restricted_laplacian_3/spectra/wave_kernel_signature_impl.h>
#include <CGAL/Restricted_laplacian_3/spectra/zero_eigenvalues_impl.h>
