#include "CommandLine.h"
#include "Failure.h"

#include <exception>
#include <iostream>

int main(int count, char** arguments)
{
  try
  {
    return hasp::RunCommandLine(count, arguments);
  }
  catch (const std::exception& error)
  {
    std::cerr << "hasp: unexpected: " << error.what() << "\n";
    return static_cast<int>(hasp::ExitCode::BadInput);
  }
}
