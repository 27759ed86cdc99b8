#include <cerrno>
#include <fstream>
#include <iterator>
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

// A text beside the file it is to become; gone again unless renamed.
class PartFile {
 public:
  explicit PartFile(const fs::path& path) : path_(path), part_(path) {
    // Its own name for each write, so that two programs do not write into each other's.
    part_.concat(".").concat(std::to_string(std::random_device()())).concat(".part");
  }
  ~PartFile() {
    std::error_code ignored;
    if (!part_.empty()) fs::remove(part_, ignored);
  }
  PartFile(PartFile&& other) noexcept
      : path_(std::move(other.path_)), part_(std::exchange(other.part_, {})) {}
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  PartFile& operator=(PartFile&&) = delete;

  std::optional<core::Error> write(std::string_view text) const {
    errno = 0;
    std::ofstream stream(part_, std::ios::binary | std::ios::trunc);
    stream << text;
    stream.close();  // flushes
    if (!stream) return unwritable(path_, errno != 0 ? errno : EIO);
    return std::nullopt;
  }

  std::optional<core::Error> rename() {
    std::error_code failure;
    fs::rename(part_, path_, failure);
    if (failure) return unwritable(path_, failure.value());
    part_.clear();
    return std::nullopt;
  }

 private:
  fs::path path_;
  fs::path part_;
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
  void keep() { made_.clear(); }

 private:
  fs::path folder_;
  std::vector<fs::path> made_;
};

}  // namespace

core::Expected<std::string> read_file(const fs::path& path) {
  std::error_code ignored;
  const auto status = fs::status(path, ignored);
  if (!fs::exists(status)) return core::Error{path.string(), "there is no such file"};
  if (fs::is_directory(status)) return core::Error{path.string(), "is a folder; a file is needed"};
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return core::Error{path.string(), "cannot be opened: " + reason(errno)};
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (stream.bad()) return core::Error{path.string(), "cannot be read"};
  return text;
}

std::optional<core::Error> write_file(const fs::path& path, std::string_view text) {
  PartFile file(path);
  if (auto error = file.write(text)) return error;
  return file.rename();
}

std::optional<core::Error> write_files(const fs::path& folder, std::span<const NamedText> files) {
  MadeFolder made(folder);
  if (auto error = made.make()) return error;
  std::vector<PartFile> parts;
  for (const NamedText& file : files) {
    // Found out before anything is renamed.
    std::error_code ignored;
    if (fs::is_directory(folder / file.name, ignored))
      return unwritable(folder / file.name, EISDIR);
    parts.emplace_back(folder / file.name);
    if (auto error = parts.back().write(file.text)) return error;
  }
  for (PartFile& part : parts)
    if (auto error = part.rename()) return error;
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
