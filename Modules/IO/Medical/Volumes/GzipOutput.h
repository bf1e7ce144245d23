#pragma once
#include <cstddef>
#include <memory>

namespace hasp
{

class AtomicFile;

/// Packs what is written with gzip (level 1: five times as fast as the usual 6, a tenth larger on
/// CT) into a file that others finish. Throws std::runtime_error as AtomicFile does.
class GzipOutput
{
public:
  explicit GzipOutput(AtomicFile& into);
  ~GzipOutput();
  GzipOutput(const GzipOutput&) = delete;
  GzipOutput& operator=(const GzipOutput&) = delete;

  void Write(const void* bytes, std::size_t size);
  /// Once, at the end.
  void Finish();

private:
  void Deflate(int flush);

  struct Internals;
  std::unique_ptr<Internals> Inside;
};

} // namespace hasp
