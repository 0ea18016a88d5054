#!/usr/bin/env bash
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Tests what the programs for several machines promise: the results of those for one, one line for an
# error, and an end of all processes.
#
# usage: test_mpi_programs.sh BUILD_DIR MPIEXEC

set -u -o pipefail
export LC_ALL=C

build=$(cd "$1" && pwd)
programs=$build/bin
PATH="$programs:$build/examples/Restricted_laplacian_3:$PATH"
checks=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/checks.sh
mpiexec=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 2
source "$checks"

# run NUMBER PROGRAM ARGUMENTS...: with so many processes; leaves `out`, `err` and `status`
run() {
  timeout 60 "$mpiexec" -n "$1" "$(command -v "$2")" "${@:3}" > out 2> err < /dev/null
  status=$?
}

# succeeds NUMBER PROGRAM ARGUMENTS...
succeeds() {
  run "$@"
  check "succeeds: $*: $(head -n 1 err)" [ "$status" -eq 0 ]
  check "prints no error: $*" [ ! -s err ]
}

# fails PATTERN NUMBER PROGRAM ARGUMENTS...: with one line of the program's own on the error stream;
# mpiexec adds some
fails() {
  local pattern=$1
  shift
  run "$@"
  check "exit status $status says failure: $*" [ "$status" -gt 0 -a "$status" -lt 124 ]
  check "one line of error: $*" [ "$(grep -c "^$2: " err)" -eq 1 ]
  check "the error names its cause ($pattern): $*: $(head -n 1 err)" grep -qi "^$2: .*$pattern" err
}

# make_torus N M: a mesh of 2 N M triangles, as a PLY file, binary if `$3` says so
make_torus() {
  awk -v n="$1" -v m="$2" 'BEGIN {
    pi = atan2(0, -1)
    print "ply\nformat ascii 1.0\nelement vertex " n * m
    print "property double x\nproperty double y\nproperty double z"
    print "element face " 2 * n * m "\nproperty list uchar int vertex_indices\nend_header"
    for(i = 0; i < n; ++i)
      for(j = 0; j < m; ++j) {
        a = 2 * pi * i / n; b = 2 * pi * j / m
        printf "%.17g %.17g %.17g\n", (1 + 0.4 * cos(b)) * cos(a), (1 + 0.4 * cos(b)) * sin(a),
               0.4 * sin(b)
      }
    for(i = 0; i < n; ++i)
      for(j = 0; j < m; ++j) {
        k = (i + 1) % n; l = (j + 1) % m
        print 3, i * m + j, k * m + j, k * m + l "\n" 3, i * m + j, k * m + l, i * m + l
      }
  }'
}

# largest_difference FILE OTHER: of the values of two tables, over the largest value
largest_difference() {
  paste -d, <(grep -v '^#' "$1" | cut -d, -f1,2) <(grep -v '^#' "$2") | awk -F, '
    NR > 1 {
      d = $2 - $4; d = d < 0 ? -d : d; m = d > m ? d : m
      a = $2 < 0 ? -$2 : $2; b = a > b ? a : b
      bad += $1 != $3
    }
    END { print bad > 0 || NR < 2 ? 1 : m / b }'
}
is_below() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a < b) }'; }

make_torus 60 30 > text.ply
# A program of this package writes binary files.
"$programs/solve_poisson" text.ply --depth 2 --output binary.ply --quiet

# the results of one process
for options in "--rhs x" "--rhs random --seed 3" "--alpha 20" "--rhs-property value" \
  "--no-split --cycle w" "--join 1e-9 --cube-scale 1"; do
  # shellcheck disable=SC2086
  "$programs/solve_poisson" binary.ply --depth 5 --tolerance 1e-10 $options --csv one.csv --quiet
  for number in 1 3; do
    # shellcheck disable=SC2086
    succeeds $number solve_poisson_mpi binary.ply --depth 5 --tolerance 1e-10 $options \
      --csv several.csv --output several.ply
    check "$number processes, $options: the values of one" \
      is_below "$(largest_difference one.csv several.csv)" 1e-7
    for name in vertices faces dimension depth; do
      check "$number processes, $options: the same $name" \
        cmp <(grep "^# $name:" one.csv) <(grep "^# $name:" several.csv)
    done
    check "no part of a file is left" [ ! -e several.csv.part -a ! -e several.ply.part ]
  done
