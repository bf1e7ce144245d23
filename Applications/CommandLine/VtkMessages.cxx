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
VtkMessageCapture::Say SayWarning, SayError;

/// Out of "ERROR: In file, line 1\nvtkHaspFoo (0x55): text\n\n".
struct Said
{
  std::string name, text; ///< name: of the class; empty where none is named

  explicit Said(const std::string& all)
  {
    const auto address = all.find(" (0x");
    const auto start = address == all.npos ? all.npos : all.find("): ", address);
    if (start == all.npos)
      return;
    const auto line = all.rfind('\n', address) + 1; // 0 where there is none
    this->name = all.substr(line, address - line);
    const auto end = all.find_last_not_of("\n ");
    this->text = WithoutFunctionNames(all.substr(start + 3, end - start - 2));
  }
  bool IsOurs() const { return this->name.starts_with("vtkHasp"); }
};

class Collector : public vtkOutputWindow
{
public:
  static Collector* New();
  vtkTypeMacro(Collector, vtkOutputWindow);

  void DisplayErrorText(const char* text) override
  {
    const std::lock_guard lock(Guard);
    if (SayError)
      SayError(VtkMessageText(text));
    else if (FirstError.empty())
      FirstError = text;
  }
  void DisplayText(const char*) override {}
  void DisplayWarningText(const char* text) override
  {
    const std::lock_guard lock(Guard);
    if (const Said said(text); said.IsOurs() && SayWarning)
      SayWarning(said.text);
  }
  void DisplayGenericWarningText(const char*) override {}
  void DisplayDebugText(const char*) override {}
};
vtkStandardNewMacro(Collector);

} // namespace

VtkMessageCapture::VtkMessageCapture(Say sayWarning, Say sayError)
{
  const std::lock_guard lock(Guard);
  SayWarning = std::move(sayWarning);
  SayError = std::move(sayError);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<Collector> collector;
  vtkOutputWindow::SetInstance(collector);
}

VtkMessageCapture::~VtkMessageCapture()
{
  const std::lock_guard lock(Guard);
  SayWarning = SayError = nullptr;
}

std::string VtkMessageText(const std::string& message)
{
  if (message.empty())
    return message;
  const Said said(message);
  return said.IsOurs() ? said.text : (said.name.empty() ? "VTK" : said.name) + " reports an error";
}

std::string TakeVtkError()
{
  const std::lock_guard lock(Guard);
  return VtkMessageText(std::exchange(FirstError, {}));
}

void ThrowVtkError(ExitCode code, const std::string& what)
{
  const std::string error = TakeVtkError();
  if (!error.empty())
    throw Failure(code, what + ": " + error);
}

} // namespace hasp
