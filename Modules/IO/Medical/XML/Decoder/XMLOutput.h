#pragma once
#include "XML/XMLWire.h"

#include <chrono>
#include <cstddef>
#include <fstream>
#include <string>

/// Standard output, as XMLWire.h has it. Throws std::runtime_error if nobody reads it.
void Write(const void* bytes, std::size_t size);
void WriteFrame(hasp::XMLFrame::Kind kind, double share);

/// The one file that is read. While it is, standard output says how far, ten times a second at
/// most: whoever takes long without reading is thus silent.
class BeatingFile : public std::filebuf
{
public:
  explicit BeatingFile(const std::string& path);

protected:
  int_type underflow() override;
  std::streamsize xsgetn(char* into, std::streamsize size) override;

private:
  void Beat(std::streamsize more);

  using Clock = std::chrono::steady_clock;
  Clock::time_point Last = Clock::now();
  double Bytes = 0.0, Done = 0.0; ///< done counts what is read again, too
};

int WriteImage(BeatingFile& file, bool samples);
int WriteSurface(BeatingFile& file);
