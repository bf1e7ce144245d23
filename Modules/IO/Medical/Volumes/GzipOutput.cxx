#include "Volumes/GzipOutput.h"
#include "Files/AtomicFile.h"

#include "vtk_zlib.h"

#include <algorithm>
#include <new>
#include <vector>

namespace hasp
{

struct GzipOutput::Internals
{
  AtomicFile& into;
  z_stream z{};
  std::vector<char> packed = std::vector<char>(1 << 18);
};

GzipOutput::GzipOutput(AtomicFile& into) : Inside(new Internals{ into })
{
  constexpr int gzip = 16; // added to the window's bits
  if (deflateInit2(&this->Inside->z, Z_BEST_SPEED, Z_DEFLATED, 15 + gzip, 8, Z_DEFAULT_STRATEGY) !=
      Z_OK)
    throw std::bad_alloc();
}

GzipOutput::~GzipOutput()
{
  deflateEnd(&this->Inside->z);
}

void GzipOutput::Deflate(int flush)
{
  z_stream& z = this->Inside->z;
  auto& packed = this->Inside->packed;
  do
  {
    z.next_out = reinterpret_cast<Bytef*>(packed.data());
    z.avail_out = static_cast<uInt>(packed.size());
    deflate(&z, flush);
    this->Inside->into.Write(packed.data(), packed.size() - z.avail_out);
  } while (z.avail_out == 0);
}

void GzipOutput::Write(const void* bytes, std::size_t size)
{
  const auto* from = static_cast<const Bytef*>(bytes);
  while (size > 0)
  {
    const std::size_t piece = std::min<std::size_t>(size, 1 << 30); // zlib counts in 32 bits
    this->Inside->z.next_in = const_cast<Bytef*>(from);             // it is not written to
    this->Inside->z.avail_in = static_cast<uInt>(piece);
    this->Deflate(Z_NO_FLUSH);
    from += piece;
    size -= piece;
  }
}

void GzipOutput::Finish()
{
  this->Inside->z.avail_in = 0;
  this->Deflate(Z_FINISH);
}

} // namespace hasp
