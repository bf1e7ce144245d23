#include "CertificatePictures.h"

#include "BoneAround.h"
#include "InnerWall.h"
#include "PictureFile.h"
#include "Session.h"
#include "SurfaceActors.h"
#include "VtkMessages.h"
#include "Windows.h"
#include "vtkHaspVolumeView.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkCoordinate.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkUnsignedCharArray.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{
namespace
{

constexpr int Width = 640, Height = 480;
constexpr double MarkShare = 0.02;      // of the part's size: the radius of a fault's ball
constexpr std::size_t MostNumbers = 30; // of faults that have theirs beside them
constexpr double LeastAroundMm = 20.0;  // of bone beside the part; of large parts their radius
constexpr int MostFrames = 50;          // of a picture, until its bone is whole

/// Where the viewer stands, as seen from the part: unit vectors.
struct Axes
{
  glm::dvec3 off, up, across; ///< off the bone, upwards in pictures, to the right
};

Axes AxesOf(const glm::dvec3& off)
{
  const glm::dvec3 head = std::abs(off.z) < 0.95 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, -1, 0);
  const glm::dvec3 across = glm::normalize(glm::cross(head, off));
  return { off, glm::cross(off, across), across };
}

vtkSmartPointer<vtkActor> ActorOf(vtkPolyData* mesh, bool coloured)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->SetScalarVisibility(coloured);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  return actor.Get();
}

/// One window for all pictures: what they show stands in the first renderer, marks in the second.
class Sketch
{
public:
  Sketch(const TriangleMesh& part, const FitCertificate& certificate)
    : Middle(0.5 * (certificate.low + certificate.high)),
      Radius(std::max(0.5 * glm::length(certificate.high - certificate.low), 1.0))
  {
    ChooseWindows();
    this->Window = vtkSmartPointer<vtkRenderWindow>::New();
    this->Window->SetOffScreenRendering(true);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(Width, Height);
    this->Window->SetNumberOfLayers(2);
    this->Marks->SetLayer(1);
    this->Marks->SetActiveCamera(this->Scene->GetActiveCamera());
    this->Scene->SetBackground(0.10, 0.11, 0.13);
    this->Window->AddRenderer(this->Scene);
    this->Window->AddRenderer(this->Marks);
    RequireOpenGL(this->Window);
    this->Part = MakePolyData(part);
    for (std::size_t n = 0; n < certificate.faults.size(); ++n)
      if (certificate.faults[n].at)
        this->Mark(*certificate.faults[n].at, n + 1);
  }

  double PartRadius() const { return this->Radius; }
  vtkPolyData* PartMesh() { return this->Part; }
  void Show(vtkProp3D* prop) { this->Scene->AddViewProp(prop); }
  void Hide(vtkProp3D* prop) { this->Scene->RemoveViewProp(prop); }

  /// `to` the viewer from the part; `share` of the picture's height that the part's ball fills.
  std::string Draw(
    const glm::dvec3& to, const glm::dvec3& up, double share, const std::function<bool()>& refining)
  {
    vtkCamera* camera = this->Scene->GetActiveCamera();
    const double half = 0.5 * camera->GetViewAngle() * 3.14159265358979 / 180.0;
    const glm::dvec3 at = this->Middle + this->Radius / (share * std::sin(half)) * to;
    camera->SetFocalPoint(this->Middle.x, this->Middle.y, this->Middle.z);
    camera->SetPosition(at.x, at.y, at.z);
    camera->SetViewUp(up.x, up.y, up.z);
    this->Scene->ResetCameraClippingRange();
    for (int frame = 0; frame == 0 || (refining && refining() && frame < MostFrames); ++frame)
      this->Window->Render();
    ThrowVtkError(ExitCode::CannotDraw, "cannot draw");
    return PngFile(WindowPicture(this->Window));
  }

private:
  void Mark(const glm::dvec3& at, std::size_t number)
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(at.x, at.y, at.z);
    ball->SetRadius(MarkShare * this->Radius);
    ball->SetThetaResolution(24);
    ball->SetPhiResolution(16);
    ball->Update();
    const auto actor = ActorOf(ball->GetOutput(), false);
    actor->GetProperty()->SetColor(1.0, 0.15, 0.15);
    actor->GetProperty()->SetAmbient(0.5);
    this->Marks->AddViewProp(actor);
    if (number > MostNumbers)
      return;
    vtkNew<vtkTextActor> text;
    text->SetInput(std::to_string(number).c_str());
    text->GetTextProperty()->SetFontSize(22);
    text->GetTextProperty()->BoldOn();
    text->GetTextProperty()->SetColor(1.0, 0.85, 0.3);
    text->GetTextProperty()->ShadowOn();
    text->GetPositionCoordinate()->SetCoordinateSystemToWorld();
    text->SetPosition(at.x, at.y);
    text->GetPositionCoordinate()->SetValue(at.x, at.y, at.z);
    this->Marks->AddViewProp(text);
  }

  glm::dvec3 Middle;
  double Radius;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Scene, Marks;
  vtkSmartPointer<vtkPolyData> Part;
};

