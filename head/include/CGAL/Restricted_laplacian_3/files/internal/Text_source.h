// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_TEXT_SOURCE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_TEXT_SOURCE_H

#include <CGAL/Restricted_laplacian_3/files/internal/Byte_source.h>

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// the number that a word is, whatever the language of the machine; too large ones are infinite
inline std::optional<double> number_of(std::string_view word) {
  if(word.size() > 1 && word[0] == '+' && word[1] != '-')
    word.remove_prefix(1);
  double value = 0;
#ifdef __cpp_lib_to_chars
  const char* const end = word.data() + word.size();
  const auto [last, error] = std::from_chars(word.data(), end, value);
  if(word.empty() || last != end || error == std::errc::invalid_argument)
    return std::nullopt;
  if(error == std::errc::result_out_of_range) {
    const std::size_t exponent = word.find_first_of("eE");
    const bool is_small = exponent == std::string_view::npos
                              ? word.find_first_not_of("-0.") > word.find('.')
                              : word.find('-', exponent) != std::string_view::npos;
    value = is_small ? 0 : std::numeric_limits<double>::infinity();
    return word[0] == '-' ? -value : value;
  }
#else
  std::istringstream in{std::string(word)};
  in.imbue(std::locale::classic());
  if(!(in >> value) || in.peek() != std::istringstream::traits_type::eof())
    return std::nullopt;
#endif
  return value;
}

/// the integer that a word is
inline std::optional<std::int64_t> integer_of(std::string_view word) {
  if(word.size() > 1 && word[0] == '+' && word[1] != '-')
    word.remove_prefix(1);
  std::int64_t value = 0;
  const char* const end = word.data() + word.size();
  const auto [last, error] = std::from_chars(word.data(), end, value);
  return word.empty() || last != end || error != std::errc() ? std::nullopt : std::optional(value);
}

/// a word in small letters
inline std::string lower(std::string_view word) {
  std::string result(word);
  for(char& c : result)
    if(c >= 'A' && c <= 'Z')
      c = static_cast<char>(c - 'A' + 'a');
  return result;
}

/// Bytes as lines of words, between blanks. Lines end with a line feed, a carriage return, or both,
/// and a byte-order mark at the beginning is none of them.
class Text_source {
public:
  /// \param in what is read; between two calls others may read from it
  /// \param comment what begins a comment, at the beginning of a word
  /// \param continues whether a `\` at the end of a line joins it with the next one
  /// \throws File_error it is text in UTF-16
  explicit Text_source(Byte_source& in, char comment = '#', bool continues = false)
    : m_in(in), m_comment(comment), m_continues(continues) {
    if(m_in.front(3) == "\xEF\xBB\xBF")
      m_in.skip(3);
    if(m_in.front(2) == "\xFF\xFE" || m_in.front(2) == "\xFE\xFF")
      m_in.fail("is text in UTF-16, not in UTF-8");
  }

  /// the current line, counted from 1
  std::uintmax_t line() const { return m_line; }

  /// goes on to the next line with a word; \return whether there is one
  bool next_line() {
    for(bool is_first = !m_has_begun;; is_first = false) {
      m_has_begun = true;
      if(!is_first) {
        skip_line(m_continues);
        if(!end_line())
          return false;
      }
      if(skip_blanks())
        return true;
      if(m_in.peek() < 0)
        return false;
    }
  }

  /// the next word of this line, until the next call; \return whether there is one
  bool next_word(std::string_view& word) {
    m_has_begun = true;
    if(!skip_blanks())
      return false;
    m_word.clear();
    for(int c = m_in.peek(); c >= 0 && !is_blank(c) && !is_end(c); c = m_in.peek()) {
      if(c == 0)
        fail("is not text: byte " + std::to_string(m_in.position()) + " is 0");
      if(m_continues && c == '\\' && continues_here())
        break;
      if(m_word.size() == longest_word)
        fail("has a word of more than " + std::to_string(longest_word) + " letters");
      m_word += static_cast<char>(c);
      m_in.take();
    }
    word = m_word;
    return true;
  }

