#include "View/SceneCamera.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>

namespace hasp
{
namespace
{

struct Side
{
  char letter;
  std::array<double, 3> towards, up; ///< the viewer, from the patient
};
constexpr std::array<Side, 6> AllSides{ { { 'A', { 0, -1, 0 }, { 0, 0, 1 } },
  { 'P', { 0, 1, 0 }, { 0, 0, 1 } }, { 'L', { 1, 0, 0 }, { 0, 0, 1 } },
  { 'R', { -1, 0, 0 }, { 0, 0, 1 } }, { 'S', { 0, 0, 1 }, { 0, -1, 0 } },
  { 'I', { 0, 0, -1 }, { 0, -1, 0 } } } };

} // namespace

void LookAtAll(vtkRenderer* renderer, const vtkBoundingBox& box)
{
  if (!box.IsValid())
    return;
  double bounds[6];
  box.GetBounds(bounds);
  renderer->ResetCamera(bounds);
}

void LookFromSide(vtkRenderer* renderer, const vtkBoundingBox& box, char side)
{
  const auto found = std::find_if(
    AllSides.begin(), AllSides.end(), [&](const Side& is) { return is.letter == side; });
  if (found == AllSides.end() || !box.IsValid())
    return;
  double middle[3];
  box.GetCenter(middle);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(middle);
  camera->SetPosition(
    middle[0] + found->towards[0], middle[1] + found->towards[1], middle[2] + found->towards[2]);
  camera->SetViewUp(found->up.data());
  LookAtAll(renderer, box);
}

void RayOfPixel(vtkRenderer* renderer, int x, int y, double from[3], double to[3])
{
  const auto place = [&](double depth, double at[3])
  {
    double world[4];
    renderer->SetDisplayPoint(x, y, depth);
    renderer->DisplayToWorld();
    renderer->GetWorldPoint(world);
    for (int axis = 0; axis < 3; ++axis)
      at[axis] = world[axis] / world[3];
  };
  place(0.0, from);
  place(1.0, to);
}

} // namespace hasp
