// Implants of random recipes, half of them nonsense, through VTK's filter.
#include "ImplantTrial.h"
#include "RandomImplants.h"

#include "vtkHaspImplantFilter.h"
#include "vtkHaspVolumeView.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>

namespace
{

hasp::TriangleMesh Filtered(const hasp::AnyGridView& volume, const hasp::ImplantRecipe& recipe)
{
  const auto& view = std::get<hasp::GridView<const std::int16_t>>(volume);
  vtkNew<vtkHaspImplantFilter> filter;
  std::string error;
  vtkNew<vtkCallbackCommand> keep;
  keep->SetClientData(&error);
  keep->SetCallback([](vtkObject*, unsigned long, void* kept, void* text)
    { *static_cast<std::string*>(kept) += static_cast<const char*>(text); });
  filter->AddObserver(vtkCommand::ErrorEvent, keep);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, keep);
  filter->SetInputData(hasp::MakeImage(
    view.geometry, std::vector<std::int16_t>(view.data, view.data + view.geometry.Size())));
  filter->SetRecipe(recipe);
  filter->Update();
  if (error.empty())
    return hasp::MakeTriangleMesh(filter->GetOutput());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPolys(), 0);
  throw std::runtime_error(error);
}

class RandomImplants : public testing::TestWithParam<std::uint32_t>
{
};

TEST_P(RandomImplants, AreSoundOrRefusedByName)
{
  const hasp::ImplantTrial trial = hasp::TryImplants(GetParam(), 7, hasp::ImplantSkulls, Filtered);
  std::string wrong;
  for (const std::string& text : trial.wrong)
    wrong += text + "\n";
  EXPECT_EQ(wrong, "");
  EXPECT_EQ(trial.made + trial.refused, 7U);
  EXPECT_GT(trial.made, 2U);
  EXPECT_GT(trial.refused, 1U);
}
// Each a skull of its own, and nonsenses of its own.
INSTANTIATE_TEST_SUITE_P(, RandomImplants, testing::Values(0U, 21U, 42U, 63U));

TEST(RandomImplantRecipes, HoldEveryNonsenseAndAreTheSameEachTime)
{
  const hasp::ImplantSkull skull = hasp::MakeImplantSkull(0);
  std::set<hasp::ImplantNonsense> met;
  for (std::uint32_t seed = 0; seed < 200; seed += hasp::ImplantSkulls)
  {
    const hasp::RandomImplant random = hasp::RandomImplantRecipe(seed, skull);
    met.insert(random.nonsense);
    EXPECT_EQ(hasp::RandomImplantRecipe(seed, skull).recipe, random.recipe);
  }
  EXPECT_EQ(int(met.size()), hasp::ImplantNonsenses);
}

} // namespace
