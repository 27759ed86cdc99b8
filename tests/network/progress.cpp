// Progress is told by one thread at a time, whatever stages do.
#include <atomic>
#include <catch2/catch.hpp>
#include <string>
#include <tencer/network/stage.hpp>
#include <thread>
#include <vector>

using tencer::network::Progress;
using tencer::network::ProgressSink;

TEST_CASE("copies of a sink share its lock") {
  std::atomic<int> within = 0;
  std::atomic<int> together = 0;
  int calls = 0;  // not atomic: the thread sanitizer looks at it
  const ProgressSink sink([&](const Progress&) {
    if (++within > 1) ++together;
    ++calls;
    std::this_thread::yield();
    --within;
  });
  std::vector<std::jthread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([copy = sink] {
      for (int i = 0; i < 500; ++i) copy({.stage = "stage", .cables = i});
    });
  threads.clear();
  CHECK(calls == 2000);
  CHECK(together == 0);
}

TEST_CASE("a sink without a function is silent") {
  const ProgressSink sink;
  CHECK_NOTHROW(sink({.stage = "stage"}));
}
