// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_NUMBER_TYPE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_NUMBER_TYPE_H

#include <CGAL/Restricted_laplacian_3/files/internal/Byte_source.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The types of numbers in binary files.
enum class Number_type {
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64
};

inline const char* name_of(Number_type type) {
  static const char* const names[] = {"int8",   "uint8", "int16",  "uint16",  "int32",
                                      "uint32", "int64", "uint64", "float32", "float64"};
  return names[static_cast<int>(type)];
}

/// in bytes
inline std::size_t size_of(Number_type type) {
  static constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return sizes[static_cast<int>(type)];
}

inline bool is_integer(Number_type type) { return type < Number_type::float32; }

/// The type by its name in PLY and VTK files.
inline std::optional<Number_type> number_type_of(const std::string& name) {
  struct Name {
    const char* name;
    Number_type type;
  };
  static constexpr Name names[] = {{"char", Number_type::int8},
                                   {"int8", Number_type::int8},
                                   {"signed_char", Number_type::int8},
                                   {"uchar", Number_type::uint8},
                                   {"uint8", Number_type::uint8},
                                   {"unsigned_char", Number_type::uint8},
                                   {"short", Number_type::int16},
                                   {"int16", Number_type::int16},
                                   {"ushort", Number_type::uint16},
                                   {"uint16", Number_type::uint16},
                                   {"unsigned_short", Number_type::uint16},
                                   {"int", Number_type::int32},
                                   {"int32", Number_type::int32},
                                   {"vtkidtype", Number_type::int32},
                                   {"uint", Number_type::uint32},
                                   {"uint32", Number_type::uint32},
                                   {"unsigned_int", Number_type::uint32},
                                   {"long", Number_type::int64},
                                   {"int64", Number_type::int64},
                                   {"vtktypeint64", Number_type::int64},
                                   {"uint64", Number_type::uint64},
                                   {"unsigned_long", Number_type::uint64},
                                   {"vtktypeuint64", Number_type::uint64},
                                   {"float", Number_type::float32},
                                   {"float32", Number_type::float32},
                                   {"double", Number_type::float64},
                                   {"float64", Number_type::float64}};
  for(const Name& candidate : names)
    if(name == candidate.name)
      return candidate.type;
  return std::nullopt;
}

/// a number of a type, whose bytes begin at `from`
inline double number_at(const Byte_source& in, const char* from, Number_type type) {
  switch(type) {
  case Number_type::int8: return static_cast<signed char>(*from);
  case Number_type::uint8: return static_cast<unsigned char>(*from);
  case Number_type::int16: return in.number_at<std::int16_t>(from);
  case Number_type::uint16: return in.number_at<std::uint16_t>(from);
  case Number_type::int32: return in.number_at<std::int32_t>(from);
  case Number_type::uint32: return in.number_at<std::uint32_t>(from);
  case Number_type::int64: return static_cast<double>(in.number_at<std::int64_t>(from));
  case Number_type::uint64: return static_cast<double>(in.number_at<std::uint64_t>(from));
  case Number_type::float32: return in.number_at<float>(from);
  case Number_type::float64: break;
  }
  return in.number_at<double>(from);
}

/// an integer of a type, whose bytes begin at `from`; too large ones are -1
inline std::int64_t integer_at(const Byte_source& in, const char* from, Number_type type) {
  switch(type) {
  case Number_type::uint8: return static_cast<unsigned char>(*from);
  case Number_type::int32: return in.number_at<std::int32_t>(from);
  case Number_type::uint32: return in.number_at<std::uint32_t>(from);
  case Number_type::int64: return in.number_at<std::int64_t>(from);
  case Number_type::uint64: {
    const auto value = in.number_at<std::uint64_t>(from);
    return value >> 63 ? -1 : static_cast<std::int64_t>(value);
  }
  default: return static_cast<std::int64_t>(number_at(in, from, type));
  }
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_NUMBER_TYPE_H