void DrawOnBone(Sketch& sketch, const Axes& axes, vtkImageData* bone, const FitCertificate& c,
  Session& session, std::vector<CertificatePicture>& pictures)
{
  SurfaceDrawing drawing;
  const auto around =
    BoneAround(bone, c.claims, c.low, c.high, std::max(LeastAroundMm, sketch.PartRadius()));
  const SurfaceActor surface = MakeIsosurface(around, c.claims.isovalue, drawing, session);
  vtkActor::SafeDownCast(surface.prop)->GetProperty()->SetColor(0.93, 0.87, 0.76);
  vtkNew<vtkPolyDataNormals> normals; // edges stay sharp from 30 degrees
  normals->SetInputData(sketch.PartMesh());
  normals->SetFeatureAngle(30.0);
  normals->ConsistencyOff();
  normals->Update();
  const auto part = ActorOf(normals->GetOutput(), false);
  part->GetProperty()->SetColor(0.35, 0.62, 0.85);
  sketch.Show(surface.prop);
  sketch.Show(part);
  const auto from = [&](double along, double right, double up)
  { return glm::normalize(along * axes.off + right * axes.across + up * axes.up); };
  const std::tuple<const char*, glm::dvec3, glm::dvec3> views[] = {
    { "On the bone, along the direction it lifts off.", from(1, 0, 0), axes.up },
    { "From the right of that.", from(0.5, 0.87, 0), axes.up },
    { "From above that.", from(0.5, 0, 0.87), axes.off },
  };
  for (const auto& [caption, to, up] : views)
    pictures.push_back({ caption, sketch.Draw(to, up, 0.75, surface.refining), false });
  sketch.Hide(surface.prop);
  sketch.Hide(part);
}

void DrawInnerWall(Sketch& sketch, const Axes& axes, const std::vector<Colour>& colours,
  std::vector<CertificatePicture>& pictures)
{
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName("gap");
  array->SetNumberOfComponents(3);
  for (const Colour& colour : colours)
    array->InsertNextTypedTuple(colour.data());
  vtkNew<vtkPolyData> mesh;
  mesh->ShallowCopy(sketch.PartMesh());
  mesh->GetCellData()->SetScalars(array);
  const auto actor = ActorOf(mesh, true);
  actor->GetProperty()->SetInterpolationToFlat();
  actor->GetProperty()->SetAmbient(0.55);
  actor->GetProperty()->SetDiffuse(0.45);
  sketch.Show(actor);
  pictures.push_back(
    { "The inner wall as the bone has it, coloured by its gap; what does not face bone is grey.",
      sketch.Draw(-axes.off, axes.up, 0.95, {}), true });
}

} // namespace

std::vector<CertificatePicture> DrawCertificate(
  const TriangleMesh& part, vtkImageData* bone, const FitCertificate& certificate, Session& session)
{
  session.progress.Step("drawing the certificate");
  Sketch sketch(part, certificate);
  const PartClaims& claims = certificate.claims;
  std::vector<Colour> colours;
  glm::dvec3 off = claims.withdrawal.value_or(glm::dvec3(0, -1, 0));
  if (claims.shell)
  {
    const InnerWall wall = FindInnerWall(part, ViewImage(bone), claims);
    colours = wall.colours;
    if (!claims.withdrawal && glm::length(wall.away) > 0.0)
      off = wall.away;
  }
  const Axes axes = AxesOf(glm::normalize(off));
  std::vector<CertificatePicture> pictures;
  DrawOnBone(sketch, axes, bone, certificate, session, pictures);
  if (claims.shell)
    DrawInnerWall(sketch, axes, colours, pictures);
  return pictures;
}

} // namespace hasp
