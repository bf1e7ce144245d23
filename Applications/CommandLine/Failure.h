#pragma once
#include <stdexcept>
#include <string>

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

/// Ends a verb. The text says what, where (a file's name, never its folder) and what to do.
class Failure : public std::runtime_error
{
public:
  Failure(ExitCode exitCode, const std::string& text) : std::runtime_error(text), code(exitCode) {}
  ExitCode code;
};

} // namespace hasp
