// The four views of the phantom as a picture, without what Qt writes over them: fonts differ.
#include "ViewsDesk.h"

#include "Grid/Phantom.h"
#include "HaspRenderTest.h"
#include "TestScreen.h"
#include "vtkHaspVolumeView.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

#include <QApplication>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace
{

using namespace hasp;
using namespace hasp::testing;

const glm::dvec3 Cross(-30.0, -40.0, 10.0);

/// Bone, in halves.
vtkSmartPointer<vtkImageData> HalvesOf(vtkImageData* image, int width)
{
  auto labels = vtkSmartPointer<vtkImageData>::New();
  labels->CopyStructure(image);
  labels->AllocateScalars(VTK_UNSIGNED_SHORT, 1);
  const auto* grey = static_cast<const short*>(image->GetScalarPointer());
  auto* label = static_cast<unsigned short*>(labels->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    label[i] = grey[i] < 300 ? 0 : i % width < width / 2 ? 1 : 2;
  return labels;
}

SliceContour BallAtTheCross()
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(25.0);
  ball->SetThetaResolution(60);
  ball->SetPhiResolution(60);
  ball->Update();
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int axis = 0; axis < 3; ++axis)
    matrix->SetElement(axis, 3, Cross[axis] + 5.0);
  return { ball->GetOutput(), matrix, { 1, 1, 0 }, 2.0 };
}

void Place(RGBPicture& picture, const QImage& view, int left, int top)
{
  for (int y = 0; y < view.height(); ++y)
    for (int x = 0; x < view.width(); ++x)
    {
      const QRgb pixel = view.pixel(x, y);
      std::uint8_t* to = picture.At(left + x, picture.height - 1 - top - y);
      to[0] = qRed(pixel);
      to[1] = qGreen(pixel);
      to[2] = qBlue(pixel);
    }
}

int Judge(int argc, char* argv[])
{
  const GridGeometry grid = PhantomGrid(glm::dvec3(1.5));
  const auto image = MakeImage(grid, SamplePhantom(grid));
  ViewsDesk desk(image);
  vtkNew<vtkFlyingEdges3D> bone;
  bone->SetInputData(image);
  bone->SetValue(0, 300.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(bone->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.93, 0.88, 0.78);
  desk.scene.Renderer()->AddActor(actor);
  desk.scene.Renderer()->GetActiveCamera()->SetPosition(-200, -600, 100);
  desk.scene.Renderer()->GetActiveCamera()->SetViewUp(0, 0, 1);
  desk.scene.ResetView();
  desk.grid.SetLabels(
    HalvesOf(image, grid.dims.x), { { 1, { 1, 0.3, 0.2 } }, { 2, { 0.2, 0.6, 1 } } });
  desk.grid.SetContours({ BallAtTheCross() });
  desk.grid.SetIsovalueLine(300.0);
  desk.grid.SetCrosshair(Cross);
  desk.sagittal.SetShownInScene(true);

  const QSize size = desk.grid.size();
  RGBPicture picture(size.width(), size.height());
  for (FrameView* view :
    std::initializer_list<FrameView*>{ &desk.axial, &desk.scene, &desk.coronal, &desk.sagittal })
  {
    const QPoint corner = view->mapTo(&desk.grid, QPoint());
    Place(picture, Drawn(*view), corner.x(), corner.y());
  }
  return CheckPicture(picture, argc, argv);
}

} // namespace

int main(int argc, char* argv[])
{
  const TestScreen screen;
  if (screen.Display().empty())
  {
    std::printf("Xvfb is not installed: skipped\n");
    return EXIT_SUCCESS;
  }
  setenv("DISPLAY", screen.Display().c_str(), 1);
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication application(argc, argv);
  return Judge(argc, argv);
}
