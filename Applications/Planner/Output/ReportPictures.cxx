#include "Output/ReportPictures.h"

#include "Output/ReportScene.h"
#include "Output/ScanWorlds.h"
#include "Planning/PlanLists.h"

#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <array>
#include <utility>

namespace hasp
{
namespace
{

const glm::dvec3 GuideColour{ 0.10, 0.45, 0.75 }, PlateColour{ 0.45, 0.48, 0.52 },
  ImplantColour{ 0.90, 0.62, 0.00 }, TransplantColour{ 0.00, 0.62, 0.45 },
  BladeColour{ 0.95, 0.45, 0.05 }, ResectedColour{ 0.85, 0.15, 0.15 },
  BoneColour{ 0.89, 0.85, 0.79 };
constexpr double BladeOpacity = 0.25, ResectedOpacity = 0.45;

glm::dvec3 ColourOf(const PlanFragment& fragment)
{
  return { fragment.colour[0] / 255.0, fragment.colour[1] / 255.0, fragment.colour[2] / 255.0 };
}

template <typename T>
void AddParts(ReportScene& scene, const std::vector<T>& objects, const ReportBodies& bodies,
  const glm::dvec3& colour)
{
  for (const T& object : objects)
    if (const auto part = bodies.parts.find(object.id); part != bodies.parts.end())
      scene.Add(part->second, {}, colour);
}

/// All bone of a scan of which there are no fragments.
void AddScan(ReportScene& scene, const ScanWorld& world, const ReportBodies& bodies)
{
  if (const auto scan = bodies.scans.find(world.volume); scan != bodies.scans.end())
    scene.Add(scan->second, {}, BoneColour);
}

bool HasBefore(const Plan& plan)
{
  return !plan.cuts.empty() || !plan.guides.empty() || !plan.mitreGuides.empty();
}

/// As scanned: all bone, blades, and what is put on there.
void AddBefore(ReportScene& scene, const ScanWorld& world, const ReportBodies& bodies)
{
  const Plan& plan = world.plan;
  AddScan(scene, world, bodies);
  for (const PlanFragment& fragment : plan.fragments)
    if (const auto body = bodies.fragments.find(fragment.id); body != bodies.fragments.end())
    {
      const bool resected = fragment.state == FragmentState::Resected;
      scene.Add(body->second, {}, resected ? ResectedColour : ColourOf(fragment),
        resected ? ResectedOpacity : 1.0);
    }
  for (const PlanCut& cut : plan.cuts)
    scene.AddBlade(cut.blade, BladeColour, BladeOpacity);
  AddParts(scene, plan.guides, bodies, GuideColour);
  AddParts(scene, plan.mitreGuides, bodies, GuideColour);
}

/// As planned: bone that is kept, where it goes, and what stays in the patient.
void AddAfter(ReportScene& scene, const ScanWorld& world, const ReportBodies& bodies)
{
  const Plan& plan = world.plan;
  for (const PlanFragment& fragment : plan.fragments)
    if (const auto body = bodies.fragments.find(fragment.id);
        body != bodies.fragments.end() && fragment.state == FragmentState::Kept)
      scene.Add(body->second, fragment.scanToPlanned, ColourOf(fragment));
  AddScan(scene, world, bodies);
  AddParts(scene, plan.plates, bodies, PlateColour);
  AddParts(scene, plan.implants, bodies, ImplantColour);
  AddParts(scene, plan.transplants, bodies, TransplantColour);
}

void Draw(ReportScene& scene, const QString& caption, std::vector<ReportPicture>& pictures)
{
  const std::array sides{ std::pair('A', ReportText::tr("from the front")),
    std::pair('L', ReportText::tr("from the patient's left")),
    std::pair('R', ReportText::tr("from the patient's right")),
    std::pair('S', ReportText::tr("from above")) };
  if (!scene.IsEmpty())
    for (const auto& [side, from] : sides)
      pictures.push_back({ caption.arg(from), scene.Draw(side) });
  scene.Clear();
}

/// Which scan it is, before where it is seen from: where there are several.
QString Captioned(const QString& text, const Plan& plan, const ScanWorld& world)
{
  if (plan.volumes.size() < 2)
    return text;
  const QString scan = QString::fromStdString(CalledObject(plan, world.volume));
  return text.arg((world.isDonor ? ReportText::tr("%1, the donor's").arg(scan) : scan) + ", %1");
}

} // namespace

vtkSmartPointer<vtkPolyData> BoneSurface(vtkImageData* image, double isovalue)
{
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(image);
  edges->SetValue(0, isovalue);
  edges->ComputeNormalsOn();
  edges->ComputeGradientsOff();
  edges->ComputeScalarsOff();
  edges->Update();
  return edges->GetOutput();
}

std::optional<glm::dvec3> MiddleOf(vtkPolyData* surface)
{
  if (surface->GetNumberOfPoints() == 0)
    return std::nullopt;
  double middle[3];
  surface->GetCenter(middle);
  return glm::dvec3(middle[0], middle[1], middle[2]);
}

ReportDrawing DrawReport(const Plan& plan, const ReportBodies& bodies)
{
  ReportDrawing drawing;
  ReportScene scene;
  if (!scene.CanDraw())
    return drawing;
  drawing.renderer = scene.Renderer();
  for (const ScanWorld& world : WorldsOf(plan))
  {
    const bool hasBefore = HasBefore(world.plan);
    if (hasBefore)
    {
      AddBefore(scene, world, bodies);
      Draw(scene,
        Captioned(
          ReportText::tr("Cuts and guides on the bone as it was scanned, %1."), plan, world),
        drawing.pictures);
    }
    if (hasBefore && world.isDonor) // nothing is planned where segments are taken
      continue;
    AddAfter(scene, world, bodies);
    Draw(scene, Captioned(ReportText::tr("As planned, %1."), plan, world), drawing.pictures);
  }
  return drawing;
}

} // namespace hasp
