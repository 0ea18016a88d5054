// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_COMPILED_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_COMPILED_H

#include <CGAL/license/Restricted_laplacian_3.h>

// The package is used as headers only, or compiled once. `Foo.h` declares, `Foo_impl.h` defines
// what depends on no type of the caller; `Foo.h` includes it at its end, unless the macro
// `CGAL_RESTRICTED_LAPLACIAN_3_COMPILED` says that the program is linked with the library, whose
// sources include it. Definitions outside of a class begin with the macro below.

#ifdef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#define CGAL_RESTRICTED_LAPLACIAN_3_INLINE
#else
#define CGAL_RESTRICTED_LAPLACIAN_3_INLINE inline
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_COMPILED_H
