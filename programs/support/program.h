// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PROGRAMS_PROGRAM_H
#define RESTRICTED_LAPLACIAN_3_PROGRAMS_PROGRAM_H

// What every program shares: how it fails, how it writes
// files, and how it shows that it is alive.

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>

#include <CGAL/Real_timer.h>
#include <CGAL/assertions_behaviour.h>

#if defined(__linux__) && __has_include(<malloc.h>)
#include <malloc.h>
#endif

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <initializer_list>
#include <iomanip>
#include <iostream>
#include <limits>
#include <memory>
#include <new>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace programs {

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

// What the options say of a run: whether it prints errors only; which files it writes, each with
// the option that names it; whether one that is read may be among them, by an option that the
// program has; and all options.
struct Run {
  bool is_quiet = false, has_overwrite = false, may_overwrite_input = false;
  std::vector<std::pair<std::string, std::string>> outputs;
  std::set<std::string> options; // names of those that the program has
};
inline Run& this_run() {
  static Run run;
  return run;
}

// Throws if a file that is read is one that will be written: to be called before reading.
inline void check_input(const std::string& file) {
  std::error_code ignored;
  if(this_run().may_overwrite_input || !std::filesystem::is_regular_file(file, ignored))
    return;
  for(const auto& [argument, output] : this_run().outputs)
    require(!std::filesystem::equivalent(file, output, ignored),
            "'" + file + "' is read, and " + argument + " would replace it: give another name" +
                (this_run().has_overwrite ? ", or --overwrite" : ""));
}

// prints one line on the standard error stream
inline void print_error(const std::string& program, std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::cerr << program << ": " << message << std::endl;
}

// What an error in a parameter of the library says to users of a program: they know an option of
// the same name.
inline std::string message_of(const RL::Parameter_error& e) {
  std::string option = e.parameter();
  std::replace(option.begin(), option.end(), '_', '-');
  const std::string message = e.what();
  return this_run().options.count(option) == 0
             ? message
             : "--" + option + message.substr(e.parameter().size());
}

// Lets the heap grow in large steps, and keep what it has. By default the C library of Linux gives
// each large array back to the system when it is no longer used, and the pages of the next one are
// filled with zeros again when they are first touched.
inline void keep_memory() {
#ifdef M_TOP_PAD
  constexpr int step = 64 << 20;
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
  mallopt(M_TOP_PAD, step);
#endif
}

// Runs the body of a program, a functor that returns the exit status. Whatever the body throws
// becomes one line on the standard error stream and a non-zero exit status.
template <typename Body> int run_program(const std::string& program, Body body) {
  keep_memory();
  // CGAL prints several lines when a check fails, before it throws; the exception says it all
  const auto silent = [](const char*, const char*, const char*, int, const char*) {};
  CGAL::set_error_handler(silent);
  CGAL::set_warning_handler(silent);
  try {
    const int status = body();
    require(static_cast<bool>(std::cout.flush()), "cannot write to the standard output stream");
    return status;
  } catch(const RL::Out_of_memory& e) {
    print_error(program, e.what());
  } catch(const std::bad_alloc&) {
    print_error(program, "not enough memory");
  } catch(const RL::Parameter_error& e) {
    print_error(program, message_of(e));
  } catch(const std::exception& e) {
    print_error(program, e.what());
  }
  return failure;
}

namespace internal {

// The stream in which a file is written: beside it, under another name, until it is whole. So
// whoever finds the file finds all of it, also if the program is killed or the disk is full. What
// is no regular file, a pipe or a device, is written to itself, and so is a file in a folder where
// no other can be made.
class Whole_file {
public:
  explicit Whole_file(const std::string& file) : m_file(file) {
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(file, ignored);
    const bool is_new = !std::filesystem::exists(status);
    if(std::filesystem::is_regular_file(status) && std::filesystem::is_symlink(file, ignored))
      m_file = std::filesystem::canonical(file, ignored).string();
    if(is_new || std::filesystem::is_regular_file(status)) {
      m_part = m_file + ".part";
      m_out.open(m_part, std::ios::binary);
      if(m_out.is_open() && !is_new)
        std::filesystem::permissions(m_part, status.permissions(), ignored);
    }
    if(!m_out.is_open()) {
      m_part.clear();
      m_out.open(m_file, std::ios::binary);
    }
    m_is_open = m_out.is_open();
  }
  // nothing is left of what is not whole
  ~Whole_file() {
    std::error_code ignored;
    m_out.close();
    if(!m_part.empty())
      std::filesystem::remove(m_part, ignored);
    else if(m_is_open && !m_is_whole && std::filesystem::is_regular_file(m_file, ignored))
      std::filesystem::remove(m_file, ignored);
  }
  Whole_file(const Whole_file&) = delete;
  Whole_file& operator=(const Whole_file&) = delete;

  std::ofstream& stream() { return m_out; }

