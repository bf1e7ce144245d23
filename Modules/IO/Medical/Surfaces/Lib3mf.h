#pragma once
#include <Model/COM/NMR_DLLInterfaces.h>

#include <stdexcept>
#include <string>

namespace hasp
{

/// How lib3mf's C interface hands out what it holds.
using Lib3mfHandle = NMR::PLib3MFBase*;

/// One object of lib3mf's, released with this one.
class Lib3mfObject
{
public:
  Lib3mfObject() = default;
  Lib3mfObject(const Lib3mfObject&) = delete;
  Lib3mfObject& operator=(const Lib3mfObject&) = delete;
  ~Lib3mfObject()
  {
    if (this->Instance)
      NMR::lib3mf_release(this->Instance);
  }
  /// For the functions that give one.
  Lib3mfHandle* Out() { return &this->Instance; }
  operator Lib3mfHandle() const { return this->Instance; }

private:
  Lib3mfHandle Instance = nullptr;
};

/// Throws std::runtime_error with lib3mf's number alone: its texts may quote a file.
inline void Check3mf(LIB3MFRESULT result)
{
  if (result != LIB3MF_OK)
    throw std::runtime_error("lib3mf refuses it, code " + std::to_string(unsigned(result)));
}

} // namespace hasp
