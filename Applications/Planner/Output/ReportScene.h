#pragma once
#include "Planning/Osteotomy.h"
#include "Planning/PlanPose.h"

#include "vtkBoundingBox.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <QByteArray>
#include <QString>

#include <glm/vec3.hpp>

class vtkPolyData;
class vtkRenderWindow;
class vtkRenderer;

namespace hasp
{

/// A window that nobody sees, for the pictures of a report. Internal to CaseReport. RENDER.
class ReportScene
{
public:
  ReportScene();
  ~ReportScene();

  bool CanDraw() const; ///< there is OpenGL 3.2 or later
  /// "vendor, renderer, OpenGL version".
  QString Renderer() const;

  void Add(
    vtkPolyData* mesh, const PlanPose& place, const glm::dvec3& colour, double opacity = 1.0);
  void AddBlade(const Osteotomy& blade, const glm::dvec3& colour, double opacity);
  void Clear();
  bool IsEmpty() const { return !this->Box.IsValid(); }

  /// A PNG file of all that was added, from the patient's side 'A', 'L', 'R' or 'S'.
  QByteArray Draw(char side);

private:
  void Fill();

  vtkSmartPointer<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Bodies;
  vtkBoundingBox Box; ///< around all
};

} // namespace hasp
