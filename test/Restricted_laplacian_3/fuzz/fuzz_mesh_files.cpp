// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Reads any bytes as a file of a mesh: the readers answer with a mesh or a File_error, and take no
// more memory than a multiple of the bytes. For libFuzzer, see scripts/fuzz.sh. The suffix is in
// the environment, as FUZZED_SUFFIX.

#include <CGAL/Restricted_laplacian_3/files/read_mesh_file.h>

#include <sanitizer/allocator_interface.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

// memory that is there, and the most of it
std::size_t allocated = 0, most = 0;

void count(const volatile void*, std::size_t size) {
  allocated += size;
  if(allocated > most)
    most = allocated;
}

void discount(const volatile void* block) {
  if(block)
    allocated -= __sanitizer_get_allocated_size(const_cast<const void*>(block));
}

const bool is_counted = __sanitizer_install_malloc_and_free_hooks(count, discount) > 0;

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace RL = CGAL::Restricted_laplacian_3;
  static const char* const suffix = std::getenv("FUZZED_SUFFIX");
  if(!suffix || !is_counted)
    std::abort();
  const std::string file = std::string("fuzzed") + suffix;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t before = most = allocated;
  try {
    RL::internal::read_mesh_file(file, bytes);
  } catch(const RL::File_error&) {
  }
  try {
    RL::internal::read_vertex_properties(file, bytes);
  } catch(const RL::File_error&) {
  }
  // besides, a table of 1024 points, and the exact numbers by which a polygon of a few hundred
  // corners is divided
  constexpr std::size_t constant = 1 << 24;
  if(most - before > 20 * size + constant)
    std::abort();
  return 0;
}
