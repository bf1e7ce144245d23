#pragma once
#include "Planning/DurableFile.h"
#include "Planning/StrictJson.h"

#include <cstddef>
#include <initializer_list>
#include <string>

namespace hasp
{

constexpr std::size_t MostRecipeBytes = 16U << 20U;

/// Throws std::invalid_argument "SUBJECT: format …" unless the file says one of these: of another
/// kind of ours with its name and what takes it, and never with text of the file. To be asked
/// before StrictJson is, to which the keys of another kind are unknown. Internal. Any thread.
void CheckFormat(
  const Json& json, const std::string& subject, std::initializer_list<const char*> formats);

/// The whole of a recipe's file. Throws std::runtime_error. Internal. Any thread.
inline std::string ReadRecipeText(const std::string& path, const std::string& subject)
{
  return ReadWhole(path, MostRecipeBytes, subject + ": the file");
}

} // namespace hasp
