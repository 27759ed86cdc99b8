#include "interrupt.hpp"

#include <semaphore.h>

#include <cerrno>
#include <system_error>

namespace tencer::app {
namespace {

// Told by the signal handler, heard by the listener. Of static life, so that a handler that is late
// still finds it.
sem_t told;

void handle(int);

// Libraries may have started threads before main (OpenBLAS does) that do not block the signals, and
// a signal goes to any thread that does not. So it is not enough to block them here and wait.
void give_back(int signal) {
  struct sigaction now = {};
  sigaction(signal, nullptr, &now);
  if (now.sa_handler == handle) ::signal(signal, SIG_DFL);
}

// May call only what is safe in a signal handler, so a thread does the rest.
void handle(int) {
  const int error = errno;
  give_back(SIGINT);
  give_back(SIGTERM);
  sem_post(&told);
  errno = error;
}

void take_over(int signal, struct sigaction& before) {
  sigaction(signal, nullptr, &before);
  if (before.sa_handler == SIG_IGN) return;
  struct sigaction ours = {};
  ours.sa_handler = handle;
  ours.sa_flags = SA_RESTART;
  sigemptyset(&ours.sa_mask);
  sigaddset(&ours.sa_mask, SIGINT);
  sigaddset(&ours.sa_mask, SIGTERM);
  sigaction(signal, &ours, nullptr);
}

}  // namespace

Interrupt::Interrupt() {
  if (sem_init(&told, 0, 0) != 0) throw std::system_error(errno, std::generic_category());
  listener_ = std::thread([this] {
    while (sem_wait(&told) != 0) {
      // Another signal was handled in this thread.
    }
    if (!over_) source_.request_stop();
  });
  take_over(SIGINT, before_int_);
  take_over(SIGTERM, before_term_);
}

Interrupt::~Interrupt() {
  sigaction(SIGINT, &before_int_, nullptr);
  sigaction(SIGTERM, &before_term_, nullptr);
  over_ = true;
  sem_post(&told);
  listener_.join();
}

}  // namespace tencer::app
