// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/atomic_file.h"
#include <cerrno>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>

namespace ballonet::studies
{
namespace
{

[[noreturn]] void fail(const std::filesystem::path &file)
{
  throw std::system_error(errno, std::generic_category(), "cannot write " + file.string());
}

void write_all(int descriptor, const std::string &text, const std::filesystem::path &file)
{
  std::size_t written = 0;
  while (written < text.size()) {
    const ssize_t n = write(descriptor, text.data() + written, text.size() - written);
    if (n < 0)
      fail(file);
    written += static_cast<std::size_t>(n);
  }
}

} // namespace

void write_atomically(const std::filesystem::path &file, const std::string &text)
{
  std::filesystem::path unfinished = file;
  unfinished += ".new";
  const int descriptor = open(unfinished.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (descriptor < 0)
    fail(unfinished);
  try {
    write_all(descriptor, text, unfinished);
  } catch (...) {
    close(descriptor);
    throw;
  }
  close(descriptor);
  move_into_place(unfinished, file);
}

void move_into_place(const std::filesystem::path &unfinished, const std::filesystem::path &file)
{
  const int descriptor = open(unfinished.c_str(), O_RDONLY);
  if (descriptor < 0)
    fail(unfinished);
  const bool synced = fsync(descriptor) == 0;
  const int error = errno;
  close(descriptor);
  errno = error;
  if (!synced)
    fail(unfinished);
  if (rename(unfinished.c_str(), file.c_str()) != 0)
    fail(file);
}

} // namespace ballonet::studies
