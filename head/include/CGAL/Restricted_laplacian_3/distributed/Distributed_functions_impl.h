// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_FUNCTIONS_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_FUNCTIONS_IMPL_H

#include <CGAL/Restricted_laplacian_3/distributed/Distributed_functions.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Element_exchange.h>
#include <CGAL/Restricted_laplacian_3/distributed/write_in_order.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <ios>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The first lines of a file of functions, up to their number: they tell one space from another.
inline std::string functions_header(const Distributed_space& space) {
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10);
  const std::uint16_t one = 1;
  const Octree_3& octree = space.part().octree();
  char first_byte = 0;
  std::memcpy(&first_byte, &one, 1);
  out << "restricted_laplacian_3 functions 1\nformat binary_"
      << (first_byte == 1 ? "little" : "big") << "_endian\nside_and_origin " << octree.side();
  for(double x : octree.grid_coordinates(0, Point_3(0, 0, 0)))
    out << ' ' << x;
  out << "\nsheets";
  for(int level = 0; level <= space.depth(); ++level)
    out << ' ' << space.number_of_sheets(level);
  out << "\nelements";
  for(int level = 0; level <= space.depth(); ++level)
    out << ' ' << space.dimension(level);
  out << "\nfunctions ";
  return out.str();
}

inline Element_exchange finest_exchange(const Distributed_space& space) {
  const Distributed_level& level = space.level(space.depth());
  return Element_exchange(space.communicator(), level.first_elements, level.elements);
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void save_functions(const Distributed_space& space,
                                                       const std::string& file,
                                                       const Distributed_functions& functions) {
  const Communicator& communicator = space.communicator();
  communicator.agree([&] {
    if(functions.values.size() != functions.coefficients.cols() ||
       (functions.values.size() > 0 &&
        functions.coefficients.rows() != static_cast<Eigen::Index>(space.part().dimension())))
      throw Parameter_error("functions", "do not fit the part of the space");
  });
  const internal::Element_exchange exchange = internal::finest_exchange(space);
  std::vector<std::string> parts(1);
  const auto append = [](std::string& part, const double* numbers, std::size_t number) {
    part.append(reinterpret_cast<const char*>(numbers), number * sizeof(double));
  };
  if(communicator.rank() == 0) {
    parts[0] = internal::functions_header(space) + std::to_string(functions.values.size()) +
               "\nend_header\n";
    append(parts[0], functions.values.data(), static_cast<std::size_t>(functions.values.size()));
  }
  for(Eigen::Index i = 0; i < functions.coefficients.cols(); ++i) {
    parts.emplace_back();
    const std::vector<double> own = exchange.own_values(functions.coefficients.col(i));
    append(parts.back(), own.data(), own.size());
  }
  write_in_order(communicator, file, parts);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Distributed_functions
load_functions(const Distributed_space& space, const std::string& file) {
  const Communicator& communicator = space.communicator();
  const internal::Element_exchange exchange = internal::finest_exchange(space);
  Distributed_functions result;
  std::ifstream in;
  std::streamoff begin = 0;
  communicator.agree([&] {
    in.open(file, std::ios::binary);
    if(!in)
      throw std::runtime_error("cannot open '" + file + "'");
    const std::string expected = internal::functions_header(space);
    std::string header(expected.size(), ' '), line;
    in.read(header.data(), static_cast<std::streamsize>(header.size()));
    const std::string first_line = expected.substr(0, expected.find('\n'));
    if(header.compare(0, first_line.size(), first_line) != 0)
      throw std::runtime_error("'" + file + "' is not a file of functions");
    if(header != expected)
      throw std::runtime_error("the functions in '" + file +
                               "' are those of another surface or of other elements");
    Eigen::Index number = -1;
    in >> number;
    std::getline(in, line);
    std::getline(in, line);
    begin = in.tellg();
    in.seekg(0, std::ios::end);
    const auto size = static_cast<std::uint64_t>(number < 0 ? 0 : number) * sizeof(double) *
                      (1 + space.dimension(space.depth()));
    if(!in || number < 0 || line != "end_header" ||
       static_cast<std::uint64_t>(in.tellg() - begin) != size)
      throw std::runtime_error("'" + file + "' is damaged, or has been cut off");
    in.seekg(begin);
    result.values.resize(number);
    in.read(reinterpret_cast<char*>(result.values.data()),
            static_cast<std::streamsize>(sizeof(double)) * number);
  });
  const Eigen::Index number = result.values.size();
  result.coefficients.resize(static_cast<Eigen::Index>(space.part().dimension()), number);
  std::vector<double> own(exchange.own_size());
  for(Eigen::Index i = 0; i < number; ++i) {
    communicator.agree([&] {
      const std::uint64_t before = static_cast<std::uint64_t>(number) +
                                   static_cast<std::uint64_t>(i) * space.dimension(space.depth()) +
                                   exchange.first();
      in.seekg(begin + static_cast<std::streamoff>(before * sizeof(double)));
      in.read(reinterpret_cast<char*>(own.data()),
              static_cast<std::streamsize>(own.size() * sizeof(double)));
      if(!in)
        throw std::runtime_error("cannot read '" + file + "'");
      for(double x : own)
        if(!std::isfinite(x))
          throw std::runtime_error("'" + file + "' has a coefficient that is not a finite number");
    });
    result.coefficients.col(i) = exchange.known_values(own);
  }
  return result;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_FUNCTIONS_IMPL_H
