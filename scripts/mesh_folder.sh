# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# For scripts that run commands of the manual; they source this file.

# enter_mesh_folder DATA_DIR: into a new folder that begins as DATA_DIR, CGAL's meshes, beside its points, and
# vanishes at the end. The folder above it, in `folder`, is for other files.
enter_mesh_folder() {
  local data
  data=$(cd "$1" && pwd)
  folder=$(mktemp -d)
  trap 'rm -rf "$folder"' EXIT
  mkdir "$folder/meshes"
  ln -s "$data"/* "$folder/meshes"
  ln -s "$data/../points_3" "$folder/points_3"
  cd "$folder/meshes" || return
}
