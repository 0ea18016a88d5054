# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

import restricted_laplacian as rl

# a sphere: points (n, 3), triangles (m, 3)
V, F = rl.icosphere(4)
# of a file: rl.read_mesh("bunny.ply")
# Laplacian u = z
u = rl.solve_poisson(V, F, V[:, 2])
# eigenvalues, eigenfunctions
l, phi = rl.eigs(V, F, 50)
print(l[1])
rl.View(V, F, phi).save_html("phi.html")
