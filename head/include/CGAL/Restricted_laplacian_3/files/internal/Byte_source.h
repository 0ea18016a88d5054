// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_BYTE_SOURCE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_BYTE_SOURCE_H

#include <CGAL/Restricted_laplacian_3/files/File_error.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The bytes of a file from its beginning to its end, a piece of which is in memory; or bytes that
/// are in memory.
class Byte_source {
public:
  /// \throws File_error the file cannot be opened, is none, or is empty
  Byte_source(const std::string& file, const Progress& progress)
    : m_name(file), m_progress(progress) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    if(!std::filesystem::exists(status))
      throw File_error(file, {}, "cannot be opened: " + (error ? error.message() : "not found"));
    // before it is opened: a pipe that nobody writes to would never end
    if(std::filesystem::is_directory(status))
      throw File_error(file, {}, "is a directory");
    if(!std::filesystem::is_regular_file(status))
      throw File_error(file, {}, "is a pipe or a device; only files are read");
    m_size = m_bytes_left = std::filesystem::file_size(file, error);
    errno = 0;
    m_in.open(file, std::ios::binary);
    if(error || !m_in.good())
      throw File_error(file, {},
                       "cannot be opened: " +
                           (error ? error.message() : std::string(std::strerror(errno))));
    if(m_size == 0)
      throw File_error(file, {}, "has 0 bytes");
  }

  /// \param name of the file, for messages
  Byte_source(std::string name, std::string_view bytes)
    : m_name(std::move(name)), m_size(bytes.size()), m_bytes_left(bytes.size()), m_buffer(bytes),
      m_end(bytes.size()) {}

  const std::string& name() const { return m_name; }
  std::uintmax_t size() const { return m_size; }
  /// of the next byte
  std::uintmax_t position() const { return m_size - m_bytes_left; }
  std::uintmax_t bytes_left() const { return m_bytes_left; }

  /// whether there are so many times so many bytes more
  bool holds(std::uintmax_t number, std::uintmax_t size) const {
    return size == 0 || number <= m_bytes_left / size;
  }

  /// The next bytes, until the next call; there must be so many.
  /// \throws File_error the file cannot be read, or has become shorter
  const char* next(std::size_t size) {
    const char* const result = see(size);
    take(size);
    return result;
  }

  /// the next byte, which stays; -1 at the end
  int peek() { return m_bytes_left == 0 ? -1 : static_cast<unsigned char>(*see(1)); }
  /// takes bytes that `peek()` or `front()` have shown
  void take(std::size_t size = 1) {
    m_next += size;
    m_bytes_left -= size;
  }

  /// up to so many bytes, which stay, until the next call
  std::string_view front(std::size_t size) {
    const auto there = static_cast<std::size_t>((std::min)(std::uintmax_t(size), m_bytes_left));
    return {see(there), there};
  }

  /// there must be so many
  void skip(std::uintmax_t size) {
    CGAL_precondition(holds(1, size));
    while(size > 0) {
      const auto part = static_cast<std::size_t>((std::min)(size, std::uintmax_t(size_of_piece)));
      next(part);
      size -= part;
    }
  }

  /// says in which order the bytes of numbers are
  void set_little_endian(bool is_little) {
    const std::uint16_t one = 1;
    char first;
    std::memcpy(&first, &one, 1);
    m_is_swapped = is_little != (first == 1);
  }

  /// the number whose bytes begin at `from`
  template <class Number> Number number_at(const char* from) const {
    std::array<char, sizeof(Number)> bytes;
    std::copy_n(from, bytes.size(), bytes.begin());
    if(m_is_swapped)
      std::reverse(bytes.begin(), bytes.end());
    Number result;
    std::memcpy(&result, bytes.data(), sizeof(Number));
    return result;
  }

  /// \throws File_error with the position of the next byte
  [[noreturn]] void fail(const std::string& reason, File_place place = {}) const {
    place.byte = position();
    throw File_error(m_name, place, reason);
  }

private:
  static constexpr std::size_t size_of_piece = std::size_t(1) << 22;

  /// the next bytes; there must be so many
  const char* see(std::size_t size) {
    CGAL_precondition(holds(1, size));
    if(m_end - m_next < size)
      fill(size);
    return m_buffer.data() + m_next;
  }

  /// makes `size` bytes available
  void fill(std::size_t size) {
    std::copy(m_buffer.begin() + static_cast<std::ptrdiff_t>(m_next),
              m_buffer.begin() + static_cast<std::ptrdiff_t>(m_end), m_buffer.begin());
    m_end -= m_next;
    m_next = 0;
    // of the bytes that are left, `m_end` are in the buffer
    const auto wanted = static_cast<std::size_t>(
        (std::min)(m_bytes_left, std::uintmax_t((std::max)(size, size_of_piece))));
    if(m_buffer.size() < wanted)
      m_buffer.resize(wanted);
    if(!m_in.read(m_buffer.data() + m_end, static_cast<std::streamsize>(wanted - m_end)))
      fail("the file ended before its end, or cannot be read");
    m_end = wanted;
    m_progress(1 - static_cast<double>(m_bytes_left) / static_cast<double>(m_size));
  }

  std::string m_name;
  Progress m_progress;
  std::ifstream m_in;
  std::uintmax_t m_size = 0, m_bytes_left = 0;
  std::string m_buffer;
  std::size_t m_next = 0, m_end = 0; // in the buffer
  bool m_is_swapped = false;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_BYTE_SOURCE_H
