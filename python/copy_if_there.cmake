# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Copies the file `from` to `to`, if there is one.

if(EXISTS "${from}")
  configure_file("${from}" "${to}" COPYONLY)
endif()
