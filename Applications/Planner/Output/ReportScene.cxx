#include "Output/ReportScene.h"

#include "View/SceneCamera.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCubeSource.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPNGWriter.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include <QStringList>

#include <algorithm>
#include <cmath>

namespace hasp
{
namespace
{

constexpr int Width = 800, Height = 600;
constexpr double Filled = 0.92; // of half a picture
constexpr int Peels = 8;        // of translucent layers, one behind the other

void SetAxes(vtkMatrix4x4* matrix, const glm::dmat3& axes, const glm::dvec3& origin)
{
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
      matrix->SetElement(row, column, axes[column][row]);
    matrix->SetElement(row, 3, origin[row]);
  }
}

/// "Mesa" of a line "OpenGL vendor string:  Mesa".
QString ValueOf(const QStringList& lines, const QString& key)
{
  for (const QString& line : lines)
    if (line.startsWith(key))
      return line.mid(key.size()).trimmed();
  return {};
}

} // namespace

ReportScene::ReportScene() : Window(vtkSmartPointer<vtkRenderWindow>::New())
{
  this->Window->SetOffScreenRendering(true);
  this->Window->SetMultiSamples(0);
  this->Window->SetAlphaBitPlanes(true);
  this->Window->SetSize(Width, Height);
  this->Window->AddRenderer(this->Bodies);
  this->Bodies->SetBackground(1.0, 1.0, 1.0);
  this->Bodies->SetUseDepthPeeling(true);
  this->Bodies->SetMaximumNumberOfPeels(Peels);
  if (auto* openGL = vtkOpenGLRenderWindow::SafeDownCast(this->Window))
    openGL->Initialize();
}

ReportScene::~ReportScene() = default;

bool ReportScene::CanDraw() const
{
  return this->Window->SupportsOpenGL() != 0;
}

QString ReportScene::Renderer() const
{
  const QStringList lines = QString::fromUtf8(this->Window->ReportCapabilities()).split('\n');
  return ValueOf(lines, "OpenGL vendor string:") + ", " +
         ValueOf(lines, "OpenGL renderer string:") + ", OpenGL " +
         ValueOf(lines, "OpenGL version string:");
}

void ReportScene::Add(
  vtkPolyData* mesh, const PlanPose& place, const glm::dvec3& colour, double opacity)
{
  if (mesh->GetNumberOfPoints() == 0)
    return;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkMatrix4x4> matrix;
  SetAxes(matrix, glm::mat3_cast(place.orientation), place.position);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetUserMatrix(matrix);
  actor->GetProperty()->SetColor(colour.x, colour.y, colour.z);
  actor->GetProperty()->SetOpacity(opacity);
  this->Bodies->AddActor(actor);
  this->Box.AddBounds(actor->GetBounds());
}

/// No part of the box: blades reach far beyond the bone.
void ReportScene::AddBlade(const Osteotomy& blade, const glm::dvec3& colour, double opacity)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(blade.widthMm);
  cube->SetYLength(blade.depthMm);
  cube->SetZLength(blade.kerfMm);
  cube->Update();
  const vtkBoundingBox bodies = this->Box;
  const glm::dmat3 axes(blade.along, glm::cross(blade.normal, blade.along), blade.normal);
  this->Add(cube->GetOutput(), { blade.point, glm::quat_cast(axes) }, colour, opacity);
  this->Box = bodies;
}

void ReportScene::Clear()
{
  this->Bodies->RemoveAllViewProps();
  this->Box.Reset();
}

/// From here the ball around the box is in sight; nearer, until the box itself fills the picture.
void ReportScene::Fill()
{
  double most = 0.0; // of its corners' places, the picture's edges being at 1
  for (int corner = 0; corner < 8; ++corner)
  {
    double at[3];
    this->Box.GetCorner(corner, at);
    this->Bodies->WorldToView(at[0], at[1], at[2]);
    most = std::max({ most, std::abs(at[0]), std::abs(at[1]) });
  }
  if (most > 0.0)
    this->Bodies->GetActiveCamera()->Zoom(Filled / most);
}

QByteArray ReportScene::Draw(char side)
{
  LookFromSide(this->Bodies, this->Box, side);
  this->Fill();
  this->Bodies->ResetCameraClippingRange();
  this->Window->Render();
  vtkNew<vtkWindowToImageFilter> read;
  read->SetInput(this->Window);
  read->SetInputBufferTypeToRGB();
  read->ReadFrontBufferOff();
  read->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(read->GetOutputPort());
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  return { reinterpret_cast<const char*>(bytes->GetPointer(0)),
    static_cast<int>(bytes->GetNumberOfValues()) };
}

} // namespace hasp
