// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_BENCHMARK_DRIVER_H
#define RESTRICTED_LAPLACIAN_3_BENCHMARK_DRIVER_H

// What main() of a benchmark does: options, and errors.

#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <type_traits>

namespace benchmarks {

/// The options of a benchmark. Variables have their defaults before they are added.
class Command_line {
public:
  /// \param usage what `--help` prints before the options
  explicit Command_line(const std::string& usage);
  Command_line(const Command_line&) = delete;
  Command_line& operator=(const Command_line&) = delete;
  ~Command_line();

  /// \param value a `bool`, which is a switch, an `int`, `unsigned`, `std::size_t`, `double`,
  /// `std::string`, or a vector of them, which takes several arguments
  template <class Value>
  void add(const char* name, Value& value, const std::string& description = "");
  /// Arguments without a name are those of this option, at most so many, or all that are left.
  void add_positional(const char* name, int most = -1);

  /// \return `false` if all that was asked for was help, which is printed
  /// \throws std::exception if an argument is not understood
  bool read(int argc, char* argv[]);
  /// whether an option was given
  bool has(const char* name) const;
  /// \throws std::invalid_argument if it was not
  void require(const char* name) const;

private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

/// What `run()` returns, 0 if that is nothing; 1, with the message of the exception, if it throws.
template <class Run> int run_benchmark(const char* name, Run&& run) {
  try {
    if constexpr(std::is_void_v<decltype(run())>)
      run();
    else
      return run();
  } catch(const std::exception& e) {
    std::fprintf(stderr, "%s: %s\n", name, e.what());
    return 1;
  }
  return 0;
}

} // namespace benchmarks

#endif // RESTRICTED_LAPLACIAN_3_BENCHMARK_DRIVER_H
