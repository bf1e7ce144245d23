#pragma once
#include "Failure.h"

#include <functional>

namespace hasp
{

/// VTK's error texts name source files, addresses and whole paths. From the first one on nothing of
/// VTK goes to stderr; errors are kept until they are asked for, and what a class of ours warns of
/// while it lives is handed to sayWarning at once, in the words of TakeVtkError. One at a time;
/// RENDER thread.
class VtkMessageCapture
{
public:
  explicit VtkMessageCapture(std::function<void(const std::string&)> sayWarning);
  ~VtkMessageCapture();
  VtkMessageCapture(const VtkMessageCapture&) = delete;
  VtkMessageCapture& operator=(const VtkMessageCapture&) = delete;
};

/// The first error since the last call; empty if none. What a class of ours says is given without
/// file, line, class and address; of any other class, which may name files, the class alone.
std::string TakeVtkError();

/// Throws Failure with the code, `what`, and VTK's error, if there is one.
void ThrowVtkError(ExitCode code, const std::string& what);

} // namespace hasp
