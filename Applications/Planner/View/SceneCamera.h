#pragma once

class vtkBoundingBox;
class vtkRenderer;

/// Where a scene is seen from. World = patient LPS. Threads: RENDER.
namespace hasp
{

/// From the patient's side 'A', 'P', 'L', 'R', 'S' or 'I', all of the box in sight: upright, and
/// from above and below as slices are shown, the front up. Other letters, and no box: nothing.
void LookFromSide(vtkRenderer* renderer, const vtkBoundingBox& box, char side);
/// As it looks, but all of the box in sight.
void LookAtAll(vtkRenderer* renderer, const vtkBoundingBox& box);
/// What a pixel of the render window shows (from the lower left), from the near plane to the far
/// one.
void RayOfPixel(vtkRenderer* renderer, int x, int y, double from[3], double to[3]);

} // namespace hasp