  /// the same, of this line or the next one that has words
  bool next_word_of_lines(std::string_view& word) {
    while(!next_word(word))
      if(!next_line())
        return false;
    return true;
  }

  /// \return whether this line has no more words
  bool is_at_end_of_line() { return !skip_blanks(); }

  /// the rest of the line as it is
  std::string rest_of_line() {
    std::string rest;
    m_has_begun = true;
    for(int c = m_in.peek(); c >= 0 && !is_end(c); c = m_in.peek()) {
      if(rest.size() == longest_word)
        fail("is longer than " + std::to_string(longest_word) + " letters");
      rest += static_cast<char>(c);
      m_in.take();
    }
    return rest;
  }

  /// Ends the line, as blank as it may be; \return whether there is another one.
  /// Behind it others may read.
  bool end_line() {
    const int c = m_in.peek();
    if(c < 0)
      return false;
    m_in.take();
    m_has_begun = false;
    if(c == '\r') {
      // where lines end with a carriage return alone, a line feed may be the first byte of a number
      if(m_in.peek() == '\n' && !m_has_bare_return)
        m_in.take();
      else
        m_has_bare_return = true;
    }
    ++m_line;
    return true;
  }

  /// The next word as a number.
  /// \param what it is, for the message
  double number(const char* what, const File_place& place = {}) {
    return parsed(number_of(word(what, place)), "number", what, place);
  }

  /// the next word as an integer
  std::int64_t integer(const char* what, const File_place& place = {}) {
    return parsed(integer_of(word(what, place)), "integer", what, place);
  }

  /// \throws File_error with the current line
  [[noreturn]] void fail(const std::string& reason, File_place place = {}) const {
    place.line = m_line;
    throw File_error(m_in.name(), place, reason);
  }

  Byte_source& bytes() { return m_in; }
  const Byte_source& bytes() const { return m_in; }

private:
  static constexpr std::size_t longest_word = 1 << 16;

  static bool is_blank(int c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  static bool is_end(int c) { return c == '\n' || c == '\r'; }

  /// whether the line ends behind a `\` that is next
  bool continues_here() {
    const std::string_view two = m_in.front(2);
    return two.size() == 2 && is_end(two[1]);
  }

  /// \return whether a word begins here
  bool skip_blanks() {
    for(;;) {
      const int c = m_in.peek();
      if(is_blank(c))
        m_in.take();
      else if(m_continues && c == '\\' && continues_here()) {
        m_in.take();
        end_line();
      } else if(c == m_comment && m_comment != 0) {
        skip_line(false);
        return false;
      } else
        return c >= 0 && !is_end(c);
    }
  }

  /// up to the end of the line
  void skip_line(bool continues) {
    for(int c = m_in.peek(); c >= 0 && !is_end(c); c = m_in.peek()) {
      const bool is_joined = continues && c == '\\' && continues_here();
      m_in.take();
      if(is_joined)
        end_line();
    }
  }

  std::string_view word(const char* what, const File_place& place) {
    std::string_view word;
    if(!next_word(word))
      fail(std::string("the line ends where ") + what + " is expected", place);
    return word;
  }

  template <class Number>
  Number parsed(const std::optional<Number>& number, const char* kind, const char* what,
                const File_place& place) const {
    if(number)
      return *number;
    const bool has_comma = m_word.find(',') != std::string::npos;
    fail("'" + m_word.substr(0, 40) + "' is no " + kind + ", which " + what + " has to be" +
             (has_comma ? " (decimal commas are not read)" : ""),
         place);
  }

  Byte_source& m_in;
  char m_comment;
  bool m_continues, m_has_bare_return = false;
  bool m_has_begun = false; // a part of the line is read
  std::uintmax_t m_line = 1;
  std::string m_word;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_TEXT_SOURCE_H
