// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_WRITE_IN_ORDER_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_WRITE_IN_ORDER_IMPL_H

#include <CGAL/Restricted_laplacian_3/distributed/write_in_order.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <ios>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void write_in_order(const Communicator& communicator,
                                                       const std::string& file,
                                                       const std::vector<std::string>& parts) {
  const bool is_first = communicator.rank() == 0;
  const auto fail = [&] { throw std::runtime_error("cannot write '" + file + "'"); };
  // 1 if the file can be replaced, 0 if it must be written as a stream
  int is_regular = 1;
  std::string target = file, part;
  communicator.agree([&] {
    std::error_code ignored;
    if(std::filesystem::is_symlink(target, ignored))
      target = std::filesystem::canonical(target, ignored).string();
    part = target + ".part";
    if(!is_first)
      return;
    const std::filesystem::file_status status = std::filesystem::status(target, ignored);
    is_regular = !std::filesystem::exists(status) || std::filesystem::is_regular_file(status);
    std::ofstream out(is_regular ? part : target, std::ios::binary);
    if(!out)
      throw std::runtime_error("cannot open '" + file + "' for writing");
    if(is_regular && std::filesystem::exists(status))
      std::filesystem::permissions(part, status.permissions(), ignored);
  });
  if(communicator.minimum(is_regular) == 0) {
    std::vector<std::string> texts;
    for(const std::string& of_rank : parts) {
      std::vector<std::vector<char>> lists(static_cast<std::size_t>(communicator.size()));
      lists.front().assign(of_rank.begin(), of_rank.end());
      texts.emplace_back();
      for(const std::vector<char>& list : communicator.exchange(lists))
        texts.back().append(list.begin(), list.end());
    }
    communicator.agree([&] {
      if(!is_first)
        return;
      std::ofstream out(target, std::ios::binary);
      for(const std::string& text : texts)
        out << text;
      out.close();
      if(!out)
        fail();
    });
    return;
  }
  try {
    std::uint64_t begin = 0;
    for(const std::string& of_rank : parts) {
      const std::vector<std::uint64_t> offsets = communicator.offsets(of_rank.size());
      communicator.agree([&] {
        if(of_rank.empty())
          return;
        std::ofstream out(part, std::ios::binary | std::ios::in | std::ios::out);
        out.seekp(static_cast<std::streamoff>(
            begin + offsets[static_cast<std::size_t>(communicator.rank())]));
        out.write(of_rank.data(), static_cast<std::streamsize>(of_rank.size()));
        out.close();
        if(!out)
          fail();
      });
      begin += offsets.back();
    }
    communicator.agree([&] {
      std::error_code error;
      if(is_first)
        std::filesystem::rename(part, target, error);
      if(error)
        fail();
    });
  } catch(...) {
    std::error_code ignored;
    if(is_first)
      std::filesystem::remove(part, ignored);
    throw;
  }
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_WRITE_IN_ORDER_IMPL_H
