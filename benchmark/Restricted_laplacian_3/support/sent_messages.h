// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_BENCHMARK_SENT_MESSAGES_H
#define RESTRICTED_LAPLACIAN_3_BENCHMARK_SENT_MESSAGES_H

// Counts what this process sends: MPI calls the functions of this header in place of its own, for
// whatever library. To be included by one source file of a program.

#define OMPI_SKIP_MPICXX 1
#define MPICH_SKIP_MPICXX 1
#include <mpi.h>

#include <map>
#include <utility>

namespace benchmarks {

struct Sent_messages {
  double number = 0, bytes = 0;

  void add(int count, MPI_Datatype type) {
    int size = 0;
    PMPI_Type_size(type, &size);
    number += 1;
    bytes += static_cast<double>(count) * size;
  }
};

inline Sent_messages& sent_messages() {
  static Sent_messages sent;
  return sent;
}

// A persistent request sends whenever it is started.
inline std::map<MPI_Request, std::pair<int, MPI_Datatype>>& persistent_sends() {
  static std::map<MPI_Request, std::pair<int, MPI_Datatype>> requests;
  return requests;
}

inline void count_start(MPI_Request request) {
  const auto it = persistent_sends().find(request);
  if(it != persistent_sends().end())
    sent_messages().add(it->second.first, it->second.second);
}

} // namespace benchmarks

extern "C" {

int MPI_Isend(const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm,
              MPI_Request* request) {
  benchmarks::sent_messages().add(count, type);
  return PMPI_Isend(data, count, type, to, tag, comm, request);
}

int MPI_Send(const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm) {
  benchmarks::sent_messages().add(count, type);
  return PMPI_Send(data, count, type, to, tag, comm);
}

int MPI_Send_init(const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm,
                  MPI_Request* request) {
  const int result = PMPI_Send_init(data, count, type, to, tag, comm, request);
  benchmarks::persistent_sends()[*request] = {count, type};
  return result;
}

int MPI_Start(MPI_Request* request) {
  benchmarks::count_start(*request);
  return PMPI_Start(request);
}

int MPI_Startall(int number, MPI_Request requests[]) {
  for(int i = 0; i < number; ++i)
    benchmarks::count_start(requests[i]);
  return PMPI_Startall(number, requests);
}

} // extern "C"

#endif // RESTRICTED_LAPLACIAN_3_BENCHMARK_SENT_MESSAGES_H
