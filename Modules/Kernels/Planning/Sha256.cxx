#include "Planning/Sha256.h"

#include <openssl/evp.h>

#include <stdexcept>

namespace hasp
{

namespace
{
void Require(bool done)
{
  if (!done)
    throw std::runtime_error("SHA-256 is not available; check the installation of OpenSSL");
}

struct Free
{
  void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
};
} // namespace

struct Sha256Stream::Context
{
  std::unique_ptr<EVP_MD_CTX, Free> md{ EVP_MD_CTX_new() };
};

Sha256Stream::Sha256Stream() : Digest(std::make_unique<Context>())
{
  Require(
    this->Digest->md && EVP_DigestInit_ex(this->Digest->md.get(), EVP_sha256(), nullptr) == 1);
}

Sha256Stream::~Sha256Stream() = default;

void Sha256Stream::Add(std::string_view bytes)
{
  Require(EVP_DigestUpdate(this->Digest->md.get(), bytes.data(), bytes.size()) == 1);
}

std::string Sha256Stream::Finish()
{
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned int size = 0;
  Require(EVP_DigestFinal_ex(this->Digest->md.get(), digest, &size) == 1 && size == 32);
  std::string text;
  for (unsigned int n = 0; n < size; ++n)
  {
    text += "0123456789abcdef"[digest[n] >> 4U];
    text += "0123456789abcdef"[digest[n] & 15U];
  }
  return text;
}

std::string Sha256(std::string_view bytes)
{
  Sha256Stream stream;
  stream.Add(bytes);
  return stream.Finish();
}

} // namespace hasp
