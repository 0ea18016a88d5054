// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PROGRAMS_SCAN_INPUT_H
#define RESTRICTED_LAPLACIAN_3_PROGRAMS_SCAN_INPUT_H

// Reads colored scans from PLY files: meshes, or points with or without normals.

#include "program.h"

#include <CGAL/Restricted_laplacian_3/textures/Colored_scan.h>

#include <string>

namespace programs {

RL::Colored_scan read_scan(const std::string& file, const RL::Scan_pose& pose, bool is_parallel);

} // namespace programs

#endif // RESTRICTED_LAPLACIAN_3_PROGRAMS_SCAN_INPUT_H
