// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_LICENSE_RESTRICTED_LAPLACIAN_3_H
#define CGAL_LICENSE_RESTRICTED_LAPLACIAN_3_H

// What CGAL has for each of its packages under the GPL: programs that define CGAL_LICENSE_WARNING
// or CGAL_LICENSE_ERROR are told of the license. There is no commercial license for this package.

#include <CGAL/config.h>
#include <CGAL/license.h>

#ifdef CGAL_LICENSE_WARNING
CGAL_pragma_warning("You use the package Restricted_laplacian_3 under the terms of the GPLv3+.")
#endif

#ifdef CGAL_LICENSE_ERROR
#error "You use the package Restricted_laplacian_3 under the terms of the GPLv3+. \
You get this error, as you defined CGAL_LICENSE_ERROR."
#endif

#endif // CGAL_LICENSE_RESTRICTED_LAPLACIAN_3_H
