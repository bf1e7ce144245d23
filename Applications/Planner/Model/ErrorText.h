#pragma once
#include <QString>

#include <exception>
#include <system_error>

namespace hasp
{

/// What an exception says, for the user: in our own words, or, where the library would quote a
/// path, which may name a patient, in the system's. Any thread.
inline QString ErrorText(const std::exception& error)
{
  const auto* system = dynamic_cast<const std::system_error*>(&error);
  return system ? QString::fromStdString(system->code().message())
                : QString::fromUtf8(error.what());
}

} // namespace hasp
