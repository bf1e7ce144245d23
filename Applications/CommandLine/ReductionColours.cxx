#include "ReductionColours.h"

#include "MeasuredRows.h"
#include "ReportRegistry.h"
#include "vtkHaspSurfaceDistance.h"

#include "vtkDataArray.h"
#include "vtkImplicitPolyDataDistance.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkVersion.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace hasp
{
namespace
{

constexpr double ReferenceMm = 20.0, SurfaceMm = 19.0;
constexpr double BarMs = 50.0;
constexpr vtkIdType RivalPoints = 2000; // it takes microseconds a place

vtkNew<vtkSphereSource> Ball(double radius, int around, int down)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(radius);
  ball->SetThetaResolution(around);
  ball->SetPhiResolution(down);
  ball->Update();
  return ball;
}

/// A fragment in hand: some millimetres and turns, never the same.
void MoveTo(vtkMatrix4x4* pose, int n)
{
  const double turn = 0.07 * n, cosine = std::cos(turn), sine = std::sin(turn);
  pose->Identity();
  pose->SetElement(0, 0, cosine);
  pose->SetElement(0, 1, -sine);
  pose->SetElement(1, 0, sine);
  pose->SetElement(1, 1, cosine);
  for (int axis = 0; axis < 3; ++axis)
    pose->SetElement(axis, 3, 2.0 * std::sin(0.3 * n + axis));
}

double ToReference(vtkMatrix4x4* pose, const double* place)
{
  double p[4] = { place[0], place[1], place[2], 1.0 };
  pose->MultiplyPoint(p, p);
  return std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) - ReferenceMm;
}

/// Squares and the largest of what is off.
struct Errors
{
  double squares = 0.0, most = 0.0;
  std::size_t count = 0;

  void Add(double error)
  {
    this->squares += error * error;
    this->most = std::max(this->most, std::abs(error));
    ++this->count;
  }
  double Rms() const { return std::sqrt(this->squares / double(std::max<std::size_t>(1, count))); }
};

/// The surface before the reference, in one pose after the other.
class Colours
{
public:
  Colours() : Surface(Ball(SurfaceMm, 450, 448)), Reference(Ball(ReferenceMm, 400, 400))
  {
    this->Filter->SetInputConnection(this->Surface->GetOutputPort());
    this->Filter->SetReferenceConnection(this->Reference->GetOutputPort());
    this->Filter->SetSurfaceToReference(this->Pose);
    this->Rival->SetInput(this->Reference->GetOutput());
    this->Next(); // the reference is sampled once
    this->ByRival();
  }

  Timing Next()
  {
    MoveTo(this->Pose, ++this->Number);
    return TimeOf([&] { this->Filter->Update(); });
  }
  /// The rival's, of a few places of the same surface in the same pose.
  Timing ByRival()
  {
    vtkPolyData* surface = this->Surface->GetOutput();
    const vtkIdType step = this->Points() / RivalPoints;
    this->Found.clear();
    return TimeOf(
      [&]
      {
        for (vtkIdType n = 0; n < RivalPoints; ++n)
        {
          double p[4] = { 0, 0, 0, 1 };
          surface->GetPoint(n * step, p);
          this->Pose->MultiplyPoint(p, p);
          this->Found.push_back(this->Rival->EvaluateFunction(p));
        }
      });
  }
  void AddErrors(Errors& ours) const
  {
    vtkPolyData* found = this->Filter->GetOutput();
    vtkDataArray* distances = found->GetPointData()->GetScalars();
    for (vtkIdType n = 0; n < found->GetNumberOfPoints(); ++n)
      ours.Add(distances->GetComponent(n, 0) - ToReference(this->Pose, found->GetPoint(n)));
  }
  void AddRivalErrors(Errors& theirs) const
  {
    const vtkIdType step = this->Points() / RivalPoints;
    for (std::size_t n = 0; n < this->Found.size(); ++n)
      theirs.Add(this->Found[n] - ToReference(this->Pose,
                                    this->Surface->GetOutput()->GetPoint(vtkIdType(n) * step)));
  }
  vtkIdType Points() const { return this->Surface->GetOutput()->GetNumberOfPoints(); }
  int Samplings() const { return this->Filter->GetSamplings(); }

private:
  vtkNew<vtkSphereSource> Surface, Reference;
  vtkNew<vtkHaspSurfaceDistance> Filter;
  vtkNew<vtkMatrix4x4> Pose;
  vtkNew<vtkImplicitPolyDataDistance> Rival;
  std::vector<double> Found;
  int Number = 0;
};

Timing Of(const Timing& all, double places)
{
  return { all.wallS / places, all.cpuS / places };
}

void AddRival(ReportContext& context, Colours& colours, const std::string& data)
{
  Errors ours, theirs;
  // Each a place: so many of ours, and as many as the rival can be waited for.
  const PairedTimes times =
    ComparePairs([&] { return Of(colours.Next(), double(colours.Points())); },
      [&] { return Of(colours.ByRival(), double(RivalPoints)); });
  colours.AddErrors(ours);
  colours.AddRivalErrors(theirs);
  char text[200];
  std::snprintf(text, sizeof text,
    "VTK %s vtkImplicitPolyDataDistance to the reference's triangles, %d of the places; %.2g us "
    "and %.2g mm rms a place",
    vtkVersion::GetVTKVersion(), int(RivalPoints), 1e6 * times.b.wallS, theirs.Rms());
  context.report.rows.push_back(TimedRatio("reduction.colours.speed", times, text,
    { ours.Rms(), "mm, rms" }, "time a place: " + data, true));
}

} // namespace

void TryColours(ReportContext& context)
{
  context.progress(0.0, "reduction: colours that follow");
  Colours colours;
  const int poses = context.settings.quick ? 20 : 100;
  std::vector<double> cpuMs, wallS;
  Errors errors;
  for (int n = 0; n < poses; ++n)
  {
    const Timing time = colours.Next();
    cpuMs.push_back(1e3 * time.cpuS);
    wallS.push_back(time.wallS);
    colours.AddErrors(errors);
  }
  const std::string data =
    std::to_string(colours.Points()) + " places of a ball of 19 mm before one of 20 mm, " +
    std::to_string(poses) + " poses, " + std::to_string(colours.Samplings()) + " time sampled";
  const Quartiles ms = QuartilesOf(cpuMs);
  ReportRow row;
  row.id = "reduction.colours.ms";
  row.value = ms.median;
  row.unit = "ms of CPU time";
  row.rival = "what an eye waits for; distances in closed form";
  row.error = errors.Rms();
  row.errorUnit = "mm, rms";
  row.timeS = QuartilesOf(wallS).median;
  row.cpuS = 1e-3 * ms.median;
  row.q1 = ms.q1;
  row.q3 = ms.q3;
  row.n = poses;
  row.data = data + "; aim 20 ms";
  row.bars = { { {}, BarMs } };
  context.report.rows.push_back(row);
  const Timing one{ *row.timeS, *row.cpuS };
  for (const auto& [id, figure] : { std::pair("reduction.colours.rms", errors.Rms()),
         std::pair("reduction.colours.max", errors.most) })
    context.report.rows.push_back(
      ErrorFigure(id, { figure, "mm" }, "the closed form of two balls", one, data));
  AddRival(context, colours, data);
}

} // namespace hasp
