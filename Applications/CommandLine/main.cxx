#include "CommandLine.h"
#include "Failure.h"
#include "vtkHaspOutputFile.h"

#include <csignal>
#include <exception>
#include <iostream>
#include <typeinfo>

namespace
{

extern "C" void EndBySignal(int number)
{
  hasp::RemovePendingFiles();
  std::signal(number, SIG_DFL); // whoever sent it sees that it ended the program
  std::raise(number);
}

void LeaveNothingWhenInterrupted()
{
  for (const int number : { SIGINT, SIGTERM, SIGHUP, SIGPIPE })
    if (std::signal(number, EndBySignal) == SIG_IGN) // by nohup, say
      std::signal(number, SIG_IGN);
}

} // namespace

int main(int count, char** arguments)
{
  LeaveNothingWhenInterrupted();
  try
  {
    return hasp::RunCommandLine(count, arguments);
  }
  catch (const std::exception& error)
  {
    // Its text may quote the command line; its type may not.
    std::cerr << "hasp: unexpected, a defect of the program: " << typeid(error).name() << "\n";
    return static_cast<int>(hasp::ExitCode::BadInput);
  }
}
