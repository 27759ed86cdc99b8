// Numbers out of a fuzz program's input bytes; zeros once they are used up.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace tencer::fuzz {

class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  bool empty() const { return size_ == 0; }

  std::uint8_t byte() {
    std::uint8_t result = 0;
    take(&result, 1);
    return result;
  }
  bool flag() { return (byte() & 1) != 0; }
  // From 0 to most, one byte.
  int below_or(int most) { return byte() % (most + 1); }
  // Any double at all, eight bytes.
  double any_double() {
    double result = 0.0;
    take(&result, sizeof result);
    return result;
  }
  // In [-1, 1], two bytes: small inputs reach far.
  double share() {
    std::int16_t result = 0;
    take(&result, sizeof result);
    return std::max(result / 32767.0, -1.0);
  }
  // 2^-range to 2^range in steps that land on round numbers, one byte.
  double scale(int range) { return std::exp2(std::round(range * (byte() - 128) / 127.0)); }

 private:
  void take(void* to, std::size_t count) {
    const std::size_t there = std::min(count, size_);
    std::memcpy(to, data_, there);
    data_ += there;
    size_ -= there;
  }

  const std::uint8_t* data_;
  std::size_t size_;
};

}  // namespace tencer::fuzz
