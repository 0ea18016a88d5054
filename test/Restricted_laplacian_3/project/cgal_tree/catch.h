// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_TEST_CATCH_H
#define RESTRICTED_LAPLACIAN_3_TEST_CATCH_H

/// \file
/// Takes the place of the header of this name in CGAL's tree, whose tests are programs without a
/// framework: those macros of Catch2 that our tests use, and a `main()`. Without arguments a
/// program runs all of its tests but those marked `[slow]`; an argument runs those whose names
/// contain it.
/// The exit status is 0 if no check failed. A test without a check fails, and so does a run without
/// a test.

#include <boost/preprocessor/cat.hpp>
#include <boost/preprocessor/punctuation/remove_parens.hpp>
#include <boost/preprocessor/seq/for_each.hpp>
#include <boost/preprocessor/stringize.hpp>
#include <boost/preprocessor/variadic/to_seq.hpp>

#include <cmath>
#include <exception>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace checks {

struct Test_case {
  std::string name;
  std::string tags;
  void (*function)();
};

inline std::vector<Test_case>& test_cases() {
  static std::vector<Test_case> all;
  return all;
}

inline bool register_test(const std::string& name, const std::string& tags, void (*function)()) {
  test_cases().push_back({name, tags, function});
  return true;
}

/// what `INFO` says of the scopes that the test is in
inline std::vector<std::string>& notes() {
  static std::vector<std::string> stack;
  return stack;
}

class Scoped_note {
public:
  explicit Scoped_note(std::string text) { notes().push_back(std::move(text)); }
  Scoped_note(const Scoped_note&) = delete;
  ~Scoped_note() { notes().pop_back(); }
};

/// of the test that runs
struct Counts {
  int checks = 0, failures = 0;
};
inline Counts& counts() {
  static Counts c;
  return c;
}

/// ends a test; no `std::exception`, because tests catch these
struct End_of_test {};

inline bool check(bool passed, const char* file, int line, const std::string& what) {
  ++counts().checks;
  if(!passed) {
    ++counts().failures;
    std::cerr << file << ":" << line << ": FAILED: " << what << "\n";
    for(const std::string& note : notes())
      std::cerr << "  " << note << "\n";
  }
  return passed;
}

inline void require(bool passed, const char* file, int line, const std::string& what) {
  if(!check(passed, file, line, what))
    throw End_of_test();
}

/// text that contains all of some texts
struct Contains_all {
  std::vector<std::string> texts;
  bool matches(const std::string& s) const {
    for(const std::string& text : texts)
      if(s.find(text) == std::string::npos)
        return false;
    return true;
  }
  friend Contains_all operator&&(Contains_all a, const Contains_all& b) {
    a.texts.insert(a.texts.end(), b.texts.begin(), b.texts.end());
    return a;
  }
};

inline bool matches(const std::string& s, const Contains_all& matcher) {
  return matcher.matches(s);
}
inline bool matches(const std::string& s, const std::string& expected) { return s == expected; }

} // namespace checks

namespace Catch {

inline checks::Contains_all Contains(const std::string& text) { return {{text}}; }

} // namespace Catch

/// A number that others equal up to `epsilon` times its absolute value, or up to `margin`; as in
/// Catch2, `epsilon` is 100 units in the last place of single precision by default.
class Approx {
public:
  template <class Number>
  explicit Approx(const Number& value) : m_value(static_cast<double>(value)) {}

  Approx& epsilon(double value) {
    m_epsilon = value;
    return *this;
  }
  Approx& margin(double value) {
    m_margin = value;
    return *this;
  }

  bool equals(double x) const {
    const auto within = [&](double bound) {
      return m_value + bound >= x && x + bound >= m_value; // infinite values too
    };
    return within(m_margin) || within(m_epsilon * (std::isinf(m_value) ? 0 : std::abs(m_value)));
  }
  template <class Number> friend bool operator==(const Number& x, const Approx& a) {
    return a.equals(static_cast<double>(x));
  }
  template <class Number> friend bool operator!=(const Number& x, const Approx& a) {
    return !(x == a);
  }
  template <class Number> friend bool operator<=(const Number& x, const Approx& a) {
    return static_cast<double>(x) < a.m_value || x == a;
  }
  template <class Number> friend bool operator>=(const Number& x, const Approx& a) {
    return static_cast<double>(x) > a.m_value || x == a;
  }

private:
  double m_value;
  double m_epsilon = 100. * static_cast<double>(std::numeric_limits<float>::epsilon());
  double m_margin = 0;
};

// clang-format off
#define CHECKS_NAME(PREFIX) BOOST_PP_CAT(PREFIX, __LINE__)

#define TEST_CASE(NAME, TAGS)                                                                      \
  static void CHECKS_NAME(test_case_)();                                                           \
  static const bool CHECKS_NAME(is_registered_) =                                                  \
      checks::register_test(NAME, TAGS, CHECKS_NAME(test_case_));                                  \
  static void CHECKS_NAME(test_case_)()

#define CHECKS_REGISTER_TYPE(R, DATA, TYPE)                                                        \
  checks::register_test(std::string(CHECKS_NAME(name_)) + " - " + BOOST_PP_STRINGIZE(TYPE),        \
                        CHECKS_NAME(tags_),                                                        \
                        CHECKS_NAME(test_case_)<BOOST_PP_REMOVE_PARENS(TYPE)>) &&

