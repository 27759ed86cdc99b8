#include <cerrno>
#include <fstream>
#include <iterator>
#include <random>
#include <system_error>
#include <tencer/io/file.hpp>

namespace tencer::io {
namespace {

std::string reason(int error) { return std::generic_category().message(error); }

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
  // Its own name for each write, so that two programs do not write into each other's.
  std::filesystem::path temporary = path;
  temporary.concat(".").concat(std::to_string(std::random_device()())).concat(".part");
  errno = 0;
  std::ofstream stream(temporary, std::ios::binary | std::ios::trunc);
  stream << text;
  stream.close();  // flushes
  int error = stream ? 0 : errno != 0 ? errno : EIO;
  std::error_code renaming;
  if (error == 0) std::filesystem::rename(temporary, path, renaming);
  if (renaming) error = renaming.value();
  if (error == 0) return std::nullopt;
  std::error_code ignored;
  std::filesystem::remove(temporary, ignored);
  return failed(error);
}

}  // namespace tencer::io
