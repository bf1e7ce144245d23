#include "XMLOutput.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

void Write(const void* bytes, std::size_t size)
{
  if (std::fwrite(bytes, 1, size, stdout) != size)
    throw std::runtime_error("nobody reads");
}

void WriteFrame(hasp::XMLFrame::Kind kind, double share)
{
  const hasp::XMLFrame frame{ hasp::XMLFrame::Magic, kind, share };
  Write(&frame, sizeof(frame));
  std::fflush(stdout);
}

BeatingFile::BeatingFile(const std::string& path)
{
  if (this->open(path, std::ios::in | std::ios::binary))
  {
    this->Bytes = static_cast<double>(this->pubseekoff(0, std::ios::end));
    this->pubseekpos(0);
  }
}

void BeatingFile::Beat(std::streamsize more)
{
  this->Done += static_cast<double>(more);
  if (Clock::now() - this->Last < std::chrono::milliseconds(100))
    return;
  this->Last = Clock::now();
  WriteFrame(hasp::XMLFrame::Busy, std::min(1.0, this->Done / std::max(1.0, this->Bytes)));
}

BeatingFile::int_type BeatingFile::underflow()
{
  const int_type first = this->std::filebuf::underflow();
  this->Beat(this->egptr() - this->gptr());
  return first;
}

std::streamsize BeatingFile::xsgetn(char* into, std::streamsize size)
{
  constexpr std::streamsize piece = 1 << 20; // one read of a gigabyte would be silent for long
  std::streamsize done = 0;
  while (done < size)
  {
    const std::streamsize got =
      this->std::filebuf::xsgetn(into + done, std::min(piece, size - done));
    if (got <= 0)
      break;
    done += got;
    this->Beat(got);
  }
  return done;
}
