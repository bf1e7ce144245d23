#include "PlanInput.h"

#include "Files.h"

#include "Planning/PlanLists.h"

#include <filesystem>
#include <fstream>
#include <sstream>

namespace hasp
{

bool IsPlanFolder(const std::string& path)
{
  std::error_code error;
  return std::filesystem::is_directory(path, error);
}

std::string PlanFolder(const std::string& path)
{
  return IsPlanFolder(path) ? path : std::filesystem::path(path).parent_path().string();
}

PlanDocument OpenPlan(const std::string& path)
{
  RequireInput(path);
  return Try(ExitCode::BadInput, "",
    [&] { return IsPlanFolder(path) ? LoadPlan(path) : ParsePlan(ReadText(path)); });
}

void StorePlan(const std::string& folder, const PlanDocument& document)
{
  Try(ExitCode::WrongUse, "", [&] { SavePlan(folder, document); });
}

std::string ReadText(const std::string& path)
{
  RequireInput(path);
  constexpr std::uintmax_t most = 64U << 20U;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error) ||
      std::filesystem::file_size(path, error) > most)
    throw Failure(ExitCode::BadInput, FileLabel(path) + ": it is no file of at most 64 MiB");
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file)
    throw Failure(ExitCode::BadInput, FileLabel(path) + ": it cannot be read");
  return text.str();
}

} // namespace hasp
