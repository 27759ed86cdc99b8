// A file that one program at a time holds, also among machines that share a disk.
#pragma once

#include <filesystem>
#include <optional>
#include <tencer/core/error.hpp>

namespace tencer::app::study {

// Holds the file until it goes out of scope, or its program ends however it may, and so do the
// children that were given the descriptor. What is in the file does not matter.
class FileLock {
 public:
  // The file is made where it is not there. None while another holds it. Error: the path, and why
  // it cannot be locked.
  static core::Expected<std::optional<FileLock>> at_once(const std::filesystem::path& file);

  // Likewise, once no other holds it.
  static core::Expected<FileLock> in_turn(const std::filesystem::path& file);

  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&&) = delete;
  ~FileLock();

  int descriptor() const { return descriptor_; }

 private:
  explicit FileLock(int descriptor) : descriptor_(descriptor) {}

  int descriptor_;
};

}  // namespace tencer::app::study
