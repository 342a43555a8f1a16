// SPDX-License-Identifier: LGPL-2.1-or-later
#include "optimize/line_file.h"
#include <cerrno>
#include <fcntl.h>
#include <stdexcept>
#include <system_error>
#include <unistd.h>

namespace ballonet::optimize
{

namespace
{
[[noreturn]] void fail(const std::filesystem::path &path, const std::string &what)
{
  throw std::system_error(errno, std::generic_category(), path.string() + ": " + what);
}

/// Makes the name of a new file durable, which a sync of the file alone does not.
void sync_folder_of(const std::filesystem::path &path)
{
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0)
    fail(folder, "cannot be opened");
  ::fsync(descriptor); // some file systems refuse this for folders and need no such call
  ::close(descriptor);
}

std::string content_of(int descriptor, const std::filesystem::path &path)
{
  std::string content;
  char buffer[1 << 16];
  for (;;) {
    const ssize_t n = ::read(descriptor, buffer, sizeof buffer);
    if (n == 0)
      return content;
    if (n > 0)
      content.append(buffer, static_cast<std::size_t>(n));
    else if (errno != EINTR)
      fail(path, "cannot be read");
  }
}
} // namespace

LineFile::LineFile(const std::filesystem::path &path) : path_(path)
{
  descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0)
    fail(path_, "cannot be opened for writing");
  try {
    lock();
    read();
    sync_folder_of(path_);
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

LineFile::~LineFile() { ::close(descriptor_); }

void LineFile::lock() const
{
  struct flock whole_file = {};
  whole_file.l_type = F_WRLCK;
  whole_file.l_whence = SEEK_SET;
  if (::fcntl(descriptor_, F_SETLK, &whole_file) == 0)
    return;
  if (errno == EACCES || errno == EAGAIN)
    fail(path_, "is being written by another process");
  if (errno != ENOLCK && errno != ENOSYS && errno != EINVAL) // a file system without locks is accepted
    fail(path_, "cannot be locked");
}

void LineFile::read()
{
  const std::string content = content_of(descriptor_, path_);
  for (std::size_t end; (end = content.find('\n', size_)) != std::string::npos; size_ = end + 1)
    lines_.push_back(content.substr(size_, end - size_));
  torn_bytes_ = content.size() - size_;
  if (torn_bytes_ > 0 && ::ftruncate(descriptor_, static_cast<off_t>(size_)) != 0)
    fail(path_, "the torn last line cannot be cut off");
}

void LineFile::append(std::string_view line)
{
  if (line.find('\n') != std::string_view::npos)
    throw std::invalid_argument(path_.string() + ": a line with a line break in it");
  std::string text(line);
  text += '\n';
  try {
    write_at_end(text);
  } catch (...) {
    if (::ftruncate(descriptor_, static_cast<off_t>(size_)) != 0)
      std::throw_with_nested(std::runtime_error(path_.string() + ": a torn line cannot be cut off"));
    throw;
  }
  size_ += text.size();
}

void LineFile::write_at_end(std::string_view text)
{
  while (!text.empty()) {
    const ssize_t n = ::write(descriptor_, text.data(), text.size());
    if (n >= 0)
      text.remove_prefix(static_cast<std::size_t>(n));
    else if (errno != EINTR)
      fail(path_, "cannot be written");
  }
  if (::fdatasync(descriptor_) != 0)
    fail(path_, "cannot be synced to disk");
}

} // namespace ballonet::optimize
