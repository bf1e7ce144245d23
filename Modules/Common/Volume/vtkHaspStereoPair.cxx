#include "vtkHaspStereoPair.h"

#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"

#include <glm/gtc/type_ptr.hpp>

namespace hasp
{
namespace
{

constexpr int Numbers = 16;

vtkInformationDoubleVectorKey* LeftKey()
{
  static auto* const key =
    vtkInformationDoubleVectorKey::MakeKey("LEFT_WORLD_TO_CLIP", "vtkHaspStereoPair", Numbers);
  return key; // VTK's own manager deletes keys
}

vtkInformationDoubleVectorKey* RightKey()
{
  static auto* const key =
    vtkInformationDoubleVectorKey::MakeKey("RIGHT_WORLD_TO_CLIP", "vtkHaspStereoPair", Numbers);
  return key;
}

} // namespace

void SetStereoPair(vtkInformation* information, const std::optional<StereoPair>& pair)
{
  information->Remove(LeftKey());
  information->Remove(RightKey());
  if (!pair)
    return;
  information->Set(LeftKey(), glm::value_ptr(pair->left), Numbers);
  information->Set(RightKey(), glm::value_ptr(pair->right), Numbers);
}

std::optional<StereoPair> StereoPairOf(vtkInformation* information)
{
  if (!information || !information->Has(LeftKey()) || !information->Has(RightKey()))
    return std::nullopt;
  return StereoPair{ glm::make_mat4(information->Get(LeftKey())),
    glm::make_mat4(information->Get(RightKey())) };
}

} // namespace hasp
