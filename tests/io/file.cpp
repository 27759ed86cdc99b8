#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <tencer/io/file.hpp>

#include "folder.hpp"

using tencer::io::read_file;
using tencer::io::write_file;

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
    const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit old_limit{};
    REQUIRE(::getrlimit(RLIMIT_FSIZE, &old_limit) == 0);
    rlimit limit = old_limit;
    limit.rlim_cur = 1000;
    REQUIRE(::setrlimit(RLIMIT_FSIZE, &limit) == 0);
    const auto error = write_file(folder / "file", std::string(5000, 'x'));
    REQUIRE(::setrlimit(RLIMIT_FSIZE, &old_limit) == 0);
    std::signal(SIGXFSZ, old_handler);
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
