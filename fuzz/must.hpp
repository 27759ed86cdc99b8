// What a fuzz program calls about things that must hold.
#pragma once

namespace tencer::fuzz {

// Traps, so that the debugger and libFuzzer's stack trace show the line.
inline void must(bool holds) {
  if (!holds) __builtin_trap();
}

}  // namespace tencer::fuzz
