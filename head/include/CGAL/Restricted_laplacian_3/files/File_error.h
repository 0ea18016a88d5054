// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FILES_FILE_ERROR_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FILES_FILE_ERROR_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>

#include <cstdint>
#include <optional>
#include <string>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Errors
/// A place in a file: what is known of it.
struct File_place {
  /// line of a text file, counted from 1
  std::optional<std::uintmax_t> line;
  /// byte of a binary file, counted from 0
  std::optional<std::uintmax_t> byte;
  /// vertex in the order of the file, counted from 0
  std::optional<std::uintmax_t> vertex;
  /// face in the order of the file, counted from 0
  std::optional<std::uintmax_t> face;
};

/// \ingroup PkgRestrictedLaplacian3Errors
/// A file cannot be read: it is not there, of a format that is not known, or there is something
/// wrong with it.
class File_error : public Input_error {
public:
  /// \param file its name
  /// \param place where it is wrong
  /// \param reason what is wrong; the message consists of all three
  File_error(const std::string& file, const File_place& place, const std::string& reason)
    : Input_error(message(file, place, reason)), m_file(file), m_place(place) {}

  /// name of the file
  const std::string& file() const noexcept { return m_file; }
  /// where it is wrong
  const File_place& place() const noexcept { return m_place; }

private:
  static std::string message(const std::string& file, const File_place& place,
                             const std::string& reason) {
    std::string places;
    const auto add = [&places](const char* name, const std::optional<std::uintmax_t>& number) {
      if(number)
        places += std::string(", ") + name + ' ' + std::to_string(*number);
    };
    add("line", place.line);
    add("byte", place.byte);
    add("vertex", place.vertex);
    add("face", place.face);
    return '\'' + file + '\'' + (places.empty() ? " " : places + ": ") + reason;
  }

  std::string m_file;
  File_place m_place;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FILES_FILE_ERROR_H
