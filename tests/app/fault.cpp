// Preloaded into the program by tests: the TENCER_FAULT_AT-th call that changes a file (opening,
// writing, renaming, making a folder) ends the program as kill -9 would, or fails for want of space
// and so do all after it but to rename, as TENCER_FAULT says: "kill" or "full".
#include <dlfcn.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace {

template <class Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

// Whether the call has to fail; `once`: when it is the one that was chosen, not when it comes
// later.
bool fault(bool once = false) {
  static int calls = 0;
  const char* at = std::getenv("TENCER_FAULT_AT");
  const char* kind = std::getenv("TENCER_FAULT");
  if (!at || !kind) return false;
  int chosen = 0;
  if (std::from_chars(at, at + std::strlen(at), chosen).ec != std::errc()) std::abort();
  if (++calls < chosen || (once && calls > chosen)) return false;
  if (std::string_view(kind) == "kill") std::raise(SIGKILL);
  errno = ENOSPC;
  return true;
}

bool is_file(int descriptor) { return descriptor > STDERR_FILENO; }

}  // namespace

extern "C" {

FILE* fopen64(const char* path, const char* mode) {
  if (mode[0] != 'r' && fault()) return nullptr;
  return real<FILE*(const char*, const char*)>("fopen64")(path, mode);
}

FILE* fopen(const char* path, const char* mode) {
  if (mode[0] != 'r' && fault()) return nullptr;
  return real<FILE*(const char*, const char*)>("fopen")(path, mode);
}

ssize_t write(int descriptor, const void* data, size_t size) {
  if (is_file(descriptor) && fault()) return -1;
  return real<ssize_t(int, const void*, size_t)>("write")(descriptor, data, size);
}

ssize_t writev(int descriptor, const iovec* pieces, int count) {
  if (is_file(descriptor) && fault()) return -1;
  return real<ssize_t(int, const iovec*, int)>("writev")(descriptor, pieces, count);
}

int rename(const char* from, const char* to) {
  if (fault(true)) return -1;
  return real<int(const char*, const char*)>("rename")(from, to);
}

int mkdir(const char* path, mode_t mode) {
  if (fault()) return -1;
  return real<int(const char*, mode_t)>("mkdir")(path, mode);
}

}  // extern "C"
