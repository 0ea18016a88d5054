// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_XYZ_FILE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_XYZ_FILE_H

#include <CGAL/Restricted_laplacian_3/files/internal/Byte_source.h>
#include <CGAL/Restricted_laplacian_3/files/internal/File_contents.h>
#include <CGAL/Restricted_laplacian_3/files/internal/Text_source.h>

#include <array>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Reads a file of points: three coordinates in each line, and in all or in none of them a normal
/// behind.
inline void read_xyz(Byte_source& in, File_contents& contents) {
  Text_source text(in);
  std::size_t columns = 0;
  while(text.next_line()) {
    File_place place;
    place.vertex = contents.points.size();
    if(*place.vertex >= File_contents::maximum_number)
      text.fail("there are too many points");
    std::array<double, 6> numbers;
    std::size_t number = 0;
    for(; number < numbers.size() && !text.is_at_end_of_line(); ++number)
      numbers[number] = text.number("a coordinate", place);
    if((number != 3 && number != 6) || !text.is_at_end_of_line())
      text.fail("a line has three or six numbers, this one " +
                    (number < 6 ? std::to_string(number) : "more"),
                place);
    if(columns != 0 && number != columns)
      text.fail("this line has " + std::to_string(number) + " numbers, those above " +
                    std::to_string(columns),
                place);
    columns = number;
    contents.points.emplace_back(numbers[0], numbers[1], numbers[2]);
    if(columns == 3 || !contents.wants_properties())
      continue;
    if(contents.properties.empty())
      for(const char* name : {"nx", "ny", "nz"})
        contents.properties.push_back({name, "float64", {}});
    for(std::size_t k = 0; k < 3; ++k)
      contents.properties[k].values.push_back(numbers[3 + k]);
  }
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_XYZ_FILE_H
