// hasp-xml-decode: reads VTK's XML files for Hasp in a process of its own, so that a bad file can
// harm nothing. See XMLWire.h for what goes in and out. It limits its own memory and time before it
// opens the file, and opens no other file.
#include "Sandbox/Confinement.h"
#include "XMLOutput.h"

#include "vtkLogger.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <string>

int main(int argc, char** argv)
{
  const std::string mode = argc == 4 ? argv[1] : "";
  if (mode != "image-header" && mode != "image" && mode != "surface")
  {
    std::fputs(
      "usage: hasp-xml-decode image-header|image|surface MEMORY_BYTES SECONDS < path, NUL-ended\n"
      "Hasp starts this program itself to read .vti and .vtp files.\n",
      stderr);
    return 2;
  }
  if (hasp::EnterSandbox(std::strtoull(argv[2], nullptr, 10),
        std::strtoull(argv[3], nullptr, 10)) == hasp::Confinement::None)
    return 4;
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // errors come as events
  try
  {
    std::string path;
    std::getline(std::cin, path, '\0');
    BeatingFile file(path);
    const int result = mode == "surface" ? WriteSurface(file) : WriteImage(file, mode == "image");
    std::fflush(stdout);
    std::_Exit(result); // nothing is left to do; VTK's clean-up would walk what the file made
  }
  catch (const std::bad_alloc&)
  {
    return 3;
  }
  catch (const std::exception&)
  {
    return 6;
  }
}
