// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_BENCHMARK_MEASURE_H
#define RESTRICTED_LAPLACIAN_3_BENCHMARK_MEASURE_H

// What the comparisons share: the comment that says where their figures come from, medians, the
// true residual, and measuring in a process of its own.

#include "built_from.h"

#include <Eigen/Core>

#include <dlfcn.h>
#include <malloc.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <fstream>
#include <string>
#include <thread>
#include <type_traits>
#include <vector>

namespace benchmarks {

/// Prints commit, machine, compiler and command as comments.
inline void print_header(int argc, char* argv[]) {
  std::string cpu = "unknown processor", line;
  std::ifstream info("/proc/cpuinfo");
  while(std::getline(info, line))
    if(line.compare(0, 10, "model name") == 0) {
      cpu = line.substr(line.find(':') + 2);
      break;
    }
  std::printf("# commit: %s\n# machine: %s, %u cores\n", built_from_commit, cpu.c_str(),
              std::thread::hardware_concurrency());
  std::printf("# compiler: gcc %s, %s\n# command:", __VERSION__, built_with_flags);
  for(int i = 0; i < argc; ++i) {
    const std::string argument = argv[i];
    // of the program only the name
    std::printf(" %s", argument.substr(i == 0 ? argument.rfind('/') + 1 : 0).c_str());
  }
  std::printf("\n");
}

/// Whether `seconds_now()` counts the time of the processor, which other programs on the machine
/// hardly change, in place of that on the wall. Meant for one thread.
inline bool& counts_processor_time() {
  static bool is_set = false;
  return is_set;
}

inline double seconds_now() {
  timespec now = {};
  clock_gettime(counts_processor_time() ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// the middle one, or the mean of the two middle ones; NaN if there is none
inline double median(std::vector<double> values) {
  if(values.empty())
    return std::nan("");
  std::sort(values.begin(), values.end());
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

/// \f$ \|b - A x\|_2 / \|b\|_2 \f$, in double precision
template <class Matrix>
double true_residual(const Matrix& a, const Eigen::VectorXd& b, const Eigen::VectorXd& x) {
  const Eigen::VectorXd r = b - a * x;
  return r.norm() / b.norm();
}

/// A number of the file /proc/self/status in MiB: `VmRSS` is the memory in use, `VmHWM` the
/// largest since the process exists.
inline double memory_mib(const std::string& key) {
  std::ifstream status("/proc/self/status");
  std::string word;
  double kib = 0;
  while(status >> word)
    if(word == key + ":" && status >> kib)
      return kib / 1024;
  return 0;
}

/// Tells OpenBLAS, if the program is linked with it, how many threads to use.
inline void set_blas_threads(int threads) {
  using Function = void (*)(int);
  if(const auto set = reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads")))
    set(threads);
}

/// Calls `measure`, which returns a vector of records, in a child process: it starts without the
/// threads and the free lists of earlier measurements, and its peak memory is its own. No record
/// arrives if it fails or takes longer than `seconds`. A memory that the parent has in use already
/// does not count.
/// \param peak_mib receives what the child needed at most, beyond what it had at its start
template <class Record, class Measure>
std::vector<Record> in_child_process(unsigned seconds, double& peak_mib, Measure&& measure) {
  static_assert(std::is_trivially_copyable_v<Record>, "records travel through a pipe");
  std::fflush(nullptr);
  malloc_trim(0);
  int ends[2];
  if(pipe(ends) != 0)
    return {};
  const pid_t child = fork();
  if(child == 0) {
    close(ends[0]);
    alarm(seconds);
    int status = 1;
    try {
      const double before = memory_mib("VmRSS");
      const std::vector<Record> records = measure();
      const double peak = memory_mib("VmHWM") - before;
      const std::size_t size = records.size() * sizeof(Record);
      if(write(ends[1], &peak, sizeof peak) == ssize_t(sizeof peak) &&
         write(ends[1], records.data(), size) == ssize_t(size))
        status = 0;
    } catch(const std::exception& e) {
      std::fprintf(stderr, "%s\n", e.what());
    }
    std::fflush(nullptr);
    _exit(status);
  }
  close(ends[1]);
  std::vector<Record> records;
  Record record;
  if(read(ends[0], &peak_mib, sizeof peak_mib) == ssize_t(sizeof peak_mib))
    while(read(ends[0], &record, sizeof record) == ssize_t(sizeof record))
      records.push_back(record);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  return records;
}

} // namespace benchmarks

#endif // RESTRICTED_LAPLACIAN_3_BENCHMARK_MEASURE_H
