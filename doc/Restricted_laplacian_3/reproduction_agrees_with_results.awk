# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

# Checks that the tables of the manual's page on the paper have the figures of the stored results of
# the benchmarks, rounded.
#
# usage: awk -f reproduction_agrees_with_results.awk RESULT... Reproduction.txt
#
# Above each table of the page a comment names it; figures.py makes those whose name begins with paper_. A row is known by its first column. All numbers
# in the others have to be those that the results have for it, in the same order.

function complain(text) {
  print FILENAME ":" FNR ": " text
  ++errors
}

# expects one more number in a row of a table
function expect(table, row, value) {
  expected[table, row, ++number_of_expected[table, row]] = value + 0
}

FNR == 1 {
  is_page = FILENAME ~ /Reproduction\.txt$/
  result = FILENAME
  sub(/.*\//, "", result)
  sub(/\.txt$/, "", result)
  part = ""
}

# Spectra: dimensions, changes, the sphere.

result == "spectrum_study" && /^# the paper: / {
  shape = $4
  for(i = 0; i < 6; ++i)
    of_paper[shape, i] = $(NF - 5 + i)
}
result == "spectrum_study" && /^# dimensions/ { part = "dimensions" }
result == "spectrum_study" && /^# relative change/ { part = "change" }
result == "spectrum_study" && /^$/ { part = "" }
result == "spectrum_study" && part == "dimensions" && !/^#/ {
  shape = $1
  if(shape == "sphere_icosahedral_depth_3")
    shape = "sphere"
  for(i = 0; i < 9; ++i)
    dimension[shape, i] = $(3 + i)
  row_of_shape[shape] = shape ", " $2
}
result == "spectrum_study" && part == "change" && !/^#/ && $2 == 5 {
  change[$1, $4, $3] = $5
  shapes[$1]
}
result == "spectrum_study" && /^# sphere_icosahedral_depth_/ {
  sphere = ""
  operator = $5 $7
  sub(/,/, " ", operator)
  sub(/,$/, "", operator)
  unknowns = $8
  if(operator == "cotangent 3")
    sphere = "cotangent, 10,242 vertices"
  else if(operator == "paper 3")
    sphere = "paper's space on it, depth 3"
  else if(operator ~ /^restricted [35]$/)
    sphere = "default space, depth " substr(operator, length(operator))
}
result == "spectrum_study" && sphere != "" && /^largest_abs/ {
  expect("sphere", sphere, unknowns)
  for(of_degree = 6; of_degree <= 13; of_degree += 7) {
    largest = 0
    for(i = 1; i <= of_degree; ++i)
      if($(i + 1) + 0 > largest)
        largest = $(i + 1) + 0
    expect("sphere", sphere, largest)
  }
  sphere = ""
}

# Colors from their gradients.

result == "gradient_integration" && $4 == "w_cycle" && $2 == 8 {
  for(i = 1; i <= 3; ++i)
    gradients[$1, $3, i] = $(i == 1 ? 5 : NF - 4 + i)
  meshes[$1]
}

# Normals.

result == "curvature_study_normals" && / of vertices / {
  row = $1 " " $4
  expect("normals", row, $5)
  expect("normals", row, $9)
  expect("normals", row, $10)
}

# Curvature near edges.

result == "curvature_study_edges" && !/^#/ && $2 == 8 {
  for(i = 5; i <= 7; ++i)
    expect("edges", $4, $i)
}

# Normals from their gradients.

result == "normal_fitting" && $1 == "cow_5k8" && $2 == 8 && ($4 == "0" || $4 == "0.05/h^2") {
  row = $3 == "paper" ? "paper's space" : $3
  if($4 == "0")
    expect("cow", row, $6)
  expect("cow", row, $(NF - 2))
}
result == "normal_fitting" && $3 ~ /split/ && ($4 == "0" || $4 == "0.05/h^2") {
  row = $3 ($4 == "0" ? "" : ", alpha 1/20 h^-2")
  if($1 == "cow_5k8")
    screening[row, $2 - 5] = $(NF - 2)
  else
    screening[row, $2 - 1] = $(NF - 2)
  screening_rows[row]
}

