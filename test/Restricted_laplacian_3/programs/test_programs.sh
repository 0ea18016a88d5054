#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Tests what the programs promise, and that the examples run: exit status, one-line errors, files and their contents.
#
# usage: test_programs.sh BUILD_DIR DATA_DIR [GROUP]...
#
# BUILD_DIR holds the programs and examples. DATA_DIR holds meshes of CGAL's data; what needs one is skipped,
# and said so, if it is not there. The groups, all by default, are the functions test_* below.

set -u -o pipefail
export LC_ALL=C

if [ $# -lt 2 ] || [ ! -d "$1" ]; then
  echo "usage: test_programs.sh BUILD_DIR DATA_DIR [GROUP]..." >&2
  exit 2
fi
build=$(cd "$1" && pwd)
PATH="$build/bin:$build/examples/Restricted_laplacian_3:$PATH"
checks=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/checks.sh
data=$2
shift 2

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 2
source "$checks"

# How a check is written.

# run PROGRAM ARGUMENTS...: leaves the output in the files `out` and `err`, and the exit status in
# the variable `status`
run() {
  "$1" "${@:2}" > out 2> err < /dev/null
  status=$?
}

# The check of a program that has to succeed: exit status 0, and no word on the error stream.
succeeds() {
  run "$@"
  check "succeeds: $*" [ "$status" -eq 0 ]
  check "prints no error: $*" [ ! -s err ]
}

# fails PATTERN PROGRAM ARGUMENTS...: an exit status other than 0 that is not a crash, and one line
# on the error stream that says what is wrong, in words that match the pattern
fails() {
  local pattern=$1
  shift
  run "$@"
  check "exit status $status says failure: $*" [ "$status" -gt 0 -a "$status" -lt 126 ]
  check "one line of error, not $(wc -l < err): $*" [ "$(wc -l < err)" -eq 1 ]
  check "the error names its cause ($pattern): $*: $(head -n 1 err)" grep -qi -e "$pattern" err
}

# numbers NAME FILE: the values of the second column of a table, without its heading
numbers() { grep -v '^#' "$1" | tail -n +2 | cut -d, -f2; }

# same_values FILE OTHER ROWS: two tables of so many rows have the same values, to the last digit
same_values() {
  [ "$(numbers "$1" | wc -l)" -eq "$3" ] && cmp <(grep -v '^#' "$1") <(grep -v '^#' "$2")
}

# is_near A B TOLERANCE: both are numbers, and do not differ by more
is_near() {
  awk -v a="$1" -v b="$2" -v t="$3" \
    'BEGIN { d = a - b; exit !(a "" != "" && a + 0 == a && d <= t && -d <= t) }'
}

# Shapes, and what their solutions are compared with.

# make_sphere N: an OFF file of the unit sphere, an octahedron with N^2 triangles in place of each
# of its faces
make_sphere() {
  awk -v n="$1" '
    function vertex(i, j, k,   key, r) {
      key = i " " j " " k
      if(!(key in number)) {
        number[key] = n_vertices
        r = sqrt(i * i + j * j + k * k)
        points[n_vertices++] = sprintf("%.17g %.17g %.17g", i / r, j / r, k / r)
      }
      return number[key]
    }
    # corners in the grid of the octant with signs a, b, c; turned for a consistent orientation
    function triangle(i1, j1, i2, j2, i3, j3,   p, q, r) {
      p = vertex(a * i1, b * j1, c * (n - i1 - j1))
      q = vertex(a * i2, b * j2, c * (n - i2 - j2))
      r = vertex(a * i3, b * j3, c * (n - i3 - j3))
      faces[n_faces++] = a * b * c > 0 ? "3 " p " " q " " r : "3 " p " " r " " q
    }
    BEGIN {
      n_vertices = n_faces = 0
      for(a = -1; a <= 1; a += 2) for(b = -1; b <= 1; b += 2) for(c = -1; c <= 1; c += 2)
        for(i = 0; i < n; ++i) for(j = 0; i + j < n; ++j) {
          triangle(i, j, i + 1, j, i, j + 1)
          if(i + j + 1 < n)
            triangle(i + 1, j, i + 1, j + 1, i, j + 1)
        }
      print "OFF\n" n_vertices " " n_faces " 0"
      for(i = 0; i < n_vertices; ++i) print points[i]
      for(i = 0; i < n_faces; ++i) print faces[i]
    }'
}

# surface_mean MESH.off TABLE: integral of the function that is linear in each triangle, over area
surface_mean() {
  numbers "$2" | awk '
    NR == FNR { value[FNR - 1] = $1; next }
    FNR == 2 { n = $1; next }
    FNR > 2 && FNR <= n + 2 { for(k = 1; k <= 3; ++k) p[FNR - 3, k] = $k; next }
    FNR > n + 2 {
      for(k = 1; k <= 3; ++k) { u[k] = p[$3, k] - p[$2, k]; v[k] = p[$4, k] - p[$2, k] }
      x = u[2] * v[3] - u[3] * v[2]; y = u[3] * v[1] - u[1] * v[3]; z = u[1] * v[2] - u[2] * v[1]
      area = sqrt(x * x + y * y + z * z) / 2
      total += area; sum += area * (value[$2] + value[$3] + value[$4]) / 3
    }
    END { printf "%.17g\n", sum / total }' - "$1"
}

# largest_difference TABLE COLUMN FACTOR: of the values from FACTOR times a coordinate of sphere.off
largest_difference() {
  numbers "$1" | awk -v column="$2" -v factor="$3" '
    NR == FNR { value[FNR - 1] = $1; next }
    FNR == 2 { n = $1; next }
    FNR > 2 && FNR <= n + 2 {
      d = value[FNR - 3] - factor * $column
      if(d < 0) d = -d
      if(!(d <= largest)) largest = d
    }
    END { printf "%.17g\n", largest }' - sphere.off
}

is_below() { awk -v x="$1" -v bound="$2" 'BEGIN { exit !(x != "" && x + 0 == x && x < bound) }'; }

make_sphere 16 > sphere.off # 1026 vertices, 2048 faces
make_sphere 4 > small.off
awk 'NR > 2 && NF == 3 { print 9 * $1, 9 * $2, 9 * $3; next } { print }' OFMT=%.17g CONVFMT=%.17g \
  sphere.off > large_sphere.off

# The tests.

common_options="depth cube-scale no-split joining-tolerance paper csv output html threads quiet verbose progress help
  version"
integration_options="assembly samples sampling seed"
point_options="neighbors split"

# help_examples PROGRAM: the calls in the text of --help in `out`, a line for each
help_examples() {
  sed -n '/^Examples:$/,/^Exit status:$/p' out | sed -e ':more' -e '/\\$/N; s/\\\n *//; t more' |
    sed -n "s/^  \\($1 .*\\)/\\1/p"
}

# explains PROGRAM OPTION...: the form of --help, and that it explains these options and those of
# its examples
explains() {
  local program=$1 option
  succeeds "$program" --help
  check "$program --help begins with the usage" \
    eval "head -n 1 out | grep -q '^usage: $program MESH '"
  check "$program --help has two examples" [ "$(help_examples "$program" | wc -l)" -ge 2 ]
  check "$program --help: a line on each example" \
    [ "$(sed -n '/^Examples:$/,/^Exit status:$/p' out | grep -c '^      [a-z]')" -eq \
      "$(help_examples "$program" | wc -l)" ]
  check "$program --help ends with the exit status" \
    eval "sed -n '/^Exit status:$/,\$p' out | tail -n +2 | grep -c '^  [0-2]  ' | grep -q '[23]'"
  check "$program --help fits into 92 columns" eval "! grep -q '.\\{93\\}' out"
  for option in "${@:2}" $(help_examples "$program" | grep -o -e ' --[a-z-]*' | cut -c4-); do
    check "$program --help explains --$option" grep -q -e "^  --$option " out
  done
}

# shellcheck disable=SC2086
test_help() {
  local program
  explains solve_poisson $common_options $integration_options $point_options refine \
    rhs rhs-property boundary-property flux-property alpha tolerance stabilization cycle smoother
  explains laplace_spectrum $common_options $integration_options $point_options refine \
    count operator lumped-mass eigenfunction eigensolver tolerance stabilization
  explains spectral_descriptors $common_options $integration_options refine \
    descriptor count columns time energy scaled normalization compare column eigensolver tolerance
  explains fit_function $common_options $integration_options $point_options refine \
    property normals smoothing refinements tolerance stabilization
  explains estimate_curvature $common_options $integration_options $point_options refine \
    method smoothing tolerance stabilization show clip
  explains stitch_colors $common_options \
    poses frame method gradients alpha maximum-distance normal-angle no-oriented leave-out \
    no-match-exposures linear-light no-details truth tolerance stabilization
  explains geodesic_distance source boundary farthest joining-tolerance exact maximum-memory neighbors split path isolines lines show csv output refine \
    depth threads quiet verbose progress version
  explains bake_scans views resolution field-of-view points noise exposure-range exposures tint \
    light linear-light pattern seed quiet version
  check "bake_scans --help rounds its defaults" eval "! grep -q '[09]\{6\}' out"
  ! has_draw_mesh || explains draw_mesh property range no-legend isolines view up beside size version
  for program in solve_poisson bake_scans; do
    succeeds $program --version
    check "$program --version" \
      grep -Eqx "$program \\(Restricted_laplacian_3 [0-9]+\\.[0-9]+\\.[0-9]+, CGAL [0-9.]+.*\\)" out
  done
}

# pages need what is bundled by Node.js, and the tool that draws pictures a library
has_viewer() { [ -e "$build/viewer/viewer.html" ]; }
has_draw_mesh() { [ -x "$build/bin/draw_mesh" ]; }

# The examples of --help, on the meshes that they name. Those of stitch_colors and draw_mesh read what
# those of other programs write.
test_help_examples() {
  local program example file files
  if [ ! -r "$data/elephant.off" ]; then
    echo "SKIPPED: test_help_examples: there is no $data/elephant.off"
    return
  fi
  mkdir meshes
  ln -s "$data"/*.off meshes
  ln -s "$data/../points_3" points_3
  cd meshes || exit 2
  for program in solve_poisson laplace_spectrum spectral_descriptors fit_function \
    estimate_curvature geodesic_distance bake_scans stitch_colors draw_mesh; do
    [ $program != draw_mesh ] || has_draw_mesh || continue
    succeeds "$program" --help
    help_examples "$program" > examples
    while read -r example; do
      files=$(echo "$example" | grep -Eo -e '--(csv|output) [^ ]*|[^ ]*\.(png|html)' | sed 's/.* //')
      for file in $files; do
        rm -f "$file"
        [ "${file%.html}" = "$file" ] || has_viewer || continue 2
      done
      check "runs: $example" bash -c "$example"
      for file in $files; do
        check "writes $file: $example" [ -s "$file" ]
      done
    done < examples
  done
  cd ..
}

test_bad_input() {
  local program
  : > nothing.off
  echo "this is not a mesh" > text.off
  cp sphere.off unknown_format.xyz123
  printf 'OFF\n0 0 0\n' > empty.off
  printf 'OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n' > points_only.off
  printf 'OFF\n3 1 0\n0 0 0\n1 0 0\nnan 1 0\n3 0 1 2\n' > nan.off
  printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n' > line.off
  printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n' > bad_index.off
  printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n' > negative_index.off
  printf 'OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n2 0 1\n' > two_corners.off
  head -n 500 sphere.off > truncated.off
  {
    printf 'ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n'
    printf 'property float y\nproperty float z\nelement face 1\n'
    printf 'property list uchar int vertex_indices\nend_header\n'
    printf '\0\0\0\0\0\0\0\0\0\0\0\0'             # 0 0 0
    printf '\0\0\200\077\0\0\0\0\0\0\0\0'         # 1 0 0
    printf '\0\0\0\0\0\0\300\177\0\0\0\0'         # 0 nan 0
    printf '\003\0\0\0\0\001\0\0\0\002\0\0\0'
  } > nan.ply
  { printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float a\nproperty float y\n'
    printf 'property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n'
    printf '0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n'; } > no_x.ply
  printf 'OFF\n3 1 0\n0,5 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' > decimal_comma.off
  echo '<VTKFile>' > mesh.vtp
  mkdir -p folder.off

  for program in solve_poisson laplace_spectrum spectral_descriptors; do
    fails "no mesh" "$program"
    fails "missing.off" "$program" missing.off
    fails "text.off" "$program" text.off
    fails "nothing.off" "$program" nothing.off
    fails "unknown_format" "$program" unknown_format.xyz123
    fails "empty.off" "$program" empty.off
    fails "points_only.off" "$program" points_only.off
    fails "nan.off" "$program" nan.off
    fails "nan.ply.*vertex 2" "$program" nan.ply
    fails "decimal_comma.off.*line 3.*vertex 0.*0,5" "$program" decimal_comma.off
    fails "mesh.vtp.*suffix .vtp" "$program" mesh.vtp
    fails "no_x.ply.*no vertex property 'x'; there are: a, y, z" "$program" no_x.ply
    fails "area\|degenerate" "$program" line.off
    fails "bad_index.off" "$program" bad_index.off
    fails "negative_index.off" "$program" negative_index.off
    fails "two_corners.off.*face 1.*corner" "$program" two_corners.off
    fails "truncated.off" "$program" truncated.off
    fails "folder.off" "$program" folder.off
    fails "positional" "$program" small.off small.off
    fails "unrecognised.*frobnicate" "$program" small.off --frobnicate
    fails "unrecognised.*dep" "$program" small.off --dep 3
    fails "depth.*missing\|missing.*depth" "$program" small.off --depth
    fails "7x" "$program" small.off --depth 7x
    fails "7.5" "$program" small.off --depth 7.5
    fails " --depth is 99" "$program" small.off --depth 99
    fails " --depth is 0" "$program" small.off --depth 0
    fails " --depth is -3" "$program" small.off --depth -3
    fails " --cube-scale is 0.5" "$program" small.off --cube-scale 0.5
    fails "cube" "$program" small.off --cube-scale nan
    fails "cube" "$program" small.off --cube-scale inf
    fails "assembly" "$program" small.off --assembly magic
    fails "samples" "$program" small.off --assembly monte-carlo --samples 0
    fails "samples" "$program" small.off --samples 1000
    fails "seed" "$program" small.off --seed -1
    fails "threads" "$program" small.off --threads 0
    # outputs are tried before the input is read
    fails "nowhere/table.csv.* of --csv" "$program" missing.off --csv nowhere/table.csv
    fails "nowhere/mesh.ply.* of --output" "$program" missing.off --output nowhere/mesh.ply
    fails "folder.off' of --csv" "$program" missing.off --csv folder.off
    fails "mesh.jpg' of --output.*.ply or .obj" "$program" missing.off --output mesh.jpg
    fails "the same file" "$program" missing.off --csv same.ply --output same.ply
    fails "missing.off" "$program" missing.off --csv new.csv --output new.ply
    check "$program leaves no empty file" [ ! -e new.csv -a ! -e new.ply ]
    echo "old" > old.csv
    fails "missing.off" "$program" missing.off --csv old.csv
    check "$program keeps the old file" [ "$(cat old.csv)" = old ]
    fails "refine needs --output" "$program" small.off --refine 2
    fails "refine" "$program" small.off --output new.ply --refine 0
    if [ -c /dev/full ]; then
      fails "/dev/full" "$program" small.off --depth 3 --csv /dev/full
      fails "/dev/full" "$program" small.off --depth 3 --output /dev/full
    fi
  done
  fails "rhs" solve_poisson small.off --rhs w
  fails "rhs" solve_poisson small.off --rhs x --rhs-property value
  fails "small.off.*height" solve_poisson small.off --rhs-property height
  fails "alpha" solve_poisson small.off --alpha -1
  fails "alpha" solve_poisson small.off --alpha nan
  fails "tolerance" solve_poisson small.off --tolerance 0
  fails "1e-" solve_poisson small.off --tolerance 1e-
  fails "cycle" solve_poisson small.off --cycle x
  fails "smoother" solve_poisson small.off --smoother magic
  fails "count" laplace_spectrum small.off --count 0
  fails "ten" laplace_spectrum small.off --count ten
  fails "operator" laplace_spectrum small.off --operator magic
  fails "lumped-mass has no effect" laplace_spectrum small.off --lumped-mass
  fails "eigenfunction" laplace_spectrum small.off --count 3 --eigenfunction 3
  fails "eigenfunction" laplace_spectrum small.off --count 3 --eigenfunction -1
  fails "eigensolver" laplace_spectrum small.off --eigensolver magic
  fails "eigensolver" laplace_spectrum small.off --eigensolver multigrid --paper
  fails "tolerance" laplace_spectrum small.off --tolerance 0
  fails "stabilization" laplace_spectrum small.off --stabilization -1
  program=spectral_descriptors
  fails "descriptor" $program small.off --descriptor magic
  fails "count" $program small.off --count 0
  fails " --count is" $program small.off --depth 2 --count 5000
  fails "eigenvalues" $program small.off --depth 2 --count 1
  fails "columns" $program small.off --columns 1
  fails "columns" $program small.off --descriptor gps --columns 5
  fails "time" $program small.off --time 0
  fails "time" $program small.off --time nan
  fails "time" $program small.off --descriptor wks --time 1
  fails "energy" $program small.off --energy 1
  fails "energy" $program small.off --descriptor wks --energy inf
  fails "scaled" $program small.off --descriptor wks --scaled
  fails "normalization" $program small.off --normalization weyl
  fails "normalization" $program small.off --descriptor shape-dna --normalization magic
  fails "compare" $program small.off --compare small.off
  fails "missing.off" $program small.off --depth 2 --count 5 --descriptor shape-dna \
    --compare missing.off
  fails "column" $program small.off --column -1
  fails "column.*99" $program small.off --depth 3 --descriptor gps --column 99
  fails "column" $program small.off --descriptor shape-dna --column 0
  fails "output" $program small.off --descriptor shape-dna --output dna.ply
}

# has_table_format FILE COLUMNS: comments, the names of the columns, rows numbered from 0
has_table_format() {
  awk -v columns="$2" '
    /^#/ && !heading { if($0 !~ /^# [a-z_]+: ./) exit bad = 1; next }
    !heading { heading = 1; if($0 != columns) exit bad = 1; next }
    $0 !~ "^" row + 0 ",-?[0-9]+(\\.[0-9]*)?(e[-+][0-9]+)?$" { print; exit bad = 1 }
    { ++row }
    END { exit bad || !row }' "$1"
}

# comment NAME FILE: the value of a comment
comment() { sed -n "s/^# $1: //p" "$2"; }

test_poisson_table() {
  local name
  succeeds solve_poisson sphere.off --depth 4 --csv table.csv
  for name in vertices faces depth dimension area components seconds; do
    check "prints $name" grep -q "^$name " out
  done
  check "prints no details" eval "! grep -q 'sheets\|iterations\|residual\|threads' out"
  for name in minimum maximum mean; do
    check "prints the $name of -z / 2" is_near "$(entry $name)" \
      "$(echo "minimum -0.5 maximum 0.5 mean 0" | grep -o "$name [^ ]*" | cut -d' ' -f2)" 0.01
  done
  check "format of the table" has_table_format table.csv vertex,value
  for name in vertices faces depth dimension cells sheets split_elements components \
    kernel_dimension area setup_seconds assembly_seconds solve_seconds iterations \
    relative_residual; do
    check "comment $name is a number" is_near "$(comment $name table.csv)" 0 1e6
  done
  check "vertices" [ "$(comment vertices table.csv)" = 1026 ]
  check "faces" [ "$(comment faces table.csv)" = 2048 ]
  check "depth" [ "$(comment depth table.csv)" = 4 ]
  check "area of the polyhedron" is_near "$(comment area table.csv)" 12.53 0.03
  check "one row for each vertex" [ "$(numbers table.csv | wc -l)" -eq 1026 ]
  check "16 or more digits" [ "$(numbers table.csv | tr -d -- '-.\n' | wc -c)" -gt 15390 ]
  succeeds solve_poisson sphere.off --depth 4 --quiet
  check "--quiet prints nothing" [ ! -s out ]
  run solve_poisson sphere.off --depth 4 --verbose
  for name in sheets iterations residual threads assembly_seconds; do
    check "--verbose prints $name" grep -q "$name" out
  done
  run solve_poisson sphere.off --depth 4 --progress
  check "--progress shows parts and seconds" \
    grep -Eqx "solving for [0-9]+ unknowns: [0-9]+ %, [0-9]+ s left" err
  check "up to the end" grep -Eqx "solving for [0-9]+ unknowns: 100 %, 0 s left" err
}

# The coordinates are eigenfunctions of the sphere: Laplacian x = -2 x.
test_poisson_solution() {
  local axis
  for axis in 1 2 3; do
    succeeds solve_poisson sphere.off --depth 4 --rhs "$(echo xyz | cut -c$axis)" \
      --tolerance 1e-6 --csv u.csv
    check "Laplacian u = x has the solution -x / 2" \
      is_below "$(largest_difference u.csv $axis -0.5)" 5e-3
  done
  # 4 pi / area u - Laplacian u = z has the solution z / 3, up to the area of the polyhedron
  succeeds solve_poisson sphere.off --depth 4 --rhs z --alpha 12.566 --tolerance 1e-6 --csv u.csv
  check "u - Laplacian u = z has the solution z / 3" \
    is_below "$(largest_difference u.csv 3 0.3333333)" 5e-3

  # The property of a mesh 100 times as large: alpha has the unit 1 / area, so u scales with the
  # square of the length and with f.
  awk 'NR > 2 && NF == 3 { print 100 * $1, 100 * $2, 100 * $3; next } { print }' OFMT=%.17g \
    CONVFMT=%.17g sphere.off > large.off
  succeeds solve_poisson large.off --depth 4 --rhs z --alpha 12.566 --tolerance 1e-6 --csv large.csv
  check "--alpha does not depend on the scale" \
    is_below "$(largest_difference large.csv 3 333333.3)" 5e3

  # the mean of f does not matter
  awk 'NR > 2 && NF == 3 { print $1, $2, $3 + 5; next } { print }' OFMT=%.17g CONVFMT=%.17g \
    sphere.off > shifted.off
  succeeds solve_poisson shifted.off --depth 4 --rhs z --tolerance 1e-6 --csv u.csv
  check "the mean of f is subtracted" is_below "$(largest_difference u.csv 3 -0.5)" 5e-3
  succeeds solve_poisson shifted.off --depth 4 --rhs z --alpha 12.566 --tolerance 1e-6 --csv u.csv
  check "the mean of f is subtracted, screened" \
    is_below "$(largest_difference u.csv 3 0.3333333)" 5e-3

  succeeds solve_poisson small.off --depth 3 --rhs random --seed 5 --tolerance 1e-6 --csv r5.csv
  check "the solution has surface mean zero" \
    is_near "$(surface_mean small.off r5.csv)" 0 1e-3
  succeeds solve_poisson small.off --depth 3 --rhs random --seed 5 --tolerance 1e-6 --csv r5b.csv
  succeeds solve_poisson small.off --depth 3 --rhs random --seed 6 --tolerance 1e-6 --csv r6.csv
  numbers r5.csv > r5
  numbers r5b.csv > r5b
  numbers r6.csv > r6
  check "the same seed gives the same values" cmp r5 r5b
  check "another seed gives other values" eval "! cmp -s r5 r6"
  check "a random right-hand side is not zero" eval "[ $(sort -u r5 | wc -l) -gt 50 ]"
}

test_poisson_options() {
  local options
  succeeds solve_poisson sphere.off --depth 4 --tolerance 1e-6 --csv reference.csv
  numbers reference.csv > reference
  for options in "--cycle w" "--cube-scale 1.3"; do
    # shellcheck disable=SC2086
    succeeds solve_poisson sphere.off --depth 4 --tolerance 1e-6 $options --csv u.csv
    check "$options: the same solution" is_below "$(largest_difference u.csv 3 -0.5)" 5e-3
  done
  check "--cube-scale changes the space" \
    eval "[ '$(comment dimension u.csv)' != '$(comment dimension reference.csv)' ]"

  succeeds solve_poisson sphere.off --depth 4 --smoother point --tolerance 1e-6 --csv point.csv
  check "--smoother point: the same solution" \
    is_below "$(largest_difference point.csv 3 -0.5)" 5e-3
  check "the default smoother takes fewer iterations" \
    [ "$(comment iterations point.csv)" -gt "$(comment iterations reference.csv)" ]
  succeeds solve_poisson sphere.off --depth 4 --stabilization 0 --tolerance 1e-4 --csv pure.csv
  check "--stabilization 0: the same solution" \
    is_below "$(largest_difference pure.csv 3 -0.5)" 5e-3
  fails "stabilization" solve_poisson sphere.off --stabilization -1
  succeeds solve_poisson sphere.off --depth 4 --threads 1 --csv one.csv
  succeeds solve_poisson sphere.off --depth 4 --threads 2 --csv two.csv
  check "--threads has no influence on values" same_values one.csv two.csv 1026

  # 504 elements at depth 3: Table 1 of the paper
  succeeds solve_poisson sphere.off --depth 3 --paper --csv paper.csv
  check "dimension of the space of the paper" [ "$(comment dimension paper.csv)" = 504 ]
  succeeds solve_poisson sphere.off --depth 3 --no-split --csv unsplit.csv
  check "dimension of the unsplit space" [ "$(comment dimension unsplit.csv)" = 816 ]
  # The support of an element may contain several pieces of the sphere, at its corners. The number is
  # our own output.
  succeeds solve_poisson sphere.off --depth 3 --csv default.csv
  check "dimension of the default space" [ "$(comment dimension default.csv)" = 864 ]

  succeeds solve_poisson sphere.off --depth 3 --assembly monte-carlo --samples 200000 --csv u.csv
  check "monte-carlo: close to the solution" is_below "$(largest_difference u.csv 3 -0.5)" 5e-2
  check "monte-carlo: not the same solution" \
    eval "! [ '$(numbers u.csv | md5sum)' = '$(numbers default.csv | md5sum)' ]"

  succeeds solve_poisson sphere.off --depth 4 --tolerance 1e-2 --csv loose.csv
  check "a looser tolerance takes fewer iterations" \
    [ "$(comment iterations loose.csv)" -lt "$(comment iterations reference.csv)" ]
  check "and leaves a larger residual" \
    is_below "$(comment relative_residual reference.csv)" "$(comment relative_residual loose.csv)"
  check "the tolerance is kept" is_below "$(comment relative_residual reference.csv)" 1.0001e-6

  # the residual cannot become as small as that in double precision
  rm -f u.csv u.ply
  fails "converge: the iteration stalled" solve_poisson small.off --depth 3 --tolerance 1e-60 --csv u.csv --output u.ply
  check "status 2 if the solver does not converge" [ "$status" -eq 2 ]
  check "the output is written nevertheless" [ -s u.csv -a -s u.ply ]
}

test_mesh_output() {
  succeeds solve_poisson sphere.off --depth 3 --tolerance 1e-6 --output u.ply --csv u.csv
  for line in "format binary_little_endian 1.0" "element vertex 1026" "element face 2048" \
    "property uchar red" "property uchar green" "property uchar blue" "property double value"; do
    check "header of the mesh: $line" grep -aqx "$line" u.ply
  done
  # the mesh and its property can be read again, in the same order: the screened problem with a
  # large alpha has a solution close to f / alpha
  succeeds solve_poisson u.ply --depth 3 --rhs z --tolerance 1e-6 --csv again.csv
  numbers u.csv > u
  numbers again.csv > again
  check "the mesh that was written is the mesh that was read" \
    eval "[ \"\$(paste u again | awk '{ d = \$1 - \$2; if(d * d > 1e-12) print }')\" = '' ]"
  succeeds solve_poisson u.ply --depth 3 --rhs-property value --tolerance 1e-6 --csv twice.csv
  check "the property that was written is the property that was read" \
    is_below "$(largest_difference twice.csv 3 0.25)" 5e-3
  succeeds solve_poisson u.ply --depth 3 --rhs-property red --csv red.csv
  check "a property of type uchar" eval "[ $(numbers red.csv | sort -u | wc -l) -gt 50 ]"
  fails "height" solve_poisson u.ply --depth 3 --rhs-property height
  fails "height" solve_poisson u.ply --depth 3 --boundary-property height
  fails "no part of a boundary" solve_poisson u.ply --depth 3 --boundary-property value

  succeeds solve_poisson sphere.off --depth 3 --output u.obj
  check "an obj file has colors" [ "$(grep -Ec '^v( [^ ]+){6}$' u.obj)" -eq 1026 ]
  check "and faces" [ "$(grep -Ec '^f( [0-9]+){3}$' u.obj)" -eq 2048 ]
  succeeds solve_poisson u.obj --depth 3 --csv again.csv
  check "it can be read again" [ "$(comment vertices again.csv)" = 1026 ]
}

# What is written between the vertices is the spline, not what is linear between them.
# A program that is killed while it writes, and a disk that is full: a limit of the length of files
# does both.
# a square with values of 0 and 2 on the sides x = 0 and x = 1, free between them, and with a flux of
# 2 through the second one
make_square_with_conditions() {
  printf '%s\n' ply "format binary_little_endian 1.0" "element vertex 6"
  printf 'property float %s\n' x y z value flux
  printf '%s\n' "element face 4" "property list uchar int vertex_indices" end_header
  local zero='\0\0\0\0' half='\0\0\0\077' one='\0\0\200\077' two='\0\0\0\100' nan='\0\0\300\177' y
  for y in "$zero" "$one"; do
    # shellcheck disable=SC2059
    printf "$zero$y$zero$zero$zero$half$y$zero$nan$zero$one$y$zero$two$two"
  done
  printf '\003\0\0\0\0\001\0\0\0\004\0\0\0\003\0\0\0\0\004\0\0\0\003\0\0\0'
  printf '\003\001\0\0\0\002\0\0\0\005\0\0\0\003\001\0\0\0\005\0\0\0\004\0\0\0'
}

test_boundary_conditions() {
  make_square_with_conditions > square.ply
  for data in linear smooth; do
    succeeds solve_poisson square.ply --depth 4 --rhs z --boundary-property value \
      --vertex-data $data --csv u.csv
    check "the solution between values on two sides, $data" \
      is_below "$(numbers u.csv | awk '{ d = $1 - (NR - 1) % 3; if(d * d > e) e = d * d }
        END { print sqrt(e) }')" 1e-5
  done
  # what is prescribed is of the order of 1, and with a screening weight it decays inward
  succeeds solve_poisson square.ply --depth 4 --rhs z --boundary-property value --alpha 3 \
    --csv u.csv
  check "a screened solution lies below" is_below "$(numbers u.csv | sed -n 2p)" 0.75
  check "and keeps the values" is_below "$(numbers u.csv | sed -n 3p |
    awk '{ print ($1 - 2) * ($1 - 2) }')" 1e-3
  succeeds solve_poisson square.ply --depth 4 --rhs z --flux-property flux --csv u.csv
  check "a flux moves the solution" is_below "$(numbers u.csv | awk '{ print -$1 }' | sed -n 3p)" -0.3
  fails "flux" solve_poisson small.off --flux-property flux
}

test_whole_files() {
  make_sphere 12 > ball.off # with tables of more than 20 kB
  local file
  for file in whole.csv whole.ply whole.obj; do
    local option=--output
    [ "$file" != whole.csv ] || option=--csv
    local solve=(solve_poisson ball.off --depth 3 --quiet "$option")
    { (ulimit -c 0 -f 4; exec "${solve[@]}" "killed_$file"); status=$?; } > out 2>&1
    check "$file: killed while it writes" [ "$status" -gt 128 ]
    check "no part of $file is taken for the whole" [ ! -e "killed_$file" ]
    echo old > "$file"
    (trap '' XFSZ; ulimit -f 4; exec "${solve[@]}" "$file") > out 2> err
    check "$file: a full disk is an error" grep -q "cannot write '$file'" err
    check "what was in $file is there" [ "$(cat "$file")" = old ]
    check "no part of $file is left" [ ! -e "$file.part" ]
    succeeds solve_poisson ball.off --depth 3 "$option" "$file"
    check "$file is whole" [ "$(wc -c < "$file")" -gt 4096 -a ! -e "$file.part" ]
  done
  # a link remains one, and so do permissions
  mkdir -p elsewhere
  echo old > elsewhere/table.csv
  chmod 640 elsewhere/table.csv
  ln -sf elsewhere/table.csv link.csv
  succeeds solve_poisson ball.off --depth 3 --csv link.csv
  check "a link remains a link" [ -L link.csv ]
  check "the file that it leads to is written" cmp link.csv elsewhere/table.csv
  check "permissions remain" [ "$(stat -c %a elsewhere/table.csv)" = 640 ]
}

# Files that are read stay, options that have no effect are refused, and outputs may go to the standard
# output, where then nothing else is.
test_files_and_options() {
  make_sphere 12 > sphere.off
  succeeds solve_poisson sphere.off --depth 4 --output mesh.ply
  cp mesh.ply before.ply
  mkdir folder
  ln -s ../mesh.ply folder/link.ply
  for name in mesh.ply ./folder/../mesh.ply folder/link.ply "$folder/mesh.ply"; do
    fails "is read, and --output would replace it.*--overwrite" solve_poisson mesh.ply --depth 4 --output "$name"
  done
  fails "is read, and --csv would" estimate_curvature mesh.ply --depth 4 --csv mesh.ply
  cp sphere.off lines.obj
  fails "is read, and --lines would" geodesic_distance lines.obj --source 0 --path 3 --lines lines.obj
  fails "would replace" smooth_surface sphere.off ./sphere.off
  check "the file is as before" cmp mesh.ply before.ply
  succeeds solve_poisson mesh.ply --depth 4 --output folder/link.ply --overwrite --rhs x
  check "it is replaced on request" eval "! cmp -s mesh.ply before.ply && [ -L folder/link.ply ]"
  if [ -x "$build/bin/bake_scans" ]; then
    succeeds bake_scans before.ply scans --views 2 --resolution 32
    fails "truth.ply' is read, and FOLDER would replace it" bake_scans scans/truth.ply scans --views 2
  fi

  succeeds solve_poisson sphere.off --depth 4 --csv table.csv
  local rows
  rows=$(numbers table.csv | wc -l)
  succeeds solve_poisson sphere.off --depth 4 --csv /dev/stdout
  check "a table, and nothing else" same_values table.csv out "$rows"
  solve_poisson sphere.off --depth 4 --csv /dev/stdout | cat > piped.csv
  check "through a pipe, too" same_values table.csv piped.csv "$rows"
  solve_poisson sphere.off --depth 4 --csv /dev/stderr 2> error.csv > out
  check "on the error stream" same_values table.csv error.csv "$rows"
  check "beside what is printed" grep -q "^maximum" out
  succeeds solve_poisson sphere.off --depth 4 --output /dev/stdout
  check "a mesh" eval "head -c 3 out | grep -q ply && cmp out before.ply"
  succeeds geodesic_distance sphere.off --source 0 --path 5 --lines /dev/stdout
  check "lines" eval "grep -q '^v ' out && ! grep -v '^[vl] ' out"
  fails "name the same file" solve_poisson sphere.off --depth 4 --csv /dev/stdout --output /dev/stdout

  fails "argument -1 of --source" geodesic_distance sphere.off --source -1
  fails "argument -7 of --path" geodesic_distance sphere.off --source 0 --path -7
  fails "argument -2 of --farthest" geodesic_distance sphere.off --farthest -2
  local without="has no effect without"
  fails "isolines $without --lines or --html" geodesic_distance sphere.off --source 0 --isolines 5
  fails "show $without --output" geodesic_distance sphere.off --source 0 --show nearest
  fails "show $without --output" estimate_curvature sphere.off --show gaussian
  fails "clip $without --output" estimate_curvature sphere.off --clip 90
  fails "eigenfunction $without --output" laplace_spectrum sphere.off --eigenfunction 2
  fails "depth $without --operator restricted" laplace_spectrum sphere.off --operator cotangent --depth 4
  fails "tolerance $without --eigensolver" laplace_spectrum sphere.off --eigensolver shift-invert --tolerance 0.1
  fails "crease-angle $without --geometry smooth" solve_poisson sphere.off --crease-angle 20
  fails "joining-tolerance $without split" solve_poisson sphere.off --join 0.1 --no-split
  fails "columns $without all times" spectral_descriptors sphere.off --columns 5 --time 0.1
  fails "alpha $without --method gradients" stitch_colors mesh.ply mesh.ply --poses p --method chosen --alpha 2
  fails "quiet excludes" solve_poisson sphere.off --quiet --verbose
}

test_memory() {
  make_sphere 12 > ball.off
  fails "--depth is 16, which would take about .* GB of memory, and .* GB are there; a depth of" \
    solve_poisson ball.off --depth 16
  fails "--depth is 7, which would take about 4.. MB of memory, and 100 MB are there; a depth of 5" \
    laplace_spectrum ball.off --depth 7 --maximum-memory 0.1
  succeeds solve_poisson ball.off --depth 6 --maximum-memory 0.2
  fails "memory must be a positive number" solve_poisson ball.off --maximum-memory 0
}

test_refinement() {
  local program
  succeeds fit_function small.off --property z --depth 3 --refine 4 --output fine.ply
  succeeds fit_function fine.ply --property z,fit_z --depth 3 --csv fine.csv
  check "faces are divided" is_below 5000 "$(comment faces fine.csv)"
  check "without cracks" [ "$(comment components fine.csv)" = 1 ]
  check "the surface is the same" eval \
    "run fit_function small.off --property z --depth 3 --csv z.csv &&
     is_near '$(comment area fine.csv)' \"\$(comment area z.csv)\" 1e-9"
  check "the fit of z is z, everywhere" eval "paste <(column fine.csv 2) <(column fine.csv 3) |
    awk '{ d = \$1 - \$2; if(!(d * d < 1e-10)) exit 1 }'"
  # an eigenfunction of degree 2 has a larger range than its values at a few vertices
  make_sphere 1 > octahedron.off
  succeeds laplace_spectrum octahedron.off --depth 4 --count 6 --eigenfunction 5 --output five.ply \
    --refine 2
  succeeds fit_function five.ply --property value --depth 4 --csv five.csv
  check "the values differ between the vertices" \
    [ "$(numbers five.csv | cut -c1-5 | sort -u | wc -l)" -gt 50 ]
  for program in estimate_curvature spectral_descriptors; do
    succeeds $program small.off --depth 3 --refine 1 --output fine.ply
    succeeds solve_poisson fine.ply --depth 3 --rhs x
    check "$program divides faces" is_below 200 "$(entry faces)"
  done
  fails "refine.*restricted" laplace_spectrum small.off --operator cotangent --refine 2 \
    --output fine.ply
}

# is_picture FILE: a PNG file that is not empty
is_picture() {
  [ "$(head -c 8 "$1" | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a ] &&
    [ "$(wc -c < "$1")" -gt 10000 ]
}

# picture_width FILE: in pixels
picture_width() { od -An -tu1 -j16 -N4 "$1" | awk '{ print (($1 * 256 + $2) * 256 + $3) * 256 + $4 }'; }

# pictures of what programs write
test_pictures() {
  local option view
  if ! has_draw_mesh; then
    echo "SKIPPED: test_pictures: there is no draw_mesh"
    return
  fi
  succeeds solve_poisson sphere.off --depth 3 --output u.ply
  succeeds draw_mesh u.ply u.png
  check "a picture" is_picture u.png
  for option in "--isolines 10" "--up z" "--size 500" "--property red" "--view 1,0,0" \
    "--property value" "--property value --no-legend" "--property value --range -1,1"; do
    # shellcheck disable=SC2086
    succeeds draw_mesh u.ply other.png $option
    check "$option: a picture" is_picture other.png
    check "$option changes the picture" eval "! cmp -s u.png other.png"
  done
  succeeds draw_mesh u.ply with.png --property value
  succeeds draw_mesh u.ply without.png --property value --no-legend
  check "the legend is beside the mesh" \
    is_below "$(picture_width without.png)" "$(picture_width with.png)"
  for view in 0,0,1 0,1,0 0,-3,0 1e-9,1,0; do
    succeeds draw_mesh u.ply other.png --view $view
    check "from $view: a picture" is_picture other.png
  done
  succeeds draw_mesh sphere.off gray.png
  check "a mesh without colors" is_picture gray.png
  awk 'NR > 2 && NF == 3 { print $0, $0 }' sphere.off > points.xyz
  succeeds solve_poisson points.xyz --depth 2 --output points.ply
  succeeds draw_mesh points.ply points.png --isolines 5
  check "points" is_picture points.png
  make_moebius_strip 60 > moebius.off
  succeeds estimate_curvature moebius.off --depth 4 --output moebius.ply
  succeeds draw_mesh moebius.ply moebius.png --property gaussian --isolines 3
  check "a Moebius strip" is_picture moebius.png

  fails "no mesh" draw_mesh
  fails "no picture" draw_mesh u.ply
  fails "missing.ply" draw_mesh missing.ply x.png
  fails "value" draw_mesh sphere.off x.png --isolines 3
  fails "height" draw_mesh u.ply x.png --property height
  fails "isolines" draw_mesh u.ply x.png --isolines -1
  fails "up" draw_mesh u.ply x.png --up x
  fails "size" draw_mesh u.ply x.png --size 1
  fails "nowhere/x.png' of PICTURE" draw_mesh missing.ply nowhere/x.png
  fails "x.jpg' of PICTURE.*: .png" draw_mesh missing.ply x.jpg
  fails "view" draw_mesh u.ply x.png --view 1,0
  fails "'y' in the argument of --view" draw_mesh u.ply x.png --view 1,y,0
  fails "view" draw_mesh u.ply x.png --view 0,0,0
  fails "range needs --property" draw_mesh u.ply x.png --range 0,1
  fails "range" draw_mesh u.ply x.png --property value --range 1,0
}

# has_sphere_spectrum FILE TOLERANCE: l (l + 1), 2 l + 1 times, up to a relative error
has_sphere_spectrum() {
  numbers "$1" | awk -v tolerance="$2" '
    { while((l + 1) * (l + 1) <= NR - 1) ++l
      d = $1 - l * (l + 1); if(d < 0) d = -d
      if(!(d <= tolerance * (l ? l * (l + 1) : 1e-3))) { print NR - 1, $1; bad = 1 }
      if(NR > 1 && $1 < last) { print "not ascending"; bad = 1 }
      last = $1 }
    END { exit bad || !NR }'
}

# fields_of PAGE: how many fields its surfaces have
fields_of() { grep -o '"kind":"[a-z]*"' "$1" | wc -l; }

# What pages look like is tested in a browser, see viewer/tests.
test_pages() {
  local program
  if ! has_viewer; then
    fails "Node.js" solve_poisson small.off --depth 3 --html page.html
    echo "SKIPPED: test_pages: this build has no viewer"
    return
  fi
  succeeds solve_poisson small.off --depth 3 --html page.html
  check "it is one file without a network" eval "! grep -q -e ' src=' -e '@import' page.html"
  check "it names program and mesh" grep -q '"title":"solve_poisson small.off"' page.html
  check "with one field" [ "$(fields_of page.html)" -eq 1 ]
  succeeds solve_poisson small.off --depth 3 --html again.html --threads 1
  check "the page does not depend on the number of threads" cmp page.html again.html
  succeeds solve_poisson small.off --depth 3 --refine 2 --html fine.html
  check "faces are divided" eval "grep -q '\"faces\":[0-9]\{4\}' fine.html"
  succeeds laplace_spectrum small.off --depth 3 --count 7 --html page.html
  check "all eigenfunctions" [ "$(fields_of page.html)" -eq 7 ]
  succeeds laplace_spectrum small.off --operator cotangent --count 7 --html page.html
  check "also of the cotangent Laplacian" [ "$(fields_of page.html)" -eq 7 ]
  succeeds spectral_descriptors small.off --depth 3 --count 9 --columns 5 --refine 1 --html page.html
  check "all times" [ "$(fields_of page.html)" -eq 5 ]
  succeeds estimate_curvature small.off --depth 3 --html page.html
  check "both curvatures" [ "$(fields_of page.html)" -eq 2 ]
  succeeds geodesic_distance small.off --source 0 --html page.html
  check "distance and nearest source" [ "$(fields_of page.html)" -eq 2 ]
  succeeds fit_function small.off --property x,y --depth 3 --html page.html --output xy.ply
  check "both fits" [ "$(fields_of page.html)" -eq 2 ]
  cp small.off '<b>&"small".off'
  succeeds solve_poisson '<b>&"small".off' --depth 3 --html page.html
  check "a name is no markup" eval "! grep -q '<b>' page.html"
  if has_draw_mesh; then
    succeeds draw_mesh xy.ply page.html
    check "all properties and the colors of a file" [ "$(fields_of page.html)" -eq 3 ]
    succeeds draw_mesh xy.ply pair.html --property fit_y --range -1,1 --beside xy.ply
    check "two surfaces" [ "$(fields_of pair.html)" -eq 6 ]
    fails "fit_y" draw_mesh xy.ply pair.html --property fit_y --beside small.off
    fails "beside needs a page" draw_mesh xy.ply x.png --beside small.off
    fails "size needs a PNG" draw_mesh xy.ply x.html --size 200
  fi
  fails "html.*no format" solve_poisson small.off --depth 3 --html page.png
  fails "nowhere/x.html" solve_poisson small.off --depth 3 --html nowhere/x.html
  check "a page that cannot be written is an error before the work" [ ! -e nowhere ]
  fails "html need a descriptor" spectral_descriptors small.off --descriptor shape-dna --html x.html
}

test_spectrum() {
  local name
  succeeds laplace_spectrum sphere.off --depth 4 --count 16 --csv s.csv --output s.ply
  check "format of the table" has_table_format s.csv index,eigenvalue
  check "as many eigenvalues as asked for" [ "$(numbers s.csv | wc -l)" -eq 16 ]
  check "eigenvalues of the sphere" has_sphere_spectrum s.csv 1e-2
  for name in vertices faces depth dimension cells sheets split_elements components area \
    assembly_seconds solve_seconds; do
    check "comment $name is a number" is_near "$(comment $name s.csv)" 0 1e6
  done
  check "prints the eigenvalues" grep -q "[^0-9]2\.0" out
  check "the mesh has the eigenfunction" grep -aqx "property double value" s.ply

  # Both eigensolvers find the same, and the parameters of multigrid matter.
  for solver in multigrid shift-invert; do
    local tolerance=()
    [ $solver = shift-invert ] || tolerance=(--tolerance 1e-6)
    succeeds laplace_spectrum sphere.off --depth 4 --count 16 --eigensolver $solver \
      "${tolerance[@]}" --csv $solver.csv
    check "eigenvalues of the sphere, $solver" has_sphere_spectrum $solver.csv 1e-2
    numbers $solver.csv > $solver
  done
  check "eigensolvers agree" eval "paste multigrid shift-invert |
    awk '{ d = \$1 - \$2; if(d * d > 1e-14) exit 1 }'"
  check "residual of multigrid" is_near "$(comment relative_residual multigrid.csv)" 0 1e-6
  succeeds laplace_spectrum sphere.off --depth 4 --count 16 --stabilization 0.1 --csv strong.csv
  numbers strong.csv > strong
  check "stabilization matters" eval "! cmp -s strong shift-invert"

  for mass in --lumped-mass ""; do
    succeeds laplace_spectrum sphere.off --operator cotangent $mass --count 16 --csv c.csv
    check "eigenvalues of the sphere, cotangent operator $mass" \
      has_sphere_spectrum c.csv 3e-2
    check "dimension of the cotangent operator" [ "$(comment dimension c.csv)" = 1026 ]
    numbers c.csv > "mass$mass"
  done
  check "the mass matrix matters" eval "! cmp -s mass mass--lumped-mass"

  # Eigenfunction 0 is constant. Eigenfunction 1 has mean square 1 / area, and the inverse Laplacian
  # divides it by 2, up to the sign: the squares at 1026 vertices sum to about 1026 / (4 area).
  succeeds laplace_spectrum sphere.off --depth 3 --count 4 --eigenfunction 0 --output e0.ply
  succeeds laplace_spectrum sphere.off --depth 3 --count 4 --output e1.ply
  check "--eigenfunction chooses what is written" eval "! cmp -s e0.ply e1.ply"
  succeeds solve_poisson e0.ply --depth 3 --rhs-property value --tolerance 1e-6 --csv u0.csv
  succeeds solve_poisson e1.ply --depth 3 --rhs-property value --tolerance 1e-6 --csv u1.csv
  numbers u0.csv | awk '{ s += $1 * $1 } END { print s }' > s0
  numbers u1.csv | awk '{ s += $1 * $1 } END { print s }' > s1
  check "the inverse Laplacian annihilates eigenfunction 0" is_near "$(cat s0)" 0 1e-10
  check "the inverse Laplacian halves eigenfunction 1" is_near "$(cat s1)" 20.5 3
}

# column FILE NUMBER: the values of a column of a table, the first of which is 1
column() { grep -v '^#' "$1" | tail -n +2 | cut -d, -f"$2"; }

# are_near VALUE TOLERANCE: all numbers that are read
are_near() {
  awk -v value="$1" -v tolerance="$2" '
    { d = $1 - value; if(!(d <= tolerance && -d <= tolerance)) { print NR, $1; bad = 1 } }
    END { exit bad || !NR }'
}

test_descriptors() {
  local name program=spectral_descriptors
  # All eigenfunctions of degree 0 .. 3 of the unit sphere, whose squares sum to (2 l + 1) / (4 pi).
  local sphere="sphere.off --depth 4 --count 16"
  succeeds $program $sphere --columns 5 --csv hks.csv --output hks.ply
  for name in vertices faces depth dimension components area setup_seconds assembly_seconds \
    solve_seconds iterations relative_residual zero_eigenvalues columns smallest_value \
    largest_value; do
    check "comment $name is a number" is_near "$(comment $name hks.csv)" 0 1e6
  done
  check "one zero" [ "$(comment zero_eigenvalues hks.csv)" = 1 ]
  check "columns are named by their times" \
    grep -Eq '^vertex(,t=[0-9.e-]+){5}$' hks.csv
  check "one row for each vertex" [ "$(column hks.csv 1 | tail -n 1)" = 1025 ]
  check "all have six columns" eval "! grep -v '^#' hks.csv | grep -Evq '^([^,]+,){5}[^,]+\$'"
  check "the middle column is shown" [ "$(comment column hks.csv)" = \
    "$(grep ^vertex hks.csv | cut -d, -f4)" ]
  check "and its range" is_near "$(comment largest_value hks.csv)" \
    "$(column hks.csv 4 | sort -g | tail -n 1)" 1e-9
  check "the mesh has the values" grep -aqx "property double value" hks.ply

  # exp(-l (l + 1) t) at t = 1, that is 1 / area = 0.0798 in units of the area of the polyhedron
  succeeds $program $sphere --time 0.0798 --csv one.csv
  check "the heat kernel signature of the sphere" \
    eval "column one.csv 2 | are_near 0.1131 1e-3"
  succeeds $program $sphere --time 0.0798 --scaled --csv scaled.csv
  check "--scaled makes its integral 1" eval "column scaled.csv 2 | are_near 0.0798 4e-4"
  succeeds $program $sphere --descriptor wks --columns 5 --csv wks.csv
  check "energies are the logarithms of eigenvalues times area" \
    eval "grep ^vertex wks.csv | tr , '\\n' | grep ^e= | cut -c3- | are_near 4.1 0.9"
  check "the wave kernel signature of the sphere" eval "column wks.csv 4 | are_near 0.0798 4e-4"
  succeeds $program $sphere --descriptor wks --energy 4 --csv one.csv
  check "one energy" grep -qx "vertex,e=4" one.csv

  # the coordinates of a vertex have the square sum of (2 l + 1) / (4 pi) (l (l + 1))^-p
  succeeds $program $sphere --descriptor gps --csv gps.csv --column 3
  succeeds $program $sphere --descriptor biharmonic --csv biharmonic.csv
  succeeds $program $sphere --descriptor diffusion --csv diffusion.csv
  succeeds $program $sphere --descriptor diffusion --time 0.1 --csv later.csv
  for name in gps biharmonic diffusion; do
    column $name.csv 2- | awk -F, '{ s = 0; for(i = 1; i <= NF; ++i) s += $i * $i; print s }' > $name
  done
  check "global point signature" eval "are_near 0.2321 2e-3 < gps"
  check "biharmonic coordinates" eval "are_near 0.0746 1e-3 < biharmonic"
  check "zeros are left out" [ "$(grep ^vertex gps.csv | cut -d, -f1-3)" = vertex,gps_1,gps_2 ]
  check "--column chooses one" [ "$(comment column gps.csv)" = gps_4 ]
  check "zeros are not left out" \
    [ "$(grep ^vertex diffusion.csv | cut -d, -f1-2)" = vertex,diffusion_0 ]
  check "--time matters" eval "! cmp -s diffusion.csv later.csv"

  # the spectrum of a sphere of the unit area
  succeeds $program $sphere --descriptor shape-dna --csv dna.csv --compare large_sphere.off
  check "format of the table" has_table_format dna.csv index,shape_dna
  check "ShapeDNA is 0" [ "$(numbers dna.csv | head -n 1)" = 0 ]
  check "then 2 area" eval "numbers dna.csv | sed -n 2,4p | are_near 25.13 0.1"
  check "it does not depend on size" is_near "$(comment distance dna.csv)" 0 1e-5
  succeeds $program $sphere --descriptor shape-dna --normalization first --csv dna.csv
  check "--normalization first" eval "numbers dna.csv | sed -n 2,4p | are_near 1 1e-2"
  succeeds $program $sphere --descriptor shape-dna --normalization none --csv dna.csv
  check "--normalization none" eval "numbers dna.csv | sed -n 2,4p | are_near 2 1e-2"
  succeeds $program $sphere --descriptor shape-dna --normalization weyl --csv dna.csv
  check "--normalization weyl" eval "numbers dna.csv | sed -n 16p | are_near 13.4 1.5"
  succeeds $program $sphere --quiet
  check "--quiet prints nothing" [ ! -s out ]
}

# is_within LOW HIGH: all numbers of the standard input
is_within() { awk -v a="$1" -v b="$2" '!($1 >= a && $1 <= b) { bad = 1 } END { exit bad || !NR }'; }

test_fits() {
  succeeds fit_function sphere.off --property x,z --depth 3 --csv f.csv --output f.ply
  check "heading of the table" [ "$(grep -v '^#' f.csv | head -n 1)" = vertex,fit_x,fit_z ]
  check "one row for each vertex" [ "$(numbers f.csv | wc -l)" = 1026 ]
  for name in vertices faces depth dimension area setup_seconds assembly_seconds solve_seconds \
    iterations relative_residual rms_error; do
    check "the table says $name" [ -n "$(comment $name f.csv)" ]
  done
  check "coordinates are fitted" is_below "$(largest_difference f.csv 1 1)" 3e-6
  check "up to rounding" is_below "$(comment rms_error f.csv)" 1e-6
  check "to the tolerance" is_below "$(comment relative_residual f.csv)" 1.0001e-8
  check "the mesh has the values" grep -aqx "property double fit_z" f.ply
  check "no property of the mesh is there twice" \
    [ -z "$(sed '/^end_header/q' f.ply | grep -a '^property double' | sort | uniq -d)" ]
  succeeds fit_function f.ply --property fit_z --depth 3 --csv z.csv
  check "properties of a file" is_below "$(largest_difference z.csv 3 1)" 1e-5
  check "heading of one function" [ "$(grep -v '^#' z.csv | head -n 1)" = vertex,fit_fit_z ]
  succeeds fit_function sphere.off --normals --depth 3 --csv n.csv
  check "normals" is_below "$(largest_difference n.csv 1 1)" 1e-2
  check "heading of normals" [ "$(grep -v '^#' n.csv | head -n 1)" = vertex,fit_nx,fit_ny,fit_nz ]
  succeeds fit_function sphere.off --normals --depth 3 --tolerance 1e-13 --energy-tolerance 0.5 \
    --csv n.csv
  check "fits end by their own error" is_below 1e-12 "$(comment relative_residual n.csv)"
  succeeds fit_function sphere.off --normals --depth 3 --tolerance 1e-12 --energy-tolerance 0 \
    --stabilization 1e-4 --csv n.csv
  check "or by the residual" is_below "$(comment relative_residual n.csv)" 1.0001e-12
  succeeds fit_function sphere.off --property z --depth 3 --smoothing 1e9 --csv s.csv
  check "--smoothing leads to the mean" eval "numbers s.csv | is_within -1e-4 1e-4"
  succeeds fit_function sphere.off --property z --depth 3 --assembly monte-carlo --csv m.csv
  check "samples" is_below "$(largest_difference m.csv 3 1)" 1e-2
  fails "property" fit_function sphere.off
  fails "both" fit_function sphere.off --property x --normals
  fails "height" fit_function sphere.off --property height
  fails "smoothing" fit_function sphere.off --property x --smoothing -1
  fails "refinements" fit_function sphere.off --property x --refinements -1
  fails "tolerance" fit_function sphere.off --property x --tolerance 0
  fails "energy-tolerance" fit_function sphere.off --property x --energy-tolerance -1
  fails "energy-tolerance" fit_function sphere.off --property x --energy-tolerance 1
  fails "stabilization" fit_function sphere.off --property x --stabilization nan
  fails "open" fit_function missing.off --normals
}

# What the mesh and its values stand for: a sphere, and functions on it.
test_geometry() {
  local geometry data error program
  : > errors
  for geometry in flat smooth; do
    for data in linear smooth; do
      succeeds solve_poisson sphere.off --depth 5 --rhs z --tolerance 1e-8 --geometry "$geometry" \
        --vertex-data "$data" --csv u.csv
      largest_difference u.csv 3 -0.5 >> errors
    done
  done
  # flat and linear, flat and smooth, smooth and linear, smooth and smooth
  check "smooth geometry and data give the solution of the sphere: $(tr '\n' ' ' < errors)" \
    awk '{ e[NR] = $1 } END { exit !(NR == 4 && e[4] < 2e-5 && e[4] < 0.03 * e[1] &&
      e[4] < 0.1 * e[2] && e[4] < 0.03 * e[3]) }' errors
  succeeds solve_poisson sphere.off --depth 4 --geometry smooth --csv u.csv
  check "the area is that of the sphere" is_near "$(comment area u.csv)" 12.5663706 1e-5
  check "folded faces are counted" [ "$(entry folded)" = faces ]
  succeeds solve_poisson sphere.off --depth 4 --geometry smooth --crease-angle 0 --csv u.csv
  check "between creases faces are flat" is_below "$(comment area u.csv)" 12.56
  for data in linear smooth; do
    succeeds fit_function sphere.off --normals --depth 5 --geometry smooth --vertex-data "$data" \
      --csv "$data.csv"
  done
  check "smooth data of three functions" is_below "$(largest_difference smooth.csv 1 1)" \
    "$(largest_difference linear.csv 1 0.98)"
  succeeds fit_function sphere.off --property z --depth 5 --geometry smooth --vertex-data smooth \
    --csv z.csv
  check "smooth data of one function" is_below "$(largest_difference z.csv 3 1)" 1e-4
  succeeds laplace_spectrum sphere.off --depth 4 --count 4 --geometry smooth --tolerance 1e-5 \
    --csv l.csv
  check "eigenvalues of the sphere: 0, 2, 2, 2" \
    eval "numbers l.csv | tail -n 3 | is_within 1.9998 2.0002"
  fails "vertex-data" solve_poisson sphere.off --vertex-data round
  fails "geometry" laplace_spectrum sphere.off --geometry round
  succeeds implicit_surface sphere 0.3
  # lines: triangles, heading, flat, smooth, projection
  check "implicit_surface: facets have less area than the sphere, 12.5664" \
    eval "awk 'NR == 3 { print \$2 }' out | is_within 12 12.4"
  check "implicit_surface: the others have the same, up to the interpolation by cubics" \
    eval "awk 'NR > 3 { print \$2 }' out | is_within 12.5645 12.5685 && [ \$(wc -l < out) -eq 5 ]"
  check "implicit_surface: their first eigenvalue is 2" \
    eval "awk 'NR > 3 { print \$3 }' out | is_within 1.9990 2.0010"
  fails "usage" implicit_surface
  fails "usage" implicit_surface cube 2
  fails "crease-angle" solve_poisson sphere.off --geometry smooth --crease-angle 181
  fails "unrecognised" laplace_spectrum sphere.off --vertex-data smooth
}

test_curvature() {
  for method in normals face-normals coordinates; do
    succeeds estimate_curvature sphere.off --depth 3 --method $method --csv c.csv --output c.ply
    check "$method: heading of the table" \
      [ "$(grep -v '^#' c.csv | head -n 1)" = vertex,mean,gaussian ]
    check "$method: mean curvature" eval "column c.csv 2 | is_within 0.95 1.05"
    for line in "property uchar red" "property double mean" "property double gaussian"; do
      check "$method: header of the mesh: $line" grep -aqx "$line" c.ply
    done
    check "$method: prints the range of the mean curvature" eval \
      "printf '%s\n' $(entry mean_minimum) $(entry mean_maximum) | is_within 0.95 1.05"
    check "$method: few iterations" is_below "$(comment iterations c.csv)" 15.5
    [ $method = coordinates ] ||
      check "$method: Gaussian curvature" eval "column c.csv 3 | is_within 0.9 1.1 &&
        printf '%s\n' $(entry gaussian_minimum) $(entry gaussian_maximum) | is_within 0.9 1.1"
  done
  check "coordinates give no Gaussian curvature" \
    [ "$(column c.csv 3 | sed 's/-nan/nan/' | sort -u)" = nan ]
  awk 'NF == 4 { print $1, $2, $4, $3; next } { print }' sphere.off > inward.off
  succeeds estimate_curvature inward.off --depth 3 --csv c.csv
  check "inward normals change the sign" eval "column c.csv 2 | is_within -1.05 -0.95"
  check "but not that of the product" eval "column c.csv 3 | is_within 0.9 1.1"
  succeeds estimate_curvature large_sphere.off --depth 3 --smoothing 0 --csv c.csv
  check "radius 9" eval "column c.csv 2 | is_within 0.1 0.122"
  succeeds estimate_curvature small.off --depth 3 --assembly monte-carlo --show gaussian --output gaussian.ply
  fails "method" estimate_curvature sphere.off --method best
  fails "show" estimate_curvature sphere.off --show both
  fails "gaussian" estimate_curvature sphere.off --show gaussian --method coordinates
  fails "clip" estimate_curvature sphere.off --clip 0
  fails "smoothing" estimate_curvature sphere.off --smoothing -1
  fails "stabilization" estimate_curvature sphere.off --stabilization x
  fails "tolerance" estimate_curvature sphere.off --tolerance 1
  fails "open" estimate_curvature missing.off
}

# entry NAME: a number of the summary that the last program printed
entry() { awk -v name="$1" '$1 == name { print $2 }' out; }

# bake FOLDER OPTION...: scans of ball.off, a finer sphere, with a pattern
bake() {
  make_sphere 32 > ball.off # 4098 vertices, 8192 faces
  succeeds bake_scans ball.off "$1" --quiet --views 6 --resolution 256 "${@:2}"
}

test_scans() {
  bake scans
  check "six scans" [ "$(ls scans/scan_*.ply | wc -l)" -eq 6 ]
  check "six poses" [ "$(grep -vc '^#' scans/poses.conf)" -eq 6 ]
  check "the truth has the vertices of the mesh" grep -q "element vertex 4098" scans/truth.ply
  check "the truth has colors" grep -q "property uchar red" scans/truth.ply
  # exposures from 1 / 1.3 to 1
  succeeds bake_scans ball.off printed --views 6 --resolution 32 --exposure-range 0.3
  check "the largest exposure" is_near "$(awk 'NR > 1 { print $4 }' out | sort -n | tail -n 1)" 1 0
  check "the smallest one" \
    is_near "$(awk 'NR > 1 { print $4 }' out | sort -n | head -n 1)" 0.769 0.0005
  check "no color is clamped" [ "$(awk 'NR > 1 { s += $7 } END { print s }' out)" -eq 0 ]
  succeeds bake_scans ball.off printed --views 2 --resolution 32 --exposures 3,1
  check "clamped colors are counted" [ "$(awk 'NR == 2 { print $7 }' out)" -gt 0 ]
  bake scans_again
  check "the same again" cmp scans/scan_03.ply scans_again/scan_03.ply
  bake other --seed 1
  check "another seed, other exposures" [ "$(cmp scans/scan_03.ply other/scan_03.ply | wc -l)" -eq 1 ]
  bake points --points
  check "points have normals" grep -q "property double nx" points/scan_00.ply
  check "points have no faces" [ "$(grep -c 'element face' points/scan_00.ply)" -eq 0 ]
  succeeds bake_scans scans/truth.ply from_colors --views 2 --resolution 32 --quiet
  check "colors of a file are kept" cmp scans/truth.ply from_colors/truth.ply

  fails "no mesh" bake_scans
  fails "no folder" bake_scans ball.off
  fails "missing.off" bake_scans missing.off x
  fails "views" bake_scans ball.off x --views 0
  fails "resolution" bake_scans ball.off x --resolution 1
  fails "light" bake_scans ball.off x --light 2
  fails "not both" bake_scans ball.off x --exposures 1,1 --exposure-range 0.1
  fails "2 numbers for 6 views" bake_scans ball.off x --views 6 --exposures 1,1
  fails "positive number" bake_scans ball.off x --views 2 --exposures 1,zero
  : > occupied
  fails "cannot make the folder" bake_scans ball.off occupied/x --views 2 --resolution 16
  check "nothing is written on an error" [ ! -e x ]
}

test_stitching() {
  local columns
  bake scans
  succeeds stitch_colors ball.off scans/scan_*.ply --poses scans/poses.conf --depth 5 \
    --truth scans/truth.ply --csv stitched.csv --output stitched.ply
  check "all is covered" is_near "$(entry uncovered_area)" 0 0.001
  check "the error is small" is_below "$(entry rms_error)" 0.01
  # edges are ten pixels long, which softens the steps of the pattern between them
  check "seams are gone" is_near "$(entry jump)" "$(entry true_jump)" 0.008
  columns=$(sed -n '/^#/!{p;q}' stitched.csv)
  check "columns of the table: $columns" [ "$columns" = vertex,red,green,blue ]
  check "a line for each vertex" [ "$(numbers stitched.csv | wc -l)" -eq 4098 ]
  check "the mesh has colors" grep -q "property uchar red" stitched.ply
  check "the mesh names the scans" grep -q "property double scan" stitched.ply
  local stitched_error
  stitched_error=$(entry rms_error)

  succeeds stitch_colors ball.off scans/scan_*.ply --poses scans/poses.conf --depth 5 \
    --truth scans/truth.ply --method nearest
  check "the nearest scans have seams" \
    is_below 0.02 "$(awk -v a="$(entry jump)" -v b="$(entry true_jump)" 'BEGIN { print a - b }')"
  check "stitching is better than the nearest scan" \
    is_below "$(awk -v x="$stitched_error" 'BEGIN { print 3 * x }')" "$(entry rms_error)"

  bake points --points
  succeeds stitch_colors ball.off points/scan_*.ply --poses points/poses.conf --depth 5 \
    --truth points/truth.ply
  check "points serve as well" is_below "$(entry rms_error)" 0.01
}

test_stitching_options() {
  bake scans
  succeeds stitch_colors ball.off scans/scan_*.ply --poses scans/poses.conf --depth 4 --quiet \
    --threads 1 --csv one.csv
  succeeds stitch_colors ball.off scans/scan_*.ply --poses scans/poses.conf --depth 4 --quiet \
    --gradients scans --no-match-exposures --linear-light --no-details --csv other.csv
  check "options change the result" [ "$(cmp one.csv other.csv | wc -l)" -eq 1 ]
  succeeds stitch_colors ball.off scans/scan_*.ply --poses scans/poses.conf --depth 4 --quiet \
    --threads 2 --csv two.csv
  check "the number of threads does not matter" same_values one.csv two.csv 4098
  # a scan in its own coordinates is a mesh as well
  succeeds stitch_colors scans/scan_02.ply scans/scan_02.ply \
    --poses scans/poses.conf --frame scan_02.ply --depth 4
  check "a scan covers itself" is_below "$(entry uncovered_area)" 0.05
  # turned inside out, the sphere shows its back to all scans
  awk 'NR > 2 && NF == 4 { print $1, $2, $4, $3; next } { print }' ball.off > inside_out.off
  fails "shows its back" stitch_colors inside_out.off scans/scan_*.ply --poses scans/poses.conf
  succeeds stitch_colors inside_out.off scans/scan_*.ply --poses scans/poses.conf --depth 4 \
    --no-oriented --truth scans/truth.ply
  check "unless normals need not point outwards" is_below "$(entry rms_error)" 0.02
  echo "scan_05.ply 1 0 0 100 0 1 0 0 0 0 1 0 0 0 0 1" > far.conf
  grep -v scan_05.ply scans/poses.conf >> far.conf
  succeeds stitch_colors ball.off scans/scan_*.ply --poses far.conf --depth 4 --leave-out
  check "a scan that is far away is left out" grep -q "^5 .* 0.0 %.* 0.0 %.*scan_05.ply" out
  # one scan sees half of the sphere
  succeeds stitch_colors ball.off scans/scan_02.ply --poses scans/poses.conf --depth 4
  check "what is not covered is reported" is_below 0.4 "$(entry uncovered_area)"
}

test_scans_of_points() {
  # a square at z = 5 that faces the origin, and points on it without normals, red = 0.5 + x / 4
  awk 'BEGIN {
    n = 8; print "OFF\n" (n + 1) * (n + 1) " " 2 * n * n " 0"
    for(i = 0; i <= n; ++i) for(j = 0; j <= n; ++j) print 2 * i / n - 1, 2 * j / n - 1, 5
    for(i = 0; i < n; ++i) for(j = 0; j < n; ++j) {
      a = i * (n + 1) + j; b = a + 1; d = a + n + 1; c = d + 1
      print "3 " a " " b " " c; print "3 " a " " c " " d
    } }' > square.off
  awk 'BEGIN {
    n = 40; print "ply\nformat ascii 1.0\nelement vertex " (n + 1) * (n + 1)
    print "property float x\nproperty float y\nproperty float z\nproperty uchar red"
    print "property uchar green\nproperty uchar blue\nend_header"
    for(i = 0; i <= n; ++i) for(j = 0; j <= n; ++j) {
      x = 2.2 * i / n - 1.1
      print x, 2.2 * j / n - 1.1, 5, int(255 * (0.5 + x / 4) + 0.5), 100, 50
    } }' > cloud.ply
  echo "cloud.ply 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1" > cloud.conf
  succeeds stitch_colors square.off cloud.ply --poses cloud.conf --depth 4 --csv cloud.csv
  check "points without normals cover the square" is_near "$(entry uncovered_area)" 0 0
  check "and give their colors" eval "paste -d, <(tail -n +3 square.off | head -n 81 | tr ' ' ,) \
    <(grep -v '^#' cloud.csv | tail -n +2) | awk -F, '{ d = \$5 - 0.5 - \$1 / 4
      e = \$6 - 100 / 255; if(d * d > 1e-4 || e * e > 1e-4) ++bad } END { exit bad > 0 }'"
  sed 's/^property uchar green$/property uchar gray/' cloud.ply > gray.ply
  echo "gray.ply 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1" > gray.conf
  fails "gray.ply' has no colors" stitch_colors square.off gray.ply --poses gray.conf
}

test_stitching_errors() {
  local scan=scans/scan_00.ply
  bake scans
  rm -f x.csv
  fails_to_stitch() {
    fails "$1" stitch_colors ball.off "${@:2}" --depth 3 --csv x.csv
  }
  fails "no mesh" stitch_colors
  fails "no scan" stitch_colors ball.off --poses scans/poses.conf
  fails_to_stitch "no poses" $scan
  fails_to_stitch "missing.conf" $scan --poses missing.conf
  fails_to_stitch "missing.ply" missing.ply --poses scans/poses.conf
  cp $scan unknown.ply
  fails_to_stitch "no pose for 'unknown.ply'" unknown.ply --poses scans/poses.conf
  fails_to_stitch "no pose for 'other'" $scan --poses scans/poses.conf --frame other
  echo "# nothing" > bad.conf
  fails_to_stitch "holds no pose" $scan --poses bad.conf
  echo "scan_00.ply 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0" > bad.conf
  fails_to_stitch "line 1.*number 16 is missing" $scan --poses bad.conf
  echo "scan_00.ply 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 5" > bad.conf
  fails_to_stitch "more than a name and 16" $scan --poses bad.conf
  echo "scan_00.ply 1 0 0 0 0 1 0 0 0 0 1 0 7 8 9 1" > bad.conf
  fails_to_stitch "last row" $scan --poses bad.conf
  echo "scan_00.ply 1 0 0 0 0 1 0 0 0 0 -1 0 0 0 0 1" > bad.conf
  fails_to_stitch "mirror" $scan --poses bad.conf
  echo "scan_00.ply 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 1" > bad.conf
  fails_to_stitch "singular" $scan --poses bad.conf
  echo "scan_00.ply 1 1 0 0 0 1 0 0 0 0 1 0 0 0 0 1" > bad.conf
  fails_to_stitch "not a rotation" $scan --poses bad.conf
  echo "scan_00.ply 1 0 0 nan 0 1 0 0 0 0 1 0 0 0 0 1" > bad.conf
  fails_to_stitch "number 4" $scan --poses bad.conf
  { cat scans/poses.conf; tail -n 1 scans/poses.conf; } > bad.conf
  fails_to_stitch "has a pose already" $scan --poses bad.conf
  echo "scan_00.ply 1 0 0 100 0 1 0 0 0 0 1 0 0 0 0 1" > bad.conf
  fails_to_stitch "scan_00.ply' misses the mesh" $scan --poses bad.conf
  cp ball.off colorless.off
  echo "colorless.off 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1" > bad.conf
  fails_to_stitch "colorless.off' has no colors" colorless.off --poses bad.conf
  fails_to_stitch "alpha" $scan --poses scans/poses.conf --alpha 0
  fails_to_stitch "normal-angle" $scan --poses scans/poses.conf --normal-angle 0
  fails_to_stitch "method" $scan --poses scans/poses.conf --method best
  fails_to_stitch "another number of vertices" $scan --poses scans/poses.conf --truth $scan
  check "nothing is written on an error" [ ! -e x.csv ]
}

test_unusual_meshes() {
  # A cube of six squares: triangulated, the vertices stay.
  cat > cube.off << 'CUBE'
OFF
8 6 0
0 0 0
1 0 0
1 1 0
0 1 0
0 0 1
1 0 1
1 1 1
0 1 1
4 3 2 1 0
4 4 5 6 7
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
CUBE
  succeeds solve_poisson cube.off --depth 3 --csv cube.csv
  check "faces are triangulated" [ "$(comment faces cube.csv)" = 12 ]
  check "the table says so" grep -qi "triangulat" out
  check "vertices keep their order: z = 0 first" eval \
    "numbers cube.csv | awk 'NR <= 4 && \$1 <= 0 || NR > 4 && \$1 >= 0 { exit bad = 1 }
                             END { exit bad }'"

  # A hexagon that is not convex, a pentagon that crosses itself, and a square and a triangle that
  # name a vertex twice.
  cat > polygons.off << 'POLYGONS'
OFF
10 4 0
0 0 0
1 0.8 0
2 0 0
2 2 0
1 1.2 0
0 2 0
0 0 1
1 0 1
1 1 1
0 1 1
6 0 1 2 3 4 5
5 6 8 1 7 9
4 6 6 7 8
3 6 6 7
POLYGONS
  succeeds solve_poisson polygons.off --depth 3 --csv polygons.csv
  check "every polygon is triangulated on its own" [ "$(comment faces polygons.csv)" = 9 ]
  check "a triangle that names a vertex twice has no area" \
    [ "$(comment degenerate_faces polygons.csv)" = 1 ]

  # coordinates of a vertex that no face uses
  {
    printf 'ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\n'
    printf 'property float y\nproperty float z\nelement face 1\n'
    printf 'property list uchar int vertex_indices\nend_header\n'
    printf '\0\0\0\0\0\0\300\177\0\0\0\0'         # 0 nan 0
    printf '\0\0\0\0\0\0\0\0\0\0\0\0'             # 0 0 0
    printf '\0\0\200\077\0\0\0\0\0\0\0\0'         # 1 0 0
    printf '\0\0\0\0\0\0\200\077\0\0\0\0'         # 0 1 0
    printf '\003\001\0\0\0\002\0\0\0\003\0\0\0'
  } > unused.ply
  succeeds solve_poisson unused.ply --depth 3 --rhs y --csv unused.csv --output again.ply
  check "only vertices of faces have to be finite" \
    [ "$(numbers unused.csv | sed 's/-//' | grep -n nan)" = 1:nan ]
  succeeds solve_poisson again.ply --depth 3 --rhs-property value

  # other formats
  {
    echo "o sphere"
    awk 'NR > 2 && NF == 3 { print "v " $0 } NF == 4 { print "f", $2 + 1, $3 + 1, $4 + 1 }' \
      sphere.off
  } > sphere.obj
  succeeds solve_poisson sphere.obj --depth 3 --tolerance 1e-6 --csv obj.csv
  check "an obj file gives the same solution" is_below "$(largest_difference obj.csv 3 -0.5)" 5e-3
  {
    echo "solid sphere"
    awk '
      FNR == 2 { n = $1 }
      FNR > 2 && NF == 3 { p[i++] = $0 }
      NF == 4 {
        print "facet normal 0 0 0\nouter loop"
        for(k = 2; k <= 4; ++k) print "vertex " p[$k]
        print "endloop\nendfacet"
      }' sphere.off
    echo "endsolid sphere"
  } > sphere.stl
  succeeds solve_poisson sphere.stl --depth 3 --csv stl.csv
  check "the points of an stl file are merged" [ "$(comment vertices stl.csv)" = 1026 ]
}

# explode MESH.off: the same triangles, each with vertices of its own
explode() {
  awk '
    NR == 2 { n = $1; n_faces = $2 }
    NR > 2 && NF == 3 { p[i++] = $0 }
    NF == 4 { for(k = 2; k <= 4; ++k) q[n_vertices++] = p[$k] }
    END {
      print "OFF\n" n_vertices " " n_faces " 0"
      for(i = 0; i < n_vertices; ++i) print q[i]
      for(i = 0; i < n_vertices; i += 3) print "3", i, i + 1, i + 2
    }' "$1"
}

# make_moebius_strip N: 3 N vertices on a circle of radius 1, with half a turn
make_moebius_strip() {
  awk -v n="$1" '
    function vertex(i, j) { return i < n ? 3 * i + j : 2 - j }
    BEGIN {
      print "OFF\n" 3 * n, 4 * n, 0
      for(i = 0; i < n; ++i) for(j = 0; j < 3; ++j) {
        t = 2 * atan2(0, -1) * i / n
        r = 1 + 0.1 * (j - 1) * cos(t / 2)
        printf "%.17g %.17g %.17g\n", r * cos(t), r * sin(t), 0.1 * (j - 1) * sin(t / 2)
      }
      for(i = 0; i < n; ++i) for(j = 0; j < 2; ++j) {
        print 3, vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)
        print 3, vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)
      }
    }'
}

test_soups() {
  local program
  # Three triangles on one edge, one vertex that no face uses, and a fourth triangle with a vertex of
  # its own at the place of another one.
  cat > soup.off << 'SOUP'
OFF
8 4 0
0 0 0
1 0 0
9 9 9
0 1 0
0 -1 0.5
0 0 1
0 1 0
1 1 1
3 0 1 3
3 0 1 4
3 0 1 5
3 1 6 7
SOUP
  succeeds solve_poisson soup.off --depth 3 --csv soup.csv
  check "all faces on an edge are connected, faces without a common edge are not" \
    [ "$(comment components soup.csv)" = 2 ]
  check "the table says so" \
    eval "grep -q '^components *2, the surface is disconnected: .* mean 0\$' out"
  check "the constants of both are in the kernel" [ "$(comment kernel_dimension soup.csv)" = 2 ]
  check "all have one row, NaN if no face uses them" \
    [ "$(numbers soup.csv | sed 's/-nan/nan/' | grep -n nan)" = 3:nan ]
  check "vertices at the same place are different" eval \
    "[ '$(numbers soup.csv | sed -n 4p)' != '$(numbers soup.csv | sed -n 7p)' ]"
  succeeds solve_poisson soup.off --depth 3 --join 0 --csv soup.csv
  check "--join connects across them" [ "$(comment components soup.csv)" = 1 ]
  check "and gives them the same value" \
    is_near "$(numbers soup.csv | sed -n 4p)" "$(numbers soup.csv | sed -n 7p)" 1e-9

  # no two faces have a vertex in common
  explode small.off > exploded.off
  for program in solve_poisson laplace_spectrum; do
    succeeds "$program" exploded.off --depth 3 --csv apart.csv
    check "$program says that they are" grep -q "^components *128, the surface is disconnected" out
    [ $program != laplace_spectrum ] ||
      check "and how many zeros there are" grep -q "disconnected: each has the eigenvalue 0$" out
    check "$program: as many components as faces" \
      [ "$(comment components apart.csv)" = 128 ]
    succeeds "$program" exploded.off --depth 3 --join 0 --csv joined.csv
    check "$program --join 0: one component" [ "$(comment components joined.csv)" = 1 ]
    succeeds "$program" small.off --depth 3 --csv small.csv
    check "$program --join 0: the space of the closed mesh" \
      is_near "$(comment dimension joined.csv)" "$(comment dimension small.csv)" 0
    fails "join" "$program" small.off --join -1
    fails "join" "$program" small.off --join x
    fails "join" "$program" small.off --join nan
    fails "join" "$program" small.off --join
  done

  # Along the strip u is about -y: it would jump if the strip were cut where its orientation
  # changes, at y = 0.
  make_moebius_strip 60 > moebius.off
  succeeds solve_poisson moebius.off --depth 5 --rhs y --csv moebius.csv --output moebius.ply
  check "a Moebius strip is one component" [ "$(comment components moebius.csv)" = 1 ]
  numbers moebius.csv > u
  check "and its solution does not jump" is_below "$(awk '
    NR == FNR { u[FNR - 1] = $1; next }
    NF == 4 {
      for(k = 2; k <= 4; ++k) {
        d = u[$k] - u[$(k == 4 ? 2 : k + 1)]
        if(d * d > largest) largest = d * d
      }
    }
    END { print sqrt(largest) }' u moebius.off)" 0.2
  succeeds solve_poisson moebius.ply --depth 5 --rhs-property value

  # two squares that are much nearer to each other than the width of the cells, and a third one
  cat > plates.off << 'PLATES'
OFF
12 3 0
0 0 0
1 0 0
1 1 0
0 1 0
0 0 0.01
1 0 0.01
1 1 0.01
0 1 0.01
0 0 0.5
1 0 0.5
1 1 0.5
0 1 0.5
4 0 1 2 3
4 4 5 6 7
4 8 9 10 11
PLATES
  succeeds solve_poisson plates.off --depth 4 --rhs x --csv split.csv
  succeeds solve_poisson plates.off --depth 4 --rhs x --no-split --csv unsplit.csv
  check "plates that are near have a sheet each in a cell" \
    [ $((2 * $(comment sheets split.csv))) -eq $((3 * $(comment cells split.csv))) ]
  check "and share no element" \
    [ $((3 * $(comment split_elements split.csv))) -eq $((2 * $(comment dimension split.csv))) ]
  check "each has its constants" [ "$(comment kernel_dimension split.csv)" = 3 ]
  check "--no-split: they are one" \
    [ $((3 * $(comment dimension unsplit.csv))) -eq $((2 * $(comment dimension split.csv))) ]
  check "--no-split: and have one constant" [ "$(comment kernel_dimension unsplit.csv)" = 2 ]
  for options in --no-split --paper; do
    succeeds laplace_spectrum plates.off --depth 4 $options --csv unsplit.csv
    check "$options: no element is split" [ "$(comment split_elements unsplit.csv)" = 0 ]
  done
}

# Points in place of a mesh: the vertices of sphere.off, whose normals are their coordinates.
test_points() {
  awk 'NR > 2 && NF == 3 { print $0, $0 }' sphere.off > points.xyz
  awk '{ print $1, $2, $3 }' points.xyz > bare.xyz
  { printf 'ply\nformat ascii 1.0\nelement vertex %d\n' "$(wc -l < points.xyz)"
    printf 'property double %s\n' x y z nx ny nz
    echo end_header
    cat points.xyz; } > points.ply
  sed 's/property double n/property double m/' points.ply > bare.ply
  for file in points.xyz points.ply; do
    succeeds solve_poisson $file --depth 2 --csv u.csv --output u.ply
    check "$file: u = -z / 2" is_below "$(largest_difference u.csv 3 -0.5)" 0.01
    check "$file: points" [ "$(comment points u.csv)" = 1026 ]
    check "$file: area" is_near "$(comment area u.csv)" 12.566 0.1
    # what is written can be read again
    succeeds laplace_spectrum u.ply --depth 2 --count 4 --split --neighbors 12 --csv e.csv
    for value in $(numbers e.csv | tail -n 3); do
      check "$file: eigenvalues 2" is_near "$value" 2 0.02
    done
    check "$file: one component" [ "$(comment components e.csv)" = 1 ]
  done
  fails "normal" laplace_spectrum bare.xyz
  fails "normal" laplace_spectrum bare.ply
  sed '5s/.*/0 0 1 0 0 0/' points.xyz > bad.xyz
  fails "point 4 has a normal of length zero" solve_poisson bad.xyz
  sed '5s/.*/0 0 1 0/' points.xyz > short.xyz
  fails "short.xyz.*line 5" solve_poisson short.xyz
  sed 's/property double \([xyz]\)$/property float \1/' points.ply > types.ply
  succeeds solve_poisson types.ply --depth 2 --csv types.csv
  check "numbers of all types are the same" cmp <(numbers types.csv) <(numbers u.csv)
  sed '/property double y/d' points.ply > flat.ply
  fails "'y'" solve_poisson flat.ply
  echo '# none' > empty.xyz
  fails "no point" solve_poisson empty.xyz
  fails " --operator cotangent needs .*triangles" laplace_spectrum points.xyz --operator cotangent
  fails " --assembly monte-carlo needs .*triangles" laplace_spectrum points.xyz \
    --assembly monte-carlo
  fails " --neighbors is 2" laplace_spectrum points.xyz --neighbors 2
  fails " --refine needs a mesh" laplace_spectrum points.xyz --refine 2 --output points_2.ply
  fails "set of points" laplace_spectrum sphere.off --split
  fails "sampling" laplace_spectrum sphere.off --assembly monte-carlo --sampling regular
  succeeds laplace_spectrum sphere.off --depth 3 --count 2 --csv stratified.csv \
    --assembly monte-carlo --samples 50000 --sampling stratified
  check "stratified samples" is_near "$(numbers stratified.csv | tail -n 1)" 2 0.01
}

test_distances() {
  # the first vertices are on the axes
  succeeds geodesic_distance sphere.off --source 0 --csv d.csv --output d.ply
  check "half of a great circle" \
    is_near "$(sed -n 's/^largest_distance *//p' out)" 3.1416 0.01
  check "its columns" grep -qx "vertex,distance,nearest" d.csv
  check "the source" grep -qx "0,0,0" d.csv
  check "its properties" grep -qa "^property double distance" d.ply
  succeeds geodesic_distance sphere.off --source 0 1 --exact --show nearest --output d.ply --csv d.csv
  check "two regions" [ "$(grep -v '^[#v]' d.csv | cut -d, -f3 | sort -u | paste -sd' ')" = "0 1" ]
  succeeds geodesic_distance sphere.off --farthest 3
  check "three sources" [ "$(sed -n '/^sources/,$p' out | wc -l)" -eq 4 ]
  printf 'OFF\n5 4 0\n0 0 0\n4 0 0\n4 4 0\n0 4 0\n2 2 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n' > square.off
  fails "--maximum-memory is 0.1 MB: the windows of rays would take more" \
    geodesic_distance sphere.off --source 0 --maximum-memory 1e-4
  succeeds geodesic_distance square.off --boundary
  check "the center is farthest from the boundary" \
    is_near "$(sed -n 's/^largest_distance *//p' out)" 2 1e-5
  succeeds geodesic_distance sphere.off --source 0 --path 1 1 --isolines 3 --lines lines.obj \
    --refine 2 --depth 4 --output d.ply --csv d.csv
  check "a path as long as the distance" \
    is_near "$(sed -n '/^path_length/{s/[^ ]* *//p;q}' out)" "$(sed -n 's/^1,\([^,]*\),.*/\1/p' d.csv)" 0.001
  check "a line for each path and isoline" [ "$(grep -c '^l ' lines.obj)" = 5 ]
  check "the mesh is refined" [ "$(sed -n 's/^element vertex //p' d.ply)" -gt 3000 ]
  printf 'OFF\n6 2 0\n0 0 0\n2 0 0\n2 2 0\n0 0 0\n2 2 0\n0 2 0\n3 0 1 2\n3 3 4 5\n' > cracked.off
  succeeds geodesic_distance cracked.off --source 1 --join 1e-9
  check "over a joined crack" is_near "$(sed -n 's/^largest_distance *//p' out)" 2.828427 1e-5
  succeeds geodesic_distance cracked.off --source 1
  check "not over a crack" is_near "$(sed -n 's/^unreached_vertices *//p' out)" 3 0
  fails "join" geodesic_distance cracked.off --source 1 --join -1
  awk 'NR > 2 && NF == 3 && n++ < 1026 { print $0, $0 }' sphere.off > sphere.xyz
  succeeds geodesic_distance sphere.xyz --source 0 --output d.ply
  check "half of a great circle on points" \
    is_near "$(sed -n 's/^largest_distance *//p' out)" 3.1416 0.03
  fails "needs --path" geodesic_distance sphere.off --source 0 --lines lines.obj
  fails "depth" geodesic_distance sphere.off --source 0 --depth 4
  fails "lines" geodesic_distance sphere.off --source 0 --path 1 --lines lines.txt
  fails "vertex 100000" geodesic_distance sphere.off --source 0 --path 100000
  fails "no source" geodesic_distance sphere.off
  fails "boundary, but the surface has none" geodesic_distance sphere.off --boundary
  fails "vertex 100000" geodesic_distance sphere.off --source 100000
  fails "source" geodesic_distance sphere.off --source -1
  fails "farthest" geodesic_distance square.off --boundary --farthest 2
  fails "show" geodesic_distance sphere.off --source 0 --show both
  fails "open" geodesic_distance missing.off --source 0
}

test_short_programs() {
  local program
  succeeds minimal_poisson sphere.off
  # u = -z / 2
  check "minimal_poisson prints the range of u" \
    eval "grep -Eo -- '-?[0-9]+\\.[0-9]+' out | paste -s |
          awk '{ exit !(NF == 2 && \$1 < -0.49 && \$1 > -0.51 && \$2 > 0.49 && \$2 < 0.51) }'"
  fails "usage" minimal_poisson
  succeeds minimal_descriptors sphere.off
  check "minimal_descriptors prints times, a distance, eigenvalues" \
    eval "[ \$(grep -c '^heat kernel signature at time ' out) -eq 5 ] &&
          grep -q '^biharmonic distance.* 0\\.' out &&
          grep -q '^ShapeDNA: *0 *25\\.' out"
  fails "usage" minimal_descriptors
  succeeds minimal_curvature sphere.off
  check "minimal_curvature prints curvatures" \
    eval "sed -n 's/^mean curvature is between \(.*\) and \(.*\)/\1\n\2/p' out |
          is_within 0.95 1.05"
  check "and an error" grep -q "error of 0\.0" out
  fails "usage" minimal_curvature
  succeeds minimal_gradient_field sphere.off
  check "minimal_gradient_field finds the functions" \
    eval "sed -n 's/^splines: largest error \([^ ]*\) .*/\1/p' out | is_within 0 0.02"
  check "and better with details" \
    eval "sed -n 's/^with details: largest error \([^ ]*\) .*/\1/p' out | is_within 0 0.001"
  fails "usage" minimal_gradient_field
  succeeds minimal_stitching sphere.off
  check "minimal_stitching shows that seams vanish" \
    eval "awk '{ for(i = 2; i <= NF; ++i) { if(\$i ~ /^before/) b = \$(i - 1)
                   if(\$i ~ /^after/) a = \$(i - 1) } }
          END { exit !(a > 0 && a < b / 2) }' out"
  fails "usage" minimal_stitching
  # the first three vertices have one face, without an area
  awk 'NR == 2 { n = $1; $1 += 3; ++$2; print $0 "\n7 7 7\n8 8 8\n9 9 9"; next }
    NR > n + 2 { for(i = 2; i <= 4; ++i) $i += 3 }
    { print }
    END { print "3 0 1 2" }' sphere.off > needle.off
  for program in minimal_poisson minimal_curvature minimal_descriptors; do
    succeeds $program needle.off
    check "$program leaves out what is no number" eval "! grep -E '(between|from|to|and) -?nan' out"
  done
  # CGAL adds a line of its own
  run minimal_poisson missing.off
  check "minimal_poisson fails without a mesh, and tells its usage" \
    eval '[ "$status" -eq 1 ] && grep -q "^usage: minimal_poisson" err'
  succeeds minimal_distances sphere.off
  check "minimal_distances prints half of a great circle" \
    is_near "$(sed -n 's/^the vertex that is farthest.*: //p' out)" 3.1416 0.01
  fails "usage" minimal_distances
  cp sphere.off elephant.off
  succeeds first_steps
  check "first_steps prints the first eigenvalue of a sphere" is_near "$(tail -n 1 out)" 2 0.02
  succeeds eigen_matrices
  check "eigen_matrices comes near to the solution" \
    is_below "$(awk '/error of u/ { print $NF }' out)" 1e-4
  # a mesh that the library refuses
  printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n' > line.off
  for program in poisson spectrum descriptors curvature gradient_field stitching; do
    fails "^minimal_$program: .*area" minimal_$program line.off
  done
  succeeds generic_meshes sphere.off
  check "generic_meshes uses at least two types" [ "$(grep -c "u is between" out)" -ge 2 ]
  check "and finds the same solution with all" \
    [ "$(sed 's/^[^:]*: //' out | cut -d' ' -f4 | cut -c1-6 | sort -u | wc -l)" -eq 1 ]
  fails "usage" generic_meshes
  awk 'NR > 2 && NF == 3 { print $0, $0 }' sphere.off > minimal.xyz
  succeeds minimal_points minimal.xyz
  check "minimal_points prints eigenvalues and a range" [ "$(wc -l < out)" -eq 2 ]
  check "the second of which is 2" is_near "$(sed -n '1s/.*: [^ ]* \([^ ]*\) .*/\1/p' out)" 2 0.05
  sed '5s/.*/0 0 1 0 0 0/' minimal.xyz > no_normal.xyz
  fails "^minimal_points: point 4 .*normal" minimal_points no_normal.xyz
  fails "usage" minimal_points
  succeeds laplacian_steps sphere.off
  check "laplacian_steps: the entries of the mass matrix sum to the area" \
    eval "[ -n \"\$(sed -n 's/.* functions on a surface of area //p' out)\" ] &&
          [ \"\$(sed -n 's/.* functions on a surface of area //p' out)\" = \
            \"\$(sed -n 's/^entries of the mass matrix sum to //p' out)\" ]"
  # u = -x / 2, the first face is at (0, 0, -1), and the mean of the squared gradient is 1 / 6
  check "laplacian_steps: values" eval "sed -n 's/^u2 = \([^,]*\),.*/\1/p' out | is_within 0.49 0.505"
  check "laplacian_steps: values of the others" \
    eval "sed -n 's/^u[01] = \([^,]*\),.*/\1/p' out | is_within 0.005 0.02"
  check "laplacian_steps: energies" \
    eval "[ \$(grep -c Dirichlet out) -eq 3 ] &&
          sed -n 's/.*Dirichlet energy //p' out | is_within 2.05 2.12"
  fails "usage" laplacian_steps
}

