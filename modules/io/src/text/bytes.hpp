// Numbers as files hold them that are not texts: their bytes, the lowest first.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace tencer::io {

template <class Number>
requires std::is_arithmetic_v<Number>
void append_bytes(std::string& bytes, Number value) {
  using Bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::uint32_t>;
  static_assert(sizeof(Number) == sizeof(Bits));
  const Bits bits = std::bit_cast<Bits>(value);
  for (std::size_t i = 0; i < sizeof(Bits); ++i) bytes += static_cast<char>(bits >> (8 * i) & 0xFF);
}

// Bytes as letters (RFC 4648).
std::string base64(std::string_view bytes);

}  // namespace tencer::io