done
# what is written can be read, and by default the depth is that of one process
succeeds 3 solve_poisson_mpi text.ply --output several.ply --verbose
check "says on how many processes" grep -q "^ranks *3$" out
cp out of_text
succeeds 2 solve_poisson_mpi several.ply --verbose
check "a text file has the surface of a binary one" \
  cmp <(grep -E "^(vertices|faces|area|depth|dimension|sheets) " of_text) \
  <(grep -E "^(vertices|faces|area|depth|dimension|sheets) " out)
# points
awk 'BEGIN {
  srand(1)
  for(i = 0; i < 3000; ++i) {
    do { x = 2 * rand() - 1; y = 2 * rand() - 1; z = 2 * rand() - 1; r = sqrt(x * x + y * y + z * z) }
    while(r > 1 || r < 0.1)
    printf "%.17g %.17g %.17g %.17g %.17g %.17g\n", x / r, y / r, z / r, x / r, y / r, z / r
  }
}' > points.xyz
"$programs/solve_poisson" points.xyz --tolerance 1e-10 --csv one.csv --quiet
succeeds 3 solve_poisson_mpi points.xyz --tolerance 1e-10 --csv several.csv
check "points: the values of one process" is_below "$(largest_difference one.csv several.csv)" 1e-7

# eigenvalues of one process
largest_difference_of_eigenvalues() { # beside the first, which is 0
  paste -d, <(grep -v '^#' "$1") <(grep -v '^#' "$2") | awk -F, '
    NR > 2 { d = $2 / $4 - 1; d = d < 0 ? -d : d; m = d > m ? d : m; bad += $1 != $3 }
    END { print bad > 0 || NR < 3 ? 1 : m }'
}
"$programs/laplace_spectrum" binary.ply --depth 4 --tolerance 1e-6 --count 12 --csv one.csv --quiet
for number in 1 3; do
  succeeds $number laplace_spectrum_mpi binary.ply --depth 4 --tolerance 1e-6 --count 12 \
    --csv several.csv --output several.ply --eigenfunction 3 --verbose
  check "$number processes: the eigenvalues of one" \
    is_below "$(largest_difference_of_eigenvalues one.csv several.csv)" 1e-10
  check "$number processes: prints them" grep -q "^eigenvalues " out
done
check "writes an eigenfunction" grep -aq "property double value" several.ply

# a run goes on, on another number of processes
succeeds 3 laplace_spectrum_mpi binary.ply --depth 4 --tolerance 1e-6 --count 5 --save pairs \
  --continue pairs --verbose
check "begins without a file" grep -q "^eigenpairs_known_before *0$" out
succeeds 2 laplace_spectrum_mpi binary.ply --depth 4 --tolerance 1e-6 --count 12 --save pairs \
  --continue pairs --csv several.csv --verbose
check "begins with what was saved" grep -q "^eigenpairs_known_before *5$" out
check "eigenvalues of a run that went on" \
  is_below "$(largest_difference_of_eigenvalues one.csv several.csv)" 1e-10
succeeds 1 laplace_spectrum_mpi binary.ply --depth 4 --tolerance 1e-6 --count 12 \
  --continue pairs --verbose
check "all were saved" grep -q "^eigenpairs_known_before *12$" out
run 2 laplace_spectrum_mpi binary.ply --depth 4 --tolerance 1e-12 --count 5 -eps_max_it 1
check "exit status 2 says that it did not converge: $status" [ "$status" -eq 2 ]
check "one line says so" [ "$(grep -c "did not converge: it found . of 5 eigenvalues" err)" -eq 1 ]
run 2 solve_poisson_mpi binary.ply --depth 5 --tolerance 1e-8 --save u -ksp_max_it 3
check "exit status 2 says that it did not converge" [ "$status" -eq 2 ]
succeeds 3 solve_poisson_mpi binary.ply --depth 5 --tolerance 1e-8 --continue u --verbose
cp out of_rest
succeeds 3 solve_poisson_mpi binary.ply --depth 5 --tolerance 1e-8 --verbose
check "a solution goes on with fewer iterations" \
  [ "$(awk '/^iterations/ { print $2 }' of_rest)" -lt "$(awk '/^iterations/ { print $2 }' out)" ]

