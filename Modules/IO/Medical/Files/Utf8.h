#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace hasp
{

/// Bytes of the UTF-8 character that begins at `at`, and which it is; 0: there is none (cut off,
/// longer than it need be, a surrogate or beyond U+10FFFF).
std::size_t DecodeUtf8(std::string_view text, std::size_t at, char32_t& character);

/// The text, each byte that is of no UTF-8 character replaced by U+FFFD.
std::string ValidUtf8(std::string_view text);

} // namespace hasp
