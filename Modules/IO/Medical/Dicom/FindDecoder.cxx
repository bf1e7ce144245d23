#include "Dicom/DecoderProcess.h"

#include <dlfcn.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

namespace hasp
{

std::filesystem::path FindDecoder()
{
  if (const char* given = std::getenv("HASP_DICOM_DECODER"); given && *given)
  {
    if (access(given, X_OK) != 0)
      throw std::runtime_error("HASP_DICOM_DECODER names no program that can be run; unset it or "
                               "set it to hasp-dicom-decode");
    return given;
  }
  Dl_info here{};
  if (dladdr(reinterpret_cast<void*>(&FindDecoder), &here) != 0 && here.dli_fname)
  {
    // The library's folder, or the program's where Hasp is linked statically.
    const auto folder = std::filesystem::absolute(here.dli_fname).parent_path();
    for (const char* way : { HASP_DECODER_INSTALLED, HASP_DECODER_BUILT, "", "../libexec/hasp" })
    {
      const auto program = folder / way / "hasp-dicom-decode";
      if (access(program.c_str(), X_OK) == 0)
        return program;
    }
  }
  throw std::runtime_error("the DICOM decoder hasp-dicom-decode is not beside the library; install "
                           "Hasp whole, or set HASP_DICOM_DECODER to that program");
}

} // namespace hasp
