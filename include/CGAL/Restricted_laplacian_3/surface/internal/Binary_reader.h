// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_INTERNAL_BINARY_READER_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_INTERNAL_BINARY_READER_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The bytes of a file, a piece of which is in memory.
class Binary_reader {
public:
  /// what is no file, for example a pipe, or cannot be opened, has no bytes
  Binary_reader(const std::string& file, const Progress& progress) : m_progress(progress) {
    std::error_code error;
    if(!std::filesystem::is_regular_file(file, error))
      return;
    m_size = m_bytes_left = std::filesystem::file_size(file, error);
    m_in.open(file, std::ios::binary);
    if(error || !m_in.good())
      m_size = m_bytes_left = 0;
  }

  /// whether there are so many times so many bytes more
  bool holds(std::size_t number, std::size_t size) const {
    return size == 0 || number <= m_bytes_left / size;
  }

  /// The next bytes, until the next call; there must be so many.
  /// \throws Input_error the file cannot be read, or has become shorter
  const char* next(std::size_t size) {
    CGAL_precondition(holds(1, size));
    if(m_end - m_next < size)
      fill(size);
    const char* const result = m_buffer.data() + m_next;
    m_next += size;
    m_bytes_left -= size;
    return result;
  }

  /// \return whether there is a line that ends, and is no longer than lines of headers are
  bool read_line(std::string& line) {
    constexpr std::size_t longest = 1 << 16;
    line.clear();
    while(holds(1, 1) && line.size() < longest) {
      const char c = *next(1);
      if(c == '\n')
        return true;
      line += c;
    }
    return false;
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

private:
  static constexpr std::size_t size_of_piece = std::size_t(1) << 22;

  /// makes `size` bytes available
  void fill(std::size_t size) {
    std::copy(m_buffer.begin() + static_cast<std::ptrdiff_t>(m_next),
              m_buffer.begin() + static_cast<std::ptrdiff_t>(m_end), m_buffer.begin());
    m_end -= m_next;
    m_next = 0;
    m_buffer.resize((std::max)(m_buffer.size(), (std::max)(size, size_of_piece)));
    const std::uintmax_t not_in_buffer = m_bytes_left - m_end;
    const auto more = static_cast<std::size_t>(
        (std::min)(not_in_buffer, std::uintmax_t(m_buffer.size() - m_end)));
    if(!m_in.read(m_buffer.data() + m_end, static_cast<std::streamsize>(more)))
      throw Input_error("the file ended before its end, or cannot be read");
    m_end += more;
    m_progress(1 - static_cast<double>(m_bytes_left) / static_cast<double>(m_size));
  }

  Progress m_progress;
  std::ifstream m_in;
  std::uintmax_t m_size = 0, m_bytes_left = 0;
  std::vector<char> m_buffer;
  std::size_t m_next = 0, m_end = 0; // in the buffer
  bool m_is_swapped = false;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_INTERNAL_BINARY_READER_H
