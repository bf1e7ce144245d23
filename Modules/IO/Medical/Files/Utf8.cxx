#include "Files/Utf8.h"

namespace hasp
{

std::size_t DecodeUtf8(std::string_view text, std::size_t at, char32_t& character)
{
  constexpr char32_t Least[] = { 0, 0, 0x80, 0x800, 0x10000 }; // with so many bytes
  const auto byte = [&](std::size_t n) { return static_cast<unsigned char>(text[n]); };
  const unsigned first = byte(at);
  const std::size_t size = first < 0x80            ? 1
                           : first >> 5 == 0b110   ? 2
                           : first >> 4 == 0b1110  ? 3
                           : first >> 3 == 0b11110 ? 4
                                                   : 0;
  if (size == 0 || at + size > text.size())
    return 0;
  character = size == 1 ? first : first & (0xFFU >> (size + 1));
  for (std::size_t n = at + 1; n < at + size; ++n)
  {
    if (byte(n) >> 6 != 0b10)
      return 0;
    character = character << 6 | (byte(n) & 0x3FU);
  }
  const bool surrogate = character >= 0xD800 && character <= 0xDFFF;
  return character < Least[size] || surrogate || character > 0x10FFFF ? 0 : size;
}

std::string ValidUtf8(std::string_view text)
{
  std::string valid;
  for (std::size_t at = 0; at < text.size();)
  {
    char32_t character = 0;
    const std::size_t size = DecodeUtf8(text, at, character);
    valid += size == 0 ? "\xEF\xBF\xBD" : text.substr(at, size);
    at += size == 0 ? 1 : size;
  }
  return valid;
}

} // namespace hasp