# The page: what follows from the results read so far.

is_page && FNR == 1 {
  for(shape in row_of_shape) {
    row = row_of_shape[shape]
    for(i = 0; i < 9; ++i) {
      expect("dimensions", row, dimension[shape, i])
      if(i < 6)
        expect("dimensions", row, of_paper[shape, i])
    }
  }
  for(shape in shapes) {
    split("cotangent paper restricted", operators, " ")
    for(i = 1; i <= 3; ++i) {
      expect("change", shape, change[shape, operators[i], "medium"])
      expect("change", shape, change[shape, operators[i], "low"])
    }
  }
  for(mesh in meshes)
    for(i = 1; i <= 6; ++i)
      expect("gradients", mesh, gradients[mesh, i <= 3 ? "paper" : "split", (i - 1) % 3 + 1])
  for(row in screening_rows)
    for(i = 1; i <= 6; ++i)
      expect("screening", row, screening[row, i])
}

is_page && /^<!-- table: / {
  table = $3
  line_of_table = 0
}
is_page && !/^\|/ && !/^<!--/ {
  if(line_of_table > 0)
    table = ""
}
is_page && /^\|/ {
  if(table == "")
    complain("a table without a name")
  if(table ~ /^(text|paper_)/)
    next
  if(++line_of_table <= 2)
    next
  line = $0
  while(match(line, /\\f\$[0-9.]+ \\cdot 10\^\{-?[0-9]+\}\\f\$/)) {
    power = substr(line, RSTART + 3, RLENGTH - 6)
    gsub(/ \\cdot 10\^\{/, "e", power)
    sub(/\}/, "", power)
    line = substr(line, 1, RSTART - 1) power substr(line, RSTART + RLENGTH)
  }
  gsub(/, \\f\$\\alpha = \\frac\{1\}\{20\} h\^\{-2\}\\f\$/, ", alpha 1/20 h^-2", line)
  number_of_fields = split(line, fields, / *\| */)
  row = fields[2]
  first = 3
  if(table == "normals") {
    row = row " " fields[3]
    first = 4
  }
  ++checked[table]
  if(!((table, row) in number_of_expected)) {
    complain("table " table ": the results have no row '" row "'")
    next
  }
  position = 0
  for(i = first; i < number_of_fields; ++i) {
    text = fields[i]
    gsub(/,/, "", text)
    while(match(text, /[0-9][0-9.]*(e-?[0-9]+)?/)) {
      check(substr(text, RSTART, RLENGTH), expected[table, row, ++position])
      text = substr(text, RSTART + RLENGTH)
    }
  }
  if(position != number_of_expected[table, row])
    complain("table " table ", row '" row "': " position " numbers in place of " \
             number_of_expected[table, row])
}

# a number of the page is that of the results, rounded to as many digits as it has
function check(text, value, mantissa, exponent, unit) {
  ++numbers
  mantissa = text
  exponent = 0
  if(text ~ /e/) {
    exponent = text
    sub(/.*e/, "", exponent)
    sub(/e.*/, "", mantissa)
  }
  unit = 10 ^ (exponent + 0)
  if(mantissa ~ /\./)
    unit /= 10 ^ (length(mantissa) - index(mantissa, "."))
  if(text - value > 0.5001 * unit || value - text > 0.5001 * unit)
    complain("table " table ", row '" row "': " text ", but the result is " value)
}

END {
  split("dimensions change sphere gradients normals edges cow screening", tables, " ")
  for(i in tables)
    if(!(tables[i] in checked))
      complain("found no table " tables[i])
  if(!errors)
    print numbers " numbers agree"
  exit errors > 0
}
