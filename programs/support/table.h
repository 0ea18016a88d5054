// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PROGRAMS_TABLE_H
#define RESTRICTED_LAPLACIAN_3_PROGRAMS_TABLE_H

// The short table that a program prints, and the long one that it writes.

#include "mesh_input.h"
#include "program.h"

#include <Eigen/Core>

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace programs {

// where values begin in the lines of the short table
constexpr int value_column = 26;

// What a program knows about its result, in the order in which it is printed.
class Summary {
public:
  // starts with what was read: a surface, of which it is known whether the file had faces that are
  // not triangles
  template <typename Surface> Summary(const Surface& surface, bool is_triangulated) {
    if(surface.is_point_set())
      add("points", surface.number_of_vertices());
    else {
      add("vertices", surface.number_of_vertices());
      add("faces", surface.number_of_faces());
    }
    if(is_triangulated)
      add("triangulated", "yes");
    if(surface.number_of_degenerate_faces() > 0)
      add("degenerate_faces", surface.number_of_degenerate_faces());
    add("area", surface.area());
  }
  explicit Summary(const Mesh_input& input) : Summary(input.surface, input.is_triangulated) {}

  template <typename Number> void add(const std::string& name, Number value) {
    add_line(name, value, "", false);
  }
  // what is printed on request only
  template <typename Number> void add_detail(const std::string& name, Number value) {
    add_line(name, value, "", true);
  }
  // with words behind the value, for people
  template <typename Number>
  void add_explained(const std::string& name, Number value, const std::string& words) {
    add_line(name, value, words, false);
  }

  // as a table for people
  void print(std::ostream& out, bool with_details) const {
    for(const Line& line : m_lines)
      if(with_details || !line.is_detail)
        out << std::left << std::setw(value_column) << line.name << line.brief << '\n';
  }

  // as comments at the beginning of a file for programs
  void print_comments(std::ostream& out) const {
    for(const Line& line : m_lines)
      out << "# " << line.name << ": " << line.exact << '\n';
  }

private:
  template <typename Number>
  void add_line(const std::string& name, Number value, const std::string& words, bool is_detail) {
    std::ostringstream brief, exact;
    brief << std::setprecision(6) << value << words;
    exact << std::setprecision(std::numeric_limits<double>::max_digits10) << value;
    m_lines.push_back({name, brief.str(), exact.str(), is_detail});
  }

  struct Line {
    std::string name, brief, exact;
    bool is_detail;
  };
  std::vector<Line> m_lines;
};

// Writes the lines of `summary` as comments, and a named column for each column of a matrix; its
// rows are numbered in the column `position`.
inline void write_csv(const std::string& file, const Summary& summary, const std::string& position,
                      const std::vector<std::string>& columns, const Eigen::MatrixXd& values) {
  write_file(file, [&](std::ostream& out) {
    summary.print_comments(out);
    out << position;
    for(const std::string& column : columns)
      out << ',' << column;
    for(Eigen::Index i = 0; i < values.rows(); ++i) {
      out << '\n' << i;
      for(const double value : values.row(i))
        out << ',' << value;
    }
    out << '\n';
  });
}

// some eigenvalues as lines of the short table
inline void print_eigenvalues(std::ostream& out, const Eigen::VectorXd& values) {
  constexpr Eigen::Index largest_number = 20;
  for(Eigen::Index i = 0; i < std::min(values.size(), largest_number); ++i)
    out << std::left << std::setw(value_column) << (i == 0 ? "eigenvalues" : "") << values[i]
        << '\n';
  if(values.size() > largest_number)
    out << std::setw(value_column) << ""
        << "... (--csv writes all)\n";
}

} // namespace programs

#endif // RESTRICTED_LAPLACIAN_3_PROGRAMS_TABLE_H
