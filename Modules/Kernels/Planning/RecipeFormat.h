#pragma once
#include "Planning/DurableFile.h"
#include "Planning/StrictJson.h"

#include <cstddef>
#include <initializer_list>
#include <stdexcept>
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

/// Puts it in place as a whole. Throws std::runtime_error, also for a text that ReadRecipeText
/// would not take. Internal. Any thread.
inline void WriteRecipeText(
  const std::string& path, const std::string& text, const std::string& subject)
{
  if (text.size() > MostRecipeBytes)
    throw std::runtime_error(subject + ": the file would have " + std::to_string(text.size()) +
                             " bytes, at most " + std::to_string(MostRecipeBytes) + " can be read");
  WriteDurably(path, text, subject + ": the file");
}

} // namespace hasp