  // says that all is written; returns whether it arrived
  bool finish() {
    m_out.close();
    m_is_whole = m_out.good();
    if(m_is_whole && !m_part.empty()) {
      std::error_code error;
      std::filesystem::rename(m_part, m_file, error);
      m_is_whole = !error;
    }
    return m_is_whole;
  }

private:
  std::string m_file, m_part;
  std::ofstream m_out;
  bool m_is_open = false, m_is_whole = false;
};

} // namespace internal

// whether a name stands for the stream that the program prints on
inline bool is_standard_output(const std::string& file) {
  return file == "/dev/stdout" || file == "/dev/fd/1" || file == "/proc/self/fd/1";
}

// Lets `write` fill a file, and throws unless everything arrived there; then the file is what it
// was before. Numbers are written so that reading them gives the same number again.
inline void write_file(const std::string& file, const std::function<void(std::ostream&)>& write) {
  if(is_standard_output(file)) { // opened once more, it would begin at its beginning
    std::ostream out(std::cout.rdbuf());
    out << std::setprecision(std::numeric_limits<double>::max_digits10);
    write(out);
    require(static_cast<bool>(out.flush()), "cannot write '" + file + "'");
    return;
  }
  internal::Whole_file whole(file);
  require(whole.stream().good(), "cannot open '" + file + "' for writing");
  whole.stream() << std::setprecision(std::numeric_limits<double>::max_digits10);
  write(whole.stream());
  require(whole.finish(), "cannot write '" + file + "'");
}

// the end of the name of a file, in small letters
inline std::string extension(const std::string& file) {
  std::string result = std::filesystem::path(file).extension().string();
  for(char& c : result)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

// Throws unless a file can be written, and has one of some formats, any if there are none: before
// the work, of which nothing could be written. What is in the file stays.
// \param argument the option or argument that names it, for the message
inline void check_output(const std::string& argument, const std::string& file,
                         std::initializer_list<const char*> formats = {}) {
  if(file.empty())
    return;
  const std::string of_argument = "'" + file + "' of " + argument;
  std::string list;
  bool is_known = formats.size() == 0;
  for(const char* format : formats) {
    is_known = is_known || extension(file) == format;
    list += (list.empty() ? "" : " or ") + std::string(format);
  }
  if(is_standard_output(file)) {
    for(const auto& [other, output] : this_run().outputs)
      require(!is_standard_output(output), argument + " and " + other + " name the same file");
    this_run().is_quiet = true; // nothing else may be there
    this_run().outputs.emplace_back(argument, file);
    return;
  }
  require(is_known, of_argument + " has no format that can be written: " + list);
  this_run().outputs.emplace_back(argument, file);
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(file, ignored);
  const bool is_new = !std::filesystem::exists(status);
  // pipes and devices would notice
  if(!is_new && !std::filesystem::is_regular_file(status) && !std::filesystem::is_directory(status))
    return;
  const bool is_open = std::ofstream(file, std::ios::binary | std::ios::app).good();
  if(is_new)
    std::filesystem::remove(file, ignored);
  require(is_open, "cannot open " + of_argument + " for writing");
}

// Shows on the standard error stream which step a program is busy with, how much of it is done, and
// how many seconds are left: in one line that changes, if that stream is a terminal.
class Progress {
public:
  // \param is_asked_for also if it is no terminal: then in lines, one for every tenth of a step
  Progress(bool is_quiet, bool is_asked_for)
    : m_is_terminal(is_terminal()), m_is_shown(!is_quiet && (m_is_terminal || is_asked_for)) {}
  ~Progress() { show(""); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // replaces the line of the last step; an empty text removes it
  void show(const std::string& text) const {
    if(m_is_shown && m_is_terminal)
      std::cerr << "\r\033[K" << text << std::flush;
    else if(m_is_shown && !text.empty())
      std::cerr << text << std::endl;
  }

  // A callback for functions of the library: shows which part of a step is done.
  std::function<bool(double)> step(const std::string& name) const {
    show(name);
    const auto timer = std::make_shared<CGAL::Real_timer>();
    timer->start();
    return [this, name, timer, shown = 0](double part) mutable {
      const int done = static_cast<int>(100 * part) / (m_is_terminal ? 1 : 10);
      if(m_is_shown && done > shown) {
        std::ostringstream text;
        text << name << ": " << static_cast<int>(100 * part) << " %, "
             << std::ceil(timer->time() * (1 - part) / part) << " s left";
        show(text.str());
        shown = done;
      }
      return true;
    };
  }

private:
  // C++ does not tell. On Unix the stream has a name, and what has characters is a terminal.
  static bool is_terminal() {
    std::error_code ignored;
    return std::filesystem::is_character_file("/dev/stderr", ignored);
  }

  bool m_is_terminal, m_is_shown;
};

} // namespace programs

#endif // RESTRICTED_LAPLACIAN_3_PROGRAMS_PROGRAM_H
