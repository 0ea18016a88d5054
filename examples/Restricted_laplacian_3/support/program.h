// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_EXAMPLES_PROGRAM_H
#define RESTRICTED_LAPLACIAN_3_EXAMPLES_PROGRAM_H

// What every example program shares: how it fails, how it writes
// files, and how it shows that it is alive.

#include <CGAL/assertions_behaviour.h>

#include <unistd.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

namespace CGAL::Restricted_laplacian_3 {} // namespace CGAL::Restricted_laplacian_3

namespace examples {

namespace RL = CGAL::Restricted_laplacian_3;

// The exit status of a program.
enum Exit_status { success = 0, failure = 1, not_converged = 2 };

// An error in what the user gave: the message says what is wrong, on one line.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// throws an `Error` unless `condition` holds
inline void require(bool condition, const std::string& message) {
  if(!condition)
    throw Error(message);
}

// prints one line on the standard error stream
inline void print_error(const std::string& program, std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::cerr << program << ": " << message << std::endl;
}

// Runs the body of a program, a functor that returns the exit status. Whatever the body throws
// becomes one line on the standard error stream and a non-zero exit status.
template <typename Body> int run_program(const std::string& program, Body body) {
  // CGAL prints several lines when a check fails, before it throws; the exception says it all
  const auto silent = [](const char*, const char*, const char*, int, const char*) {};
  CGAL::set_error_handler(silent);
  CGAL::set_warning_handler(silent);
  try {
    const int status = body();
    require(static_cast<bool>(std::cout.flush()), "cannot write to the standard output stream");
    return status;
  } catch(const std::bad_alloc&) {
    print_error(program, "not enough memory");
  } catch(const std::exception& e) {
    print_error(program, e.what());
  }
  return failure;
}

// Opens `file`, lets `write` fill it, and throws unless everything arrived there; then no part of
// the file is left. Numbers are written so that reading them gives the same number again.
inline void write_file(const std::string& file, const std::function<void(std::ostream&)>& write) {
  std::ofstream out(file, std::ios::binary);
  require(out.good(), "cannot open '" + file + "' for writing");
  out << std::setprecision(std::numeric_limits<double>::max_digits10);
  write(out);
  out.close();
  std::error_code ignored;
  if(!out.good() && std::filesystem::is_regular_file(file, ignored))
    std::filesystem::remove(file, ignored);
  require(out.good(), "cannot write '" + file + "'");
}

// Shows on the standard error stream which step a program is busy with, if that is a terminal.
class Progress {
public:
  explicit Progress(bool quiet) : m_is_shown(!quiet && isatty(STDERR_FILENO)) {}
  ~Progress() { show(""); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // replaces the line of the last step; an empty text removes it
  void show(const std::string& step) const {
    if(m_is_shown)
      std::cerr << "\r\033[K" << step << std::flush;
  }

private:
  bool m_is_shown;
};

} // namespace examples

#endif // RESTRICTED_LAPLACIAN_3_EXAMPLES_PROGRAM_H
