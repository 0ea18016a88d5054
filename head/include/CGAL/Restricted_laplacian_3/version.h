// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_VERSION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_VERSION_H

/// \file
/// The version of the package. This is the only place where it stands: the build system reads it
/// from here.

/// \ingroup PkgRestrictedLaplacian3Version
/// A release that breaks programs increments it, once it is not 0.
#define CGAL_RESTRICTED_LAPLACIAN_3_VERSION_MAJOR 0

/// \ingroup PkgRestrictedLaplacian3Version
/// A release with new functions increments it; so does one that breaks programs, as long as the
/// major number is 0.
#define CGAL_RESTRICTED_LAPLACIAN_3_VERSION_MINOR 2

/// \ingroup PkgRestrictedLaplacian3Version
/// A release with corrections only increments it.
#define CGAL_RESTRICTED_LAPLACIAN_3_VERSION_PATCH 0

/// \ingroup PkgRestrictedLaplacian3Version
/// A number for each version, of the form of \cgal's `CGAL_VERSION_NUMBER(x, y, z)`.
#define CGAL_RESTRICTED_LAPLACIAN_3_VERSION_NUMBER(x, y, z)                                        \
  ((1000001 + 10000 * (x) + 100 * (y) + 10 * (z)) * 1000)

/// \ingroup PkgRestrictedLaplacian3Version
/// The number of this version, to be compared with
/// `CGAL_RESTRICTED_LAPLACIAN_3_VERSION_NUMBER(x, y, z)`, also in `#if`.
#define CGAL_RESTRICTED_LAPLACIAN_3_VERSION_NR                                                     \
  CGAL_RESTRICTED_LAPLACIAN_3_VERSION_NUMBER(CGAL_RESTRICTED_LAPLACIAN_3_VERSION_MAJOR,            \
                                             CGAL_RESTRICTED_LAPLACIAN_3_VERSION_MINOR,            \
                                             CGAL_RESTRICTED_LAPLACIAN_3_VERSION_PATCH)

/// \cond
#define CGAL_RESTRICTED_LAPLACIAN_3_QUOTE(x, y, z) #x "." #y "." #z
#define CGAL_RESTRICTED_LAPLACIAN_3_EXPAND_AND_QUOTE(x, y, z)                                      \
  CGAL_RESTRICTED_LAPLACIAN_3_QUOTE(x, y, z)
/// \endcond

/// \ingroup PkgRestrictedLaplacian3Version
/// The version as a string, such as `"0.2.0"`.
#define CGAL_RESTRICTED_LAPLACIAN_3_VERSION                                                        \
  CGAL_RESTRICTED_LAPLACIAN_3_EXPAND_AND_QUOTE(CGAL_RESTRICTED_LAPLACIAN_3_VERSION_MAJOR,          \
                                               CGAL_RESTRICTED_LAPLACIAN_3_VERSION_MINOR,          \
                                               CGAL_RESTRICTED_LAPLACIAN_3_VERSION_PATCH)

#endif // CGAL_RESTRICTED_LAPLACIAN_3_VERSION_H
