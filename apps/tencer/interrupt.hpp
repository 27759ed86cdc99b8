// Ctrl-C as a request to stop: the first one ends the work early with what there is, the second one
// ends the program.
#pragma once

#include <stop_token>
#include <thread>

namespace tencer::app {

class Interrupt {
 public:
  // Takes over SIGINT and SIGTERM of this thread and those it starts from now on.
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  std::stop_token token() const { return source_.get_token(); }

 private:
  std::stop_source source_;
  std::jthread listener_;
};

}  // namespace tencer::app
