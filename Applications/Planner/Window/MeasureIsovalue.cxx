#include "Window/MeasureIsovalue.h"

#include "Window/MeasureScenes.h"
#include "Window/MeasureWindow.h"
#include "Window/PlannerWindow.h"

#include "vtkActor.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace hasp
{
namespace
{
using Json = nlohmann::ordered_json;
constexpr double LowIso = 226.0, HighIso = 400.0;
constexpr int WarmUps = 2;

/// A picture, and how long it took.
struct Timed
{
  double ms = 0.0;
  QImage picture;
};

/// VTK's way in the same view: a mesh anew, and its picture.
class MeshRival
{
public:
  explicit MeshRival(Planner& planner) : Of(planner)
  {
    this->Edges->SetInputData(planner.scene.ShownImage());
    this->Edges->ComputeNormalsOn();
    this->Edges->ComputeScalarsOff();
    this->Mapper->SetInputConnection(this->Edges->GetOutputPort());
    this->Mapper->ScalarVisibilityOff();
    this->Actor->SetMapper(this->Mapper);
  }
  Timed Show(double isovalue)
  {
    SceneView& view = this->Of.views.Scene();
    const PlanId volume = this->Of.scene.ShownVolume();
    if (auto* scan = vtkActor::SafeDownCast(this->Of.scene.ScanProp()))
      this->Actor->SetProperty(scan->GetProperty()); // the same bone
    this->Of.scene.SetVisible(volume, false);
    view.Renderer()->AddActor(this->Actor);
    this->Edges->SetValue(0, isovalue);
    const double ms = DrawnMs(view);
    Timed shown{ ms, view.grabFramebuffer() };
    view.Renderer()->RemoveActor(this->Actor);
    this->Of.scene.SetVisible(volume, true);
    return shown;
  }

private:
  Planner& Of;
  vtkNew<vtkFlyingEdges3D> Edges;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Actor;
};

/// As a slider that is held sets it.
Timed Move(Planner& parts, double isovalue)
{
  SceneView& view = parts.views.Scene();
  const auto start = Clock::now();
  parts.scene.SetIsovalue(isovalue, true);
  WaitFrame(view);
  const double ms = MsSince(start);
  return { ms, view.grabFramebuffer() };
}

/// Root mean square over pairs.
class Errors
{
public:
  void Add(double rms) { this->Squares += rms * rms, ++this->Count; }
  double Rms() const { return std::sqrt(this->Squares / this->Count); }

private:
  double Squares = 0.0;
  int Count = 0;
};
} // namespace

Json MeasureIsovalue(PlannerWindow& window, int size, int pairs)
{
  ShowPhantom(window, size);
  Planner& parts = window.Parts();
  MeshRival rival(parts);
  Json ours = Json::array(), theirs = Json::array();
  Errors oursOff, theirsOff, changed;
  QImage before;
  for (int pair = -WarmUps; pair < pairs; ++pair)
  {
    const double isovalue = LowIso + (HighIso - LowIso) * (pair + WarmUps) / (pairs + WarmUps);
    const Timed moving = Move(parts, isovalue);
    parts.scene.SetIsovalue(isovalue, false);
    WaitSettled(window);
    const QImage settled = parts.views.Scene().grabFramebuffer();
    const Timed mesh = rival.Show(isovalue);
    WaitSettled(window);
    if (pair >= 0)
    {
      ours.push_back(moving.ms);
      theirs.push_back(mesh.ms);
      oursOff.Add(RmsBetween(moving.picture, settled));
      theirsOff.Add(RmsBetween(mesh.picture, settled));
      changed.Add(RmsBetween(before, settled));
    }
    before = settled;
  }
  return { { "size", size }, { "ours_ms", ours }, { "rival_ms", theirs },
    { "rms_255", oursOff.Rms() }, { "rival_rms_255", theirsOff.Rms() },
    { "changed_255", changed.Rms() } };
}

} // namespace hasp
