// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Restricted_laplacian_3/foundation/internal/Single_blas_thread_impl.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/operating_system_impl.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for_impl.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/symmetric_eigenpairs_impl.h>
#include <CGAL/Restricted_laplacian_3/foundation/memory_impl.h>