/// types that contain commas stand in parentheses
#define TEMPLATE_TEST_CASE(NAME, TAGS, ...)                                                        \
  template <class TestType> static void CHECKS_NAME(test_case_)();                                 \
  static const char* const CHECKS_NAME(name_) = NAME;                                              \
  static const char* const CHECKS_NAME(tags_) = TAGS;                                              \
  static const bool CHECKS_NAME(is_registered_) =                                                  \
      BOOST_PP_SEQ_FOR_EACH(CHECKS_REGISTER_TYPE, , BOOST_PP_VARIADIC_TO_SEQ(__VA_ARGS__)) true;   \
  template <class TestType> static void CHECKS_NAME(test_case_)()
// clang-format on

#define CHECK(...) checks::check(static_cast<bool>(__VA_ARGS__), __FILE__, __LINE__, #__VA_ARGS__)
#define CHECK_FALSE(...)                                                                           \
  checks::check(!static_cast<bool>(__VA_ARGS__), __FILE__, __LINE__, "not " #__VA_ARGS__)
#define REQUIRE(...)                                                                               \
  checks::require(static_cast<bool>(__VA_ARGS__), __FILE__, __LINE__, #__VA_ARGS__)
#define REQUIRE_FALSE(...)                                                                         \
  checks::require(!static_cast<bool>(__VA_ARGS__), __FILE__, __LINE__, "not " #__VA_ARGS__)

// An exception ends the test and is reported there.
#define CHECK_NOTHROW(...)                                                                         \
  do {                                                                                             \
    static_cast<void>(__VA_ARGS__);                                                                \
    CHECK(true);                                                                                   \
  } while(false)
#define REQUIRE_NOTHROW(...) CHECK_NOTHROW(__VA_ARGS__)

#define CHECK_THROWS_AS(EXPRESSION, TYPE)                                                          \
  do {                                                                                             \
    bool has_thrown = false;                                                                       \
    try {                                                                                          \
      static_cast<void>(EXPRESSION);                                                               \
    } catch(const TYPE&) {                                                                         \
      has_thrown = true;                                                                           \
    }                                                                                              \
    checks::check(has_thrown, __FILE__, __LINE__, #EXPRESSION " throws " #TYPE);                   \
  } while(false)

#define CHECK_THROWS_WITH(EXPRESSION, MATCHER)                                                     \
  do {                                                                                             \
    std::string message = "no exception";                                                          \
    bool is_expected = false;                                                                      \
    try {                                                                                          \
      static_cast<void>(EXPRESSION);                                                               \
    } catch(const std::exception& e) {                                                             \
      message = e.what();                                                                          \
      is_expected = checks::matches(message, MATCHER);                                             \
    }                                                                                              \
    checks::check(is_expected, __FILE__, __LINE__,                                                 \
                  #EXPRESSION " throws with " #MATCHER ": " + message);                            \
  } while(false)

#define CHECK_THAT(TEXT, MATCHER)                                                                  \
  do {                                                                                             \
    const std::string text = TEXT;                                                                 \
    checks::check(checks::matches(text, MATCHER), __FILE__, __LINE__, #MATCHER ": " + text);       \
  } while(false)

#define CHECKS_TEXT(MESSAGE)                                                                       \
  static_cast<std::ostringstream&&>(std::ostringstream() << MESSAGE).str()
#define INFO(MESSAGE) const checks::Scoped_note CHECKS_NAME(note_)(CHECKS_TEXT(MESSAGE))
#define WARN(MESSAGE) std::cerr << CHECKS_TEXT(MESSAGE) << "\n"
#define SUCCEED(MESSAGE) CHECK(true)
#define FAIL(MESSAGE) checks::require(false, __FILE__, __LINE__, CHECKS_TEXT(MESSAGE))

/// leaves a test that cannot run here
#define SKIP_TEST(REASON)                                                                          \
  do {                                                                                             \
    WARN("SKIPPED: " << REASON);                                                                   \
    SUCCEED();                                                                                     \
    return;                                                                                        \
  } while(false)

namespace checks {

/// returns whether it passed
inline bool run(const Test_case& test) {
  counts() = Counts();
  std::string ending;
  try {
    test.function();
  } catch(const End_of_test&) {
  } catch(const std::exception& e) {
    ending = e.what();
  } catch(...) {
    ending = "an exception of unknown type";
  }
  const Counts& result = counts();
  if(!ending.empty())
    std::cerr << "the test was ended by: " << ending << "\n";
  else if(result.checks == 0)
    std::cerr << "the test checks nothing\n";
  const bool has_passed = ending.empty() && result.checks > 0 && result.failures == 0;
  std::cout << (has_passed ? "passed" : "FAILED") << " " << test.name << ", " << result.checks
            << " checks" << std::endl;
  return has_passed;
}

} // namespace checks

int main(int argc, char* argv[]) {
  const auto is_chosen = [&](const checks::Test_case& test) {
    for(int i = 1; i < argc; ++i)
      if(test.name.find(argv[i]) != std::string::npos)
        return true;
    return argc == 1 && test.tags.find("[slow]") == std::string::npos;
  };
  int number_of_tests = 0, number_of_failures = 0;
  for(const checks::Test_case& test : checks::test_cases())
    if(is_chosen(test)) {
      ++number_of_tests;
      number_of_failures += !checks::run(test);
    }
  std::cout << number_of_tests << " tests, " << number_of_failures << " failed" << std::endl;
  return number_of_tests > 0 && number_of_failures == 0 ? 0 : 1;
}

#endif // RESTRICTED_LAPLACIAN_3_TEST_CATCH_H
