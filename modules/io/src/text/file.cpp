#include <cerrno>
#include <fstream>
#include <iostream>
#include <random>
#include <system_error>
#include <tencer/io/file.hpp>
#include <utility>
#include <vector>

namespace tencer::io {
namespace {

namespace fs = std::filesystem;

std::string reason(int error) { return std::generic_category().message(error); }

core::Error unwritable(const fs::path& path, int error) {
  return {path.string(), "cannot be written: " + reason(error)};
}

// Up to the largest size.
core::Expected<std::string> read_all(std::istream& stream, const std::string& name) {
  std::string text;
  std::string block(1 << 16, '\0');
  while (stream.read(block.data(), static_cast<std::streamsize>(block.size())),
         stream.gcount() > 0) {
    text.append(block, 0, static_cast<std::size_t>(stream.gcount()));
    if (text.size() > largest_file)
      return core::Error{name, "is larger than " + std::to_string(largest_file >> 20) +
                                   " MB; no curve or design needs so many bytes"};
  }
  if (stream.bad()) return core::Error{name, "cannot be read"};
  return text;
}

// Beside `path`; its own name for each write, so that two programs do not write into each other's.
fs::path beside(fs::path path, const char* ending) {
  return path.concat(".").concat(std::to_string(std::random_device()())).concat(ending);
}
fs::path part_of(const fs::path& path) { return beside(path, ".part"); }

// Into `file`; an error names `path`, which it is to become.
std::optional<core::Error> write_text(const fs::path& file, const fs::path& path,
                                      std::string_view text) {
  errno = 0;
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  stream << text;
  stream.close();  // flushes
  if (!stream) return unwritable(path, errno != 0 ? errno : EIO);
  return std::nullopt;
}

// A text beside the file it is to become. Unless it is kept, all is then as it was.
class PartFile {
 public:
  explicit PartFile(const fs::path& path) : path_(path), part_(part_of(path)) {}
  ~PartFile() {
    if (kept_) return;
    std::error_code ignored;
    if (!part_.empty())
      fs::remove(part_, ignored);
    else if (old_.empty())
      fs::remove(path_, ignored);
    if (!old_.empty()) fs::rename(old_, path_, ignored);
  }
  PartFile(PartFile&& other) noexcept
      : path_(std::move(other.path_)),
        part_(std::move(other.part_)),
        old_(std::move(other.old_)),
        kept_(std::exchange(other.kept_, true)) {}
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  PartFile& operator=(PartFile&&) = delete;

  std::optional<core::Error> write(std::string_view text) const {
    return write_text(part_, path_, text);
  }

  // The old file, if there is one, gets another name; or a copy has it.
  std::optional<core::Error> set_aside(bool copy) {
    std::error_code failure, ignored;
    if (!fs::exists(path_, ignored)) return std::nullopt;
    fs::path old = beside(path_, ".old");
    if (copy)
      fs::copy_file(path_, old, failure);
    else
      fs::rename(path_, old, failure);
    if (failure) {
      fs::remove(old, ignored);
      return unwritable(path_, failure.value());
    }
    old_ = std::move(old);
    return std::nullopt;
  }

  std::optional<core::Error> rename() {
    std::error_code failure;
    fs::rename(part_, path_, failure);
    if (failure) return unwritable(path_, failure.value());
    part_.clear();
    return std::nullopt;
  }

  void keep() {
    kept_ = true;
    std::error_code ignored;
    if (!old_.empty()) fs::remove(old_, ignored);
  }

 private:
  fs::path path_;
  fs::path part_;
  fs::path old_;
  bool kept_ = false;
};

// A folder that is made if need be, with those above it; what was made is gone again unless kept.
class MadeFolder {
 public:
  explicit MadeFolder(const fs::path& folder) : folder_(folder) {}
  ~MadeFolder() {
    std::error_code ignored;
    for (auto made = made_.rbegin(); made != made_.rend(); ++made) fs::remove(*made, ignored);
  }
  MadeFolder(const MadeFolder&) = delete;
  MadeFolder& operator=(const MadeFolder&) = delete;

