#include "VtkMessages.h"

#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <mutex>
#include <utility>

namespace hasp
{
namespace
{

std::mutex Guard; // errors may come from VTK's threads
std::string FirstError;

class Collector : public vtkOutputWindow
{
public:
  static Collector* New();
  vtkTypeMacro(Collector, vtkOutputWindow);

  void DisplayErrorText(const char* text) override
  {
    const std::lock_guard lock(Guard);
    if (FirstError.empty())
      FirstError = text;
  }
  void DisplayText(const char*) override {}
  void DisplayWarningText(const char*) override {}
  void DisplayGenericWarningText(const char*) override {}
  void DisplayDebugText(const char*) override {}
};
vtkStandardNewMacro(Collector);

/// "ERROR: In file, line 1\nvtkHaspFoo (0x55): text\n\n" becomes "text".
std::string Message(const std::string& text)
{
  if (text.empty())
    return text;
  const auto address = text.find(" (0x");
  const auto start = address == text.npos ? text.npos : text.find("): ", address);
  if (start == text.npos)
    return "VTK reports an error";
  const auto line = text.rfind('\n', address) + 1; // 0 where there is none
  const std::string name = text.substr(line, address - line);
  if (!name.starts_with("vtkHasp"))
    return name + " reports an error";
  std::string message = text.substr(start + 3);
  while (!message.empty() && (message.back() == '\n' || message.back() == ' '))
    message.pop_back();
  return WithoutFunctionNames(message);
}

} // namespace

void CaptureVtkMessages()
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<Collector> collector;
  vtkOutputWindow::SetInstance(collector);
}

std::string TakeVtkError()
{
  const std::lock_guard lock(Guard);
  return Message(std::exchange(FirstError, {}));
}

void ThrowVtkError(ExitCode code, const std::string& what)
{
  const std::string error = TakeVtkError();
  if (!error.empty())
    throw Failure(code, what + ": " + error);
}

} // namespace hasp