# options of PETSc
succeeds 2 solve_poisson_mpi binary.ply --depth 4 -ksp_monitor
check "-ksp_monitor prints residuals" grep -q "KSP Residual norm" out
run 2 solve_poisson_mpi binary.ply --depth 4 --tolerance 1e-12 -ksp_max_it 1
check "exit status 2 says that it did not converge" [ "$status" -eq 2 ]
check "one line says so" [ "$(grep -c "did not converge" err)" -eq 1 ]
succeeds 2 solve_poisson_mpi --help
check "--help is printed once" [ "$(grep -c "^usage" out)" -eq 1 ]

# what is wrong is said once, and all processes end
# the example for users of the library
for number in 1 3; do
  succeeds $number distributed_surface binary.ply
  mv out example_of_$number
done
succeeds 2 distributed_surface text.ply
check "the example prints an eigenvalue" grep -q '^[0-9]* iterations, .* eigenvalue above 0 is [0-9]' out
check "the example has one result" cmp example_of_1 example_of_3
check "the example has one result for both kinds of files" cmp example_of_1 out
fails "no face" 2 distributed_surface points.xyz

fails "cannot open" 3 solve_poisson_mpi missing.ply
fails "depth" 2 solve_poisson_mpi binary.ply --depth 99
fails "tolerance" 2 solve_poisson_mpi binary.ply --tolerance 7
fails "memory" 2 solve_poisson_mpi binary.ply --maximum-memory 1
fails "energy-tolerance" 2 solve_poisson_mpi binary.ply --energy-tolerance 0.1
fails "smooth" 2 solve_poisson_mpi binary.ply --geometry smooth
fails "count" 2 laplace_spectrum_mpi binary.ply --count 0
fails "cannot open" 2 laplace_spectrum_mpi binary.ply --depth 4 --continue nothing
fails "another surface" 2 laplace_spectrum_mpi binary.ply --depth 3 --continue pairs
fails "not a file of functions" 2 solve_poisson_mpi binary.ply --depth 4 --continue binary.ply
head -c 100000 binary.ply > cut.ply
fails "ends too early" 3 solve_poisson_mpi cut.ply
# the last vertex, which the last process reads, is not a number
cp binary.ply nan.ply
header=$(head -n 30 binary.ply | grep -a -m 1 -b '^end_header' | cut -d: -f1)
printf '\0\0\0\0\0\0\370\177' |
  dd of=nan.ply bs=1 seek=$((header + 11 + 35 * 1799)) conv=notrunc status=none
fails "vertex 1799 .*not a finite number" 3 solve_poisson_mpi nan.ply
# a full disk
fails "cannot write" 2 solve_poisson_mpi binary.ply --depth 3 --csv /dev/full
fails "cannot write" 2 laplace_spectrum_mpi binary.ply --depth 3 --save /dev/full
# no memory on one process
cat > limited.sh <<EOF
#!/bin/sh
if [ "\${OMPI_COMM_WORLD_RANK-\${PMI_RANK-0}}" = 1 ]; then ulimit -v 800000; fi
exec "$programs/solve_poisson_mpi" "\$@"
EOF
chmod +x limited.sh
start=$SECONDS
timeout 60 "$mpiexec" -n 2 ./limited.sh binary.ply --depth 9 --csv big.csv > out 2> err
status=$?
check "a process without memory ends all of them: $status" [ "$status" -ne 0 -a "$status" -ne 124 ]
check "nothing is written" [ ! -e big.csv -a ! -e big.csv.part ]
echo "a process without memory: $((SECONDS - start)) s, $(grep -c memory err) lines"

report_checks
