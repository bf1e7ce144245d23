#pragma once
#include "View/SceneView.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkConeSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"

namespace hasp::testing
{

constexpr double Absurd = 1e6; ///< frames a second

/// A cone about the origin, its tip along x, and all of it in sight.
inline vtkSmartPointer<vtkActor> AddCone(SceneView& view)
{
  vtkNew<vtkConeSource> cone;
  cone->SetHeight(60.0);
  cone->SetRadius(25.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cone->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  view.Renderer()->AddActor(actor);
  view.ResetView();
  return actor;
}

/// From the front, upright, 300 mm from the origin.
inline void LookFromTheFront(SceneView& view)
{
  vtkCamera* camera = view.Renderer()->GetActiveCamera();
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(0, -300, 0);
  camera->SetViewUp(0, 0, 1);
}

} // namespace hasp::testing
