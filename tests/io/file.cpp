#include <sys/resource.h>

#include <array>
#include <catch2/catch.hpp>
#include <csignal>
#include <tencer/io/file.hpp>

#include "fixtures/folder.hpp"

using tencer::io::folder_problem;
using tencer::io::read_file;
using tencer::io::write_file;
using tencer::io::write_files;

namespace {

// While it lives no file can grow beyond so many bytes, as when a disk is full.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    REQUIRE(::getrlimit(RLIMIT_FSIZE, &old_limit_) == 0);
    rlimit limit = old_limit_;
    limit.rlim_cur = bytes;
    REQUIRE(::setrlimit(RLIMIT_FSIZE, &limit) == 0);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &old_limit_);
    std::signal(SIGXFSZ, old_handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit old_limit_{};
  void (*old_handler_)(int);
};

}  // namespace

TEST_CASE("a written file is read back, byte for byte") {
  const Folder folder;
  const std::string text("a\r\nb\0c\xff", 7);
  REQUIRE_FALSE(write_file(folder / "file", text));
  CHECK(read_file(folder / "file").value() == text);
  REQUIRE_FALSE(write_file(folder / "file", ""));
  CHECK(read_file(folder / "file").value().empty());
  CHECK(folder.files() == 1);
}

TEST_CASE("a file that cannot be read says why") {
  const Folder folder;
  const auto text = [&](const auto& result) { return folder.local(result.error().text()); };
  CHECK(text(read_file(folder / "none")) == "none: there is no such file");
  std::filesystem::create_directory(folder / "sub");
  CHECK(text(read_file(folder / "sub")) == "sub: is a folder; a file is needed");
}

TEST_CASE("a write that fails leaves the old file and nothing else") {
  const Folder folder;
  folder.put("file", "old");

  SECTION("no folder") {
    const auto error = write_file(folder / "none/file", "new");
    REQUIRE(error);
    CHECK(folder.local(error->text()) == "none/file: cannot be written: No such file or directory");
  }
  SECTION("the disk is full half-way") {
    const auto error = [&] {
      const FullDisk full(1000);
      return write_file(folder / "file", std::string(5000, 'x'));
    }();
    REQUIRE(error);
    CHECK(folder.local(error->text()) == "file: cannot be written: File too large");
  }
  SECTION("a folder is in the way") {
    std::filesystem::create_directories(folder / "taken/inside");
    REQUIRE(write_file(folder / "taken", "new"));
    CHECK(std::filesystem::is_directory(folder / "taken/inside"));
    std::filesystem::remove_all(folder / "taken");
  }
  CHECK(folder.text("file") == "old");
  CHECK(folder.files() == 1);
}

TEST_CASE("files are written together, into a folder that is made") {
  const Folder folder;
  const std::array<tencer::io::NamedText, 2> files{{{"a", "first"}, {"b", "second"}}};
  REQUIRE_FALSE(write_files(folder / "new/deep", files));
  CHECK(folder.text("new/deep/a") == "first");
  CHECK(folder.text("new/deep/b") == "second");
  REQUIRE_FALSE(write_files(folder / "new/deep/", files));
  CHECK(folder.files() == 1);
  std::filesystem::remove_all(folder / "new");
}

TEST_CASE("files that cannot all be written leave the old ones and nothing else") {
  const Folder folder;
  folder.put("a", "old");
  const std::array<tencer::io::NamedText, 2> files{{{"a", "new"}, {"b", std::string(5000, 'x')}}};

  SECTION("the disk is full before the last") {
    const auto error = [&] {
      const FullDisk full(1000);
      return write_files(folder.path(), files);
    }();
    REQUIRE(error);
    CHECK(folder.local(error->text()) == "b: cannot be written: File too large");
  }
  SECTION("a new folder on a full disk") {
    const auto error = [&] {
      const FullDisk full(1000);
      return write_files(folder / "new/deep", files);
    }();
    REQUIRE(error);
    CHECK(folder.local(error->text()) == "new/deep/b: cannot be written: File too large");
  }
  SECTION("a folder is in the way of the last") {
    std::filesystem::create_directories(folder / "b/inside");
    const auto error = write_files(folder.path(), files);
    REQUIRE(error);
    CHECK(folder.local(error->text()) == "b: cannot be written: Is a directory");
    std::filesystem::remove_all(folder / "b");
  }
  SECTION("a file is in the way of the folder") {
    const auto error = write_files(folder / "a/deep", files);
    REQUIRE(error);
    CHECK(folder.local(error->text()) == "a/deep: cannot be made a folder: a is a file");
  }
  CHECK(folder.text("a") == "old");
  CHECK(folder.files() == 1);
}

TEST_CASE("a folder is tried without a trace") {
  const Folder folder;
  folder.put("file", "");
  CHECK_FALSE(folder_problem(folder.path()));
  CHECK_FALSE(folder_problem(folder / "new/deep"));
  const auto problem = folder_problem(folder / "file");
  REQUIRE(problem);
  CHECK(folder.local(problem->text()) == "file: cannot be made a folder: file is a file");
  CHECK(folder.files() == 1);
}
