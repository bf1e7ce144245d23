#pragma once
#include <stdexcept>
#include <string>
#include <vector>

namespace hasp
{

/// What the process returns. Listed in `hasp --help`.
enum class ExitCode
{
  Ok = 0,
  WrongUse = 1,    ///< an option, a value or an output place that cannot be
  BadInput = 2,    ///< a file that is missing, broken or not what the verb needs
  FailedCheck = 3, ///< the work was done, and what came out does not hold
  CannotDraw = 4   ///< no OpenGL
};

/// Ends a verb. The text says what, where (hasp::FileLabel, never a name) and what to do.
class Failure : public std::runtime_error
{
public:
  Failure(ExitCode exitCode, const std::string& text) : std::runtime_error(text), code(exitCode) {}
  ExitCode code;
};

/// What an exception says, without what the library it comes from would say of names or contents of
/// files.
std::string SafeText(const std::exception& error);

/// A text of ours as its user reads it: "ExtractActiveCells: the volume ..." without the function.
std::string WithoutFunctionNames(const std::string& text);

/// A failed check and its reasons, a line each.
inline Failure FailedCheck(const std::string& what, const std::vector<std::string>& faults)
{
  std::string text = what + ":";
  for (const std::string& fault : faults)
    text += "\n  " + fault;
  return { ExitCode::FailedCheck, text };
}

} // namespace hasp
