#ifndef StorageBuffer_h
#define StorageBuffer_h

#include <cstddef>

/// One shader storage buffer. Nothing is allocated before Upload. Not released with the object: its
/// context may be gone by then. Threads: RENDER, with the context current.
class StorageBuffer
{
public:
  /// Replaces what was there. Throws std::runtime_error, naming `what`, if the GPU has no room.
  void Upload(const void* data, std::size_t bytes, const char* what);
  /// Bytes [from, from + bytes) of what is there.
  void Replace(std::size_t from, const void* data, std::size_t bytes);
  void Release();
  std::size_t Bytes() const { return this->ByteCount; }
  /// Bytes [from, to), or all.
  void Bind(unsigned int slot, std::size_t from, std::size_t to) const;
  void Bind(unsigned int slot) const { this->Bind(slot, 0, this->ByteCount); }

private:
  unsigned int Name = 0;
  std::size_t ByteCount = 0;
};

#endif
