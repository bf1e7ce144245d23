#pragma once
#include <string>
#include <string_view>

namespace hasp
{

/// SHA-256 (FIPS 180-4), by OpenSSL, as 64 hexadecimal digits in lower case. Needs
/// HASP_ENABLE_OPENSSL. Throws std::runtime_error if this OpenSSL has none. Any thread; about 1
/// GB/s.
std::string Sha256(std::string_view bytes);

} // namespace hasp