  std::optional<core::Error> make() {
    std::error_code failure;
    fs::path part;
    for (const fs::path& name : folder_) {
      part /= name;
      if (fs::create_directory(part, failure)) made_.push_back(part);
      std::error_code ignored;
      const auto found = fs::status(part, ignored);
      if (fs::exists(found) && !fs::is_directory(found))
        return core::Error{folder_.string(),
                           "cannot be made a folder: " + part.string() + " is a file"};
      if (failure)
        return core::Error{folder_.string(), "cannot be made a folder: " + failure.message()};
    }
    return std::nullopt;
  }
  // Removed with the folder; an error names the file in `later`.
  std::optional<core::Error> write(const NamedText& file, const fs::path& later) {
    made_.push_back(folder_ / file.name);
    return write_text(made_.back(), later / file.name, file.text);
  }
  const fs::path& path() const { return folder_; }
  void keep() { made_.clear(); }

 private:
  fs::path folder_;
  std::vector<fs::path> made_;
};

// The files in a folder that is not there yet: made under another name, which is gone again unless
// all of them could be written.
std::optional<core::Error> write_new_folder(const fs::path& folder,
                                            std::span<const NamedText> files) {
  MadeFolder above(folder.parent_path());
  MadeFolder staged(part_of(folder));
  for (MadeFolder* needed : {&above, &staged})
    if (auto error = needed->make()) return core::Error{folder.string(), error->message};
  for (const NamedText& file : files)
    if (auto error = staged.write(file, folder)) return error;
  std::error_code failure;
  fs::rename(staged.path(), folder, failure);
  if (failure) return unwritable(folder, failure.value());
  staged.keep();
  above.keep();
  return std::nullopt;
}

}  // namespace

core::Expected<std::string> read_file(const fs::path& path) {
  if (path == "-") return read_all(std::cin, "standard input");
  std::error_code ignored;
  const auto status = fs::status(path, ignored);
  if (!fs::exists(status)) return core::Error{path.string(), "there is no such file"};
  if (fs::is_directory(status)) return core::Error{path.string(), "is a folder; a file is needed"};
  if (!fs::is_regular_file(status) && !fs::is_fifo(status))
    return core::Error{path.string(), "is a device; a file is needed"};
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return core::Error{path.string(), "cannot be opened: " + reason(errno)};
  return read_all(stream, path.string());
}

std::optional<core::Error> write_file(const fs::path& path, std::string_view text) {
  // A device or pipe is written to, never replaced.
  std::error_code ignored;
  const auto there = fs::status(path, ignored);
  if (fs::exists(there) && !fs::is_regular_file(there) && !fs::is_directory(there))
    return write_text(path, path, text);
  PartFile file(path);
  if (auto error = file.write(text)) return error;
  if (auto error = file.rename()) return error;
  file.keep();
  return std::nullopt;
}

std::optional<core::Error> write_files(const fs::path& folder, std::span<const NamedText> files) {
  std::error_code ignored;
  if (!fs::exists(folder, ignored)) return write_new_folder((folder / "").parent_path(), files);
  MadeFolder made(folder);
  if (auto error = made.make()) return error;
  std::vector<PartFile> parts;
  for (const NamedText& file : files) {
    // Found out before anything is renamed.
    if (fs::is_directory(folder / file.name, ignored))
      return unwritable(folder / file.name, EISDIR);
    parts.emplace_back(folder / file.name);
    if (auto error = parts.back().write(file.text)) return error;
  }
  // The first file is the old or the new one at any moment, and the others that are there are of
  // the same kind: no new one comes before the first, no old one is left by then.
  for (PartFile& part : parts)
    if (auto error = part.set_aside(&part == &parts.front())) return error;
  for (PartFile& part : parts)
    if (auto error = part.rename()) return error;
  for (PartFile& part : parts) part.keep();
  made.keep();
  return std::nullopt;
}

std::optional<core::Error> folder_problem(const fs::path& folder) {
  MadeFolder made(folder);
  if (auto error = made.make()) return error;
  if (auto error = PartFile(folder / "trial").write(""))
    return core::Error{folder.string(), error->message};
  return std::nullopt;
}

}  // namespace tencer::io
