#pragma once
#include "vtkSmartPointer.h"

class vtkImageData;

namespace hasp
{

struct Session;

/// A copy of the volume without its connected pieces (samples >= isovalue, 26 neighbours) smaller
/// than leastMm3: specks, head-rests. Their samples become the largest value below the isovalue; no
/// cell of a piece that stays holds one of them, so what stays keeps its exact surface. None if no
/// piece is that large. O(samples), and a copy of the volume.
vtkSmartPointer<vtkImageData> LargePiecesOf(vtkImageData* image, double isovalue, double leastMm3);

/// The same for --ignore-below, listed among the resources. Throws Failure: BadInput if no piece is
/// that large.
vtkSmartPointer<vtkImageData> WithoutSmallPieces(
  vtkImageData* image, double isovalue, double leastMm3, Session& session);

} // namespace hasp