# The programs that show how to extend the package.
test_extensions() {
  succeeds smooth_surface sphere.off smooth.off
  # Coordinates are eigenfunctions for 2: a factor of 1 / (1 + 2 t), 0.9975 with t = area / 10000;
  # and the faces lie up to 0.4 % inside the sphere.
  check "smooth_surface shrinks a sphere as it should" \
    eval "awk 'NF == 3 && !/OFF/ && !/ 0\$/ { print sqrt(\$1^2 + \$2^2 + \$3^2) }' smooth.off |
          is_within 0.9950 0.9975"
  fails "usage" smooth_surface sphere.off
  fails "cannot write" smooth_surface sphere.off missing/smooth.off
  succeeds custom_smoother sphere.off
  check "custom_smoother shows that patches are better than points, and points than Jacobi" \
    eval "sed 's/.*: \([0-9]*\) iterations.*/\1/' out |
          awk 'NR > 1 && \$1 >= last { exit 1 } { last = \$1 } END { exit NR != 3 }'"
  fails "usage" custom_smoother
  succeeds solver_backends sphere.off
  check "solver_backends finds the same solution by all" \
    eval "sed 's/.*differs by \([^ ]*\) in L2/\1/' out | is_within 0 1e-8"
  fails "usage" solver_backends
}

# One mesh of CGAL's data, for what small shapes do not have.
test_data() {
  local mesh="$data/elephant.off"
  if [ ! -r "$mesh" ]; then
    echo "SKIPPED: test_data: there is no $mesh"
    return
  fi
  succeeds solve_poisson "$mesh" --depth 5 --tolerance 1e-6 --csv e.csv
  check "one row for each vertex" \
    [ "$(numbers e.csv | wc -l)" -eq "$(sed -n 2p "$mesh" | cut -d' ' -f1)" ]
  check "converged" is_below "$(comment relative_residual e.csv)" 1.0001e-6
}

if [ $# -eq 0 ]; then
  mapfile -t groups < <(declare -F | sed -n 's/^declare -f \(test_\)/\1/p')
  set -- "${groups[@]}"
fi
for group in "$@"; do
  if [[ "$group" != test_* ]] || ! declare -F "$group" > group.log; then
    echo "there is no group $group" >&2
    exit 2
  fi
  "$group"
done
report_checks
