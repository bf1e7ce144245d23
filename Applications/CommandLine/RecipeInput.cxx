#include "RecipeInput.h"

#include "Failure.h"
#include "Files.h"
#include "vtkHaspFileNames.h"

#include "Planning/GuideRecipeFile.h"

namespace hasp
{

GuideRecipe ReadRecipe(const std::string& path)
{
  RequireInput(path);
  try
  {
    return ReadGuideRecipe(path);
  }
  catch (const std::exception& error)
  {
    throw Failure(ExitCode::BadInput, FileLabel(path) + ": " + SafeText(error));
  }
}

} // namespace hasp
