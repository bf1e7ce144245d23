#include "Sandbox/ChildProcess.h"

#include <dlfcn.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

namespace hasp
{

std::filesystem::path FindProgram(const ChildProgram& program)
{
  if (const char* given = std::getenv(program.variable.c_str()); given && *given)
  {
    if (access(given, X_OK) != 0)
      throw std::runtime_error(program.variable +
                               " names no program that can be run; unset it or "
                               "set it to " +
                               program.file);
    return given;
  }
  Dl_info here{};
  if (dladdr(reinterpret_cast<void*>(&FindProgram), &here) != 0 && here.dli_fname)
  {
    // The library's folder, or the program's where Hasp is linked statically.
    const auto folder = std::filesystem::absolute(here.dli_fname).parent_path();
    for (const char* way : { HASP_DECODER_INSTALLED, HASP_DECODER_BUILT, "", "../libexec/hasp" })
    {
      auto file = folder / way / program.file;
      if (access(file.c_str(), X_OK) == 0)
        return file;
    }
  }
  throw std::runtime_error(program.name + " " + program.file +
                           " is not beside the library; install Hasp whole, or set " +
                           program.variable + " to that program");
}

} // namespace hasp
