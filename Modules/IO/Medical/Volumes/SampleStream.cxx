#include "Volumes/SampleFile.h"

#include "vtk_zlib.h"

#include <algorithm>
#include <new>

namespace hasp
{

struct SampleStream::Unzipper
{
  z_stream z{};
  std::vector<char> packed = std::vector<char>(1 << 18);
  bool ended = false;   ///< the zipped member is read to its checksum
  bool another = false; ///< it is not the first

  Unzipper()
  {
    constexpr int zlibOrGzip = 32; // added to the window's bits
    if (inflateInit2(&this->z, 15 + zlibOrGzip) != Z_OK)
      throw std::bad_alloc();
  }
  ~Unzipper() { inflateEnd(&this->z); }
};

SampleStream::SampleStream(const SampleFile& file) : File(file), Stream(file.data, std::ios::binary)
{
  this->Stream.seekg(static_cast<std::streamoff>(file.offset));
  if (!this->Stream)
    ThrowFileError(file.header, "cannot be opened");
  if (!file.zipped)
    return;
  this->Zip = std::make_unique<Unzipper>();
  char ignored[4096];
  for (std::uint64_t left = file.skip; left > 0;)
  {
    const auto bytes = std::min<std::uint64_t>(left, sizeof(ignored));
    this->Read(ignored, bytes);
    left -= bytes;
  }
}

SampleStream::~SampleStream() = default;

void SampleStream::Fail(const std::string& what) const
{
  ThrowFileError(this->File.header, "its compressed samples are " + what + "; copy it again");
}

/// As many bytes as there are, at most `size`; 0 at the end.
std::size_t SampleStream::Unzip(char* into, std::size_t size)
{
  z_stream& z = this->Zip->z;
  auto& packed = this->Zip->packed;
  z.next_out = reinterpret_cast<Bytef*>(into);
  z.avail_out = static_cast<uInt>(size);
  while (z.avail_out == size)
  {
    if (z.avail_in == 0)
    {
      this->Stream.read(packed.data(), static_cast<std::streamsize>(packed.size()));
      z.next_in = reinterpret_cast<Bytef*>(packed.data());
      z.avail_in = static_cast<uInt>(this->Stream.gcount());
      if (z.avail_in == 0 && this->Zip->ended)
        return 0;
      if (z.avail_in == 0)
        this->Fail(this->Zip->another ? "cut off or followed by what is none" : "cut off");
    }
    if (this->Zip->ended) // gzip files may be made of several members
    {
      if (inflateReset(&z) != Z_OK)
        throw std::bad_alloc();
      this->Zip->ended = false;
      this->Zip->another = true;
    }
    const int result = inflate(&z, Z_NO_FLUSH);
    if (result != Z_OK && result != Z_STREAM_END)
      this->Fail("damaged or followed by what is none");
    this->Zip->ended = result == Z_STREAM_END;
  }
  return size - z.avail_out;
}

void SampleStream::Read(char* into, std::size_t size)
{
  if (!this->Zip)
  {
    if (!this->Stream.read(into, static_cast<std::streamsize>(size)))
      ThrowFileError(this->File.header, "cannot be read to its end");
    return;
  }
  while (size > 0)
  {
    const std::size_t made = this->Unzip(into, std::min<std::size_t>(size, 1 << 24));
    if (made == 0)
      this->Fail("fewer than the header declares");
    into += made;
    size -= made;
  }
}

void SampleStream::ExpectEnd()
{
  char beyond = 0;
  if (this->Zip && this->Unzip(&beyond, 1) > 0)
    this->Fail("more than the header declares");
}

} // namespace hasp
