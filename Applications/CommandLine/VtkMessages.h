#pragma once
#include "Failure.h"

#include <functional>

namespace hasp
{

/// VTK's error texts name source files, addresses and whole paths. From the first one on nothing of
/// VTK goes to stderr; errors are kept until they are asked for, and what a class of ours warns of
/// while it lives is handed to sayWarning at once, in the words of VtkMessageText. With sayError
/// errors are handed to it in the same way, and none is kept: for programs that go on. Both are
/// called on the thread that has something to say. One at a time; made on RENDER.
class VtkMessageCapture
{
public:
  using Say = std::function<void(const std::string&)>;
  explicit VtkMessageCapture(Say sayWarning, Say sayError = {});
  ~VtkMessageCapture();
  VtkMessageCapture(const VtkMessageCapture&) = delete;
  VtkMessageCapture& operator=(const VtkMessageCapture&) = delete;
};

/// What is to be said of a message that VTK made of an error or a warning. What a class of ours
/// says is given without file, line, class and address; of any other class, which may name files,
/// the class alone. Empty of an empty one. Any thread.
std::string VtkMessageText(const std::string& message);

/// VtkMessageText of the first error since the last call; empty if none.
std::string TakeVtkError();

/// Throws Failure with the code, `what`, and VTK's error, if there is one.
void ThrowVtkError(ExitCode code, const std::string& what);

} // namespace hasp
