#pragma once
#include <memory>
#include <string>
#include <string_view>

namespace hasp
{

/// SHA-256 (FIPS 180-4), by OpenSSL. Needs HASP_ENABLE_OPENSSL. 64 hexadecimal digits, lower case.
/// Throws std::runtime_error if this OpenSSL has none. Any thread; about 1 GB/s.
std::string Sha256(std::string_view bytes);

/// The same of what comes in pieces.
class Sha256Stream
{
public:
  Sha256Stream();
  ~Sha256Stream();
  Sha256Stream(const Sha256Stream&) = delete;
  Sha256Stream& operator=(const Sha256Stream&) = delete;
  void Add(std::string_view bytes);
  std::string Finish(); ///< once, after the last piece

private:
  struct Context;
  std::unique_ptr<Context> Digest;
};

} // namespace hasp
