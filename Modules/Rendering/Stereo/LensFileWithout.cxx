// In place of LensFile.cxx where HASP_ENABLE_JSON is OFF.
#include "LensFile.h"

#include <stdexcept>

namespace hasp
{

LensModel ParseLens(const std::string&)
{
  throw std::runtime_error("lens file: this build reads no JSON; build with HASP_ENABLE_JSON=ON");
}

LensModel ReadLens(const std::string&)
{
  return ParseLens({});
}

} // namespace hasp
