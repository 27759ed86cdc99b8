// Ctrl-C as a request to stop: the first one ends the work early with what there is, the second one
// ends the program.
#pragma once

#include <atomic>
#include <csignal>
#include <stop_token>
#include <thread>

namespace tencer::app {

// Takes over SIGINT and SIGTERM while it lives, whichever thread they reach; a signal that the
// program was started to ignore stays ignored. One at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  std::stop_token token() const { return source_.get_token(); }

 private:
  std::stop_source source_;
  std::atomic<bool> over_ = false;
  struct sigaction before_int_ = {};
  struct sigaction before_term_ = {};
  std::thread listener_;
};

}  // namespace tencer::app
