// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRAL_DESCRIPTORS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRAL_DESCRIPTORS_H

/// \file
/// Descriptors of points and of whole surfaces, from eigenvalues and eigenfunctions: heat and wave
/// kernel signatures, spectral embeddings, ShapeDNA. They take what `laplace_spectrum()` returns.

#include <CGAL/Restricted_laplacian_3/spectra/heat_kernel_signature.h>
#include <CGAL/Restricted_laplacian_3/spectra/shape_dna.h>
#include <CGAL/Restricted_laplacian_3/spectra/spectral_embedding.h>
#include <CGAL/Restricted_laplacian_3/spectra/wave_kernel_signature.h>
#include <CGAL/Restricted_laplacian_3/spectra/zero_eigenvalues.h>

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRAL_DESCRIPTORS_H
