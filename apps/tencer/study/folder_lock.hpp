// One study at a time in a folder: two would write each other's rows away.
#pragma once

#include <filesystem>
#include <optional>
#include <tencer/core/error.hpp>

namespace tencer::app::study {

// Holds the folder until it goes out of scope, or its program ends however it may.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  // Why the folder is not held.
  const std::optional<core::Error>& problem() const { return problem_; }

 private:
  int descriptor_ = -1;
  std::optional<core::Error> problem_{};
};

}  // namespace tencer::app::study
