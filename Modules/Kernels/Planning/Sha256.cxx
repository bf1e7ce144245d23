#include "Planning/Sha256.h"

#include <openssl/evp.h>

#include <stdexcept>

namespace hasp
{

std::string Sha256(std::string_view bytes)
{
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned int size = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest, &size, EVP_sha256(), nullptr) != 1 ||
      size != 32)
    throw std::runtime_error("SHA-256 is not available; check the installation of OpenSSL");
  std::string text;
  for (unsigned int n = 0; n < size; ++n)
  {
    text += "0123456789abcdef"[digest[n] >> 4U];
    text += "0123456789abcdef"[digest[n] & 15U];
  }
  return text;
}

} // namespace hasp
