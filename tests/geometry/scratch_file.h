// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <filesystem>
#include <string>
#include <unistd.h>

namespace ballonet::geometry
{

/// A file name of this process in the system's folder for temporary files; removed at the end.
struct ScratchFile {
  explicit ScratchFile(const std::string &name)
      : path(std::filesystem::temp_directory_path() / ("ballonet_" + std::to_string(getpid()) + "_" + name))
  {
  }
  ~ScratchFile()
  {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
  }
  ScratchFile(const ScratchFile &) = delete;
  ScratchFile &operator=(const ScratchFile &) = delete;

  const std::filesystem::path path;
};

} // namespace ballonet::geometry
