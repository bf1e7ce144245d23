#pragma once
#include "Failure.h"
#include "Grid/Progress.h"

#include <chrono>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

/// What verbs share that call kernels and write folders.
namespace hasp
{

inline double MillisecondsSince(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
    .count();
}

/// What reads, cuts or writes, its exceptions as failures of this kind.
template <typename Work>
auto Try(ExitCode code, const std::string& before, const Work& work)
{
  try
  {
    return work();
  }
  catch (const Failure&)
  {
    throw;
  }
  catch (const Cancelled&)
  {
    throw; // it was asked for
  }
  catch (const std::bad_alloc&)
  {
    throw; // no fault of the file; the caller says what to do
  }
  catch (const std::exception& error)
  {
    throw Failure(code, before + SafeText(error));
  }
}

/// A line of a table, as printf writes it, up to 199 characters.
std::string Line(const char* format, auto... figures)
{
  char text[200];
  std::snprintf(text, sizeof text, format, figures...);
  return text;
}

} // namespace hasp
