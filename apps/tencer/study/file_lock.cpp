#include "file_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace tencer::app::study {
namespace {

core::Error problem(const std::filesystem::path& file) {
  return {file.string(), "cannot be locked: " + std::generic_category().message(errno)};
}

// Open for writing, for which network file systems ask; -1 where that is not possible.
int open_file(const std::filesystem::path& file) {
  return ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
}

}  // namespace

core::Expected<std::optional<FileLock>> FileLock::at_once(const std::filesystem::path& file) {
  FileLock lock(open_file(file));
  if (lock.descriptor_ >= 0 && ::flock(lock.descriptor_, LOCK_EX | LOCK_NB) == 0)
    return std::optional<FileLock>(std::move(lock));
  if (errno == EWOULDBLOCK) return std::optional<FileLock>();
  return problem(file);
}

core::Expected<FileLock> FileLock::in_turn(const std::filesystem::path& file) {
  FileLock lock(open_file(file));
  while (lock.descriptor_ >= 0) {
    if (::flock(lock.descriptor_, LOCK_EX) == 0) return core::Expected<FileLock>(std::move(lock));
    if (errno != EINTR) break;
  }
  return problem(file);
}

FileLock::FileLock(FileLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

FileLock::~FileLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace tencer::app::study
