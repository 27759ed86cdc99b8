#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <system_error>
#include <tencer/io/file.hpp>

namespace tencer::io {
namespace {

std::string reason(int error) { return std::generic_category().message(error); }

// Writes and flushes; the errno of the first failure, or 0.
int write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return ::fsync(file) == 0 ? 0 : errno;
}

}  // namespace

core::Expected<std::string> read_file(const std::filesystem::path& path) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (!std::filesystem::exists(status)) return core::Error{path.string(), "there is no such file"};
  if (std::filesystem::is_directory(status))
    return core::Error{path.string(), "is a folder; a file is needed"};
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return core::Error{path.string(), "cannot be opened: " + reason(errno)};
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (stream.bad()) return core::Error{path.string(), "cannot be read"};
  return text;
}

std::optional<core::Error> write_file(const std::filesystem::path& path, std::string_view text) {
  const auto failed = [&](int error) {
    return core::Error{path.string(), "cannot be written: " + reason(error)};
  };
  std::filesystem::path temporary = path;
  temporary.replace_filename(path.filename().string() + "." + std::to_string(::getpid()) + ".part");
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) return failed(errno);
  int error = write_all(file, text);
  if (::close(file) != 0 && error == 0) error = errno;
  if (error == 0 && std::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
  if (error == 0) return std::nullopt;
  ::unlink(temporary.c_str());
  return failed(error);
}

}  // namespace tencer::io
