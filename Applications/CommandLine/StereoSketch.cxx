#include "StereoSketch.h"

#include "PictureFile.h"
#include "ScreenFrame.h"
#include "VtkMessages.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCoordinate.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace hasp
{
namespace
{

using Color = std::array<double, 3>;
constexpr Color Ink{ 0.1, 0.1, 0.1 }, LeftColor{ 0.80, 0.15, 0.10 }, RightColor{ 0.05, 0.35, 0.75 },
  ContentColor{ 0.15, 0.50, 0.20 };
constexpr int Width = 1200, Height = 720;
constexpr double TextShare = 0.2; ///< of the height, for the figures

/// One of the two drawings: a plane to draw lines in, in millimetres.
class Plan
{
public:
  explicit Plan(vtkRenderer* renderer) : Renderer(renderer) {}

  void Line(const std::vector<glm::dvec2>& way, const Color& color, float width)
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell(static_cast<int>(way.size()));
    for (const glm::dvec2& p : way)
    {
      lines->InsertCellPoint(points->InsertNextPoint(p.x, p.y, 0.0));
      this->Include(p);
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetLines(lines);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(color[0], color[1], color[2]);
    actor->GetProperty()->SetLineWidth(width);
    actor->GetProperty()->LightingOff();
    this->Renderer->AddActor(actor);
  }
  /// Shows it, whether something is there or not.
  void Include(const glm::dvec2& p)
  {
    this->Low = glm::min(this->Low, p);
    this->High = glm::max(this->High, p);
  }
  void Ring(const glm::dvec2& center, double radius, const Color& color)
  {
    std::vector<glm::dvec2> way;
    for (int n = 0; n <= 32; ++n)
    {
      const double angle = n * 2.0 * std::numbers::pi / 32.0;
      way.push_back(center + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    this->Line(way, color, 3.0F);
  }
  void Label(const glm::dvec2& at, const char* text, const Color& color)
  {
    vtkNew<vtkTextActor> label;
    label->SetInput(text);
    label->GetTextProperty()->SetFontSize(15);
    label->GetTextProperty()->SetColor(color[0], color[1], color[2]);
    label->GetPositionCoordinate()->SetCoordinateSystemToWorld();
    label->GetPositionCoordinate()->SetValue(at.x, at.y, 0.0);
    this->Renderer->AddActor2D(label);
  }
  /// A margin around all that was drawn; the same millimetres a pixel in both drawings.
  static void Fit(Plan& one, Plan& other)
  {
    constexpr double aspect = 0.5 * Width / (Height * (1.0 - TextShare));
    double height = 0.0;
    for (const Plan* plan : { &one, &other })
    {
      const glm::dvec2 size = plan->High - plan->Low;
      height = std::max({ height, size.y, size.x / aspect });
    }
    for (Plan* plan : { &one, &other })
    {
      const glm::dvec2 middle = 0.5 * (plan->Low + plan->High);
      vtkCamera* camera = plan->Renderer->GetActiveCamera();
      camera->ParallelProjectionOn();
      camera->SetParallelScale(0.5 * height * 1.15);
      camera->SetPosition(middle.x, middle.y, 1.0);
      camera->SetFocalPoint(middle.x, middle.y, 0.0);
      camera->SetClippingRange(0.1, 2.0);
    }
  }

private:
  vtkRenderer* Renderer;
  glm::dvec2 Low{ 1e30 }, High{ -1e30 };
};

/// Which of the room's axes a drawing shows, and which half of the screen's size.
struct Side
{
  glm::dvec2 (*of)(const glm::dvec3& p);
  glm::dvec3 edge;
  const char* name;
};

void Draw(Plan& plan, const Side& side, const StereoSketch& sketch)
{
  const ScreenFrame frame(sketch.rig.screen);
  const auto flat = [&](const glm::dvec3& p) { return side.of(p); };
  const glm::dvec2 first = flat(-side.edge), last = flat(side.edge);
  if (sketch.content)
    for (int corner = 0; corner < 8; ++corner)
      for (int axis = 0; axis < 3; ++axis)
        if (!(corner >> axis & 1))
          plan.Line({ flat(frame.Of((*sketch.content)[corner])),
                      flat(frame.Of((*sketch.content)[corner | 1 << axis])) },
            ContentColor, 2.0F);
  const std::vector<SketchedEye> eyes = EyesOf(sketch);
  for (const SketchedEye& eye : eyes)
  {
    const Color& color = eye.which == SketchedEye::Left    ? LeftColor
                         : eye.which == SketchedEye::Right ? RightColor
                                                           : Ink;
    const glm::dvec2 at = flat(frame.Of(eye.position));
    plan.Line({ first, at, last }, color, 1.5F);
    plan.Ring(at, 0.015 * sketch.rig.screen.widthMm, color);
  }
  plan.Line({ first, last }, Ink, 6.0F);
  plan.Label(last, "screen", Ink);
  const glm::dvec3 beside(0.12 * sketch.rig.screen.widthMm, 0.04 * sketch.rig.screen.widthMm, 0.0);
  plan.Label(
    flat(frame.Of(sketch.rig.head.position) + beside), eyes.size() == 1 ? "eye" : "eyes", Ink);
  if (sketch.content)
    plan.Label(flat(frame.Of((*sketch.content)[7])), sketch.contentIsVolume ? "volume" : "content",
      ContentColor);
  plan.Include(first - 0.1 * (last - first)); // labels need room
  plan.Include(last + 0.1 * (last - first));
}

vtkSmartPointer<vtkTextActor> TextUnder(const std::string& text)
{
  auto actor = vtkSmartPointer<vtkTextActor>::New();
  actor->SetInput(text.c_str());
  actor->GetTextProperty()->SetFontSize(17);
  actor->GetTextProperty()->SetColor(Ink[0], Ink[1], Ink[2]);
  actor->SetPosition(20, 12);
  return actor;
}

} // namespace

vtkSmartPointer<vtkImageData> DrawStereoSketch(const StereoSketch& sketch)
{
  const std::string text = StereoSketchText(sketch);
  const StereoScreen& screen = sketch.rig.screen;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(0);
  window->SetSize(Width, Height);
  const Side sides[2] = {
    { [](const glm::dvec3& p) { return glm::dvec2(p.x, -p.z); }, { 0.5 * screen.widthMm, 0, 0 },
      "from above" },
    { [](const glm::dvec3& p) { return glm::dvec2(p.z, p.y); }, { 0, 0.5 * screen.heightMm, 0 },
      "from the viewer's left" },
  };
  std::vector<Plan> plans;
  for (int n = 0; n < 2; ++n)
  {
    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(1, 1, 1);
    renderer->SetViewport(0.5 * n, TextShare, 0.5 * (n + 1), 1.0);
    window->AddRenderer(renderer);
    const auto name = TextUnder(sides[n].name);
    name->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
    name->SetPosition(0.03, 0.94);
    renderer->AddActor2D(name);
    Draw(plans.emplace_back(renderer), sides[n], sketch);
  }
  Plan::Fit(plans[0], plans[1]);
  vtkNew<vtkRenderer> under;
  under->SetBackground(1, 1, 1);
  under->SetViewport(0, 0, 1, TextShare);
  window->AddRenderer(under);
  under->AddActor2D(TextUnder(text));
  window->Render();
  ThrowVtkError(ExitCode::CannotDraw, "cannot draw the sketch");
  auto picture = WindowPicture(window);
  ThrowVtkError(ExitCode::CannotDraw, "cannot draw the sketch");
  return picture;
}

} // namespace hasp
