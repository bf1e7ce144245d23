#include "vtkHaspTransplantFilter.h"

#include "RecipeFilter.h"
#include "TransplantBuilder.h"
#if HASP_WITH_JSON
#include "Planning/TransplantRecipeFile.h"
#endif

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkHaspVolumeView.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <glm/trigonometric.hpp>

vtkStandardNewMacro(vtkHaspTransplantFilter);

namespace
{
void AddMeshes(const hasp::MadeTransplant& made, vtkInformationVector* outputs)
{
  hasp::NumberedMeshes inDefect, onDonor, jaw;
  for (std::size_t n = 0; n < made.segments.size(); ++n)
  {
    inDefect.Add(made.segments[n].mesh, int(n));
    onDonor.Add(made.onDonor[n], int(n));
  }
  for (const hasp::BoneFragment& fragment : made.recipient.fragments)
    if (!fragment.resected && !fragment.crumb)
      jaw.Add(fragment.mesh, fragment.number);
  inDefect.Give(vtkPolyData::GetData(outputs, 0), "Segment");
  onDonor.Give(vtkPolyData::GetData(outputs, 1), "Segment");
  jaw.Give(vtkPolyData::GetData(outputs, 2), "Fragment");
}

void AddLines(const hasp::MadeTransplant& made, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIntArray> paddle;
  paddle->SetName("Paddle");
  const auto add = [&](const std::vector<glm::dvec3>& line, bool closed)
  {
    const vtkIdType first = points->GetNumberOfPoints();
    lines->InsertNextCell(int(line.size()) + (closed ? 1 : 0));
    for (const glm::dvec3& p : line)
      lines->InsertCellPoint(points->InsertNextPoint(p.x, p.y, p.z));
    if (closed)
      lines->InsertCellPoint(first);
    paddle->InsertNextValue(closed);
  };
  for (const hasp::PlacedVessel& part : made.vessel)
    add(part.line, false);
  if (made.paddle)
    add(made.paddle->paddle.outline, true);
  output->SetPoints(points);
  output->SetLines(lines);
  output->GetCellData()->AddArray(paddle);
}

void AddMeasures(const hasp::MadeTransplant& made, vtkPolyData* output)
{
  using Segment = hasp::PlacedSegment;
  using Joint = hasp::MadeJoint;
  const auto segment = [&](const char* name, auto value)
  { hasp::AddField(output, name, made.segments, value); };
  const auto joint = [&](const char* name, auto value)
  { hasp::AddField(output, name, made.joints, value); };
  segment("SegmentLengthMm", [](const Segment& s) { return s.cut.lengthMm; });
  segment("SegmentShortestMm", [](const Segment& s) { return s.cut.shortestMm; });
  segment("SegmentLongestMm", [](const Segment& s) { return s.cut.longestMm; });
  segment("SegmentWedgeDeg", [](const Segment& s) { return glm::degrees(s.cut.wedgeRadians); });
  segment("SegmentVolumeMm3", [](const Segment& s) { return s.volumeMm3; });
  joint("JointBendDeg", [](const Joint& j) { return glm::degrees(j.bendRadians); });
  joint("JointWedgeDeg", [](const Joint& j) { return glm::degrees(j.wedgeRadians); });
  joint("JointGapMm", [](const Joint& j) { return j.gapMm; });
  joint("JointOverlapMm", [](const Joint& j) { return j.overlapMm; });
  joint("JointContactMm2", [](const Joint& j) { return j.fit.contactMm2; });
  joint("JointStepMm2", [](const Joint& j) { return j.fit.stepMm2; });
}

/// They are in the outputs.
void DropMeshes(hasp::MadeTransplant& made)
{
  for (hasp::PlacedSegment& segment : made.segments)
    segment.mesh = {};
  for (hasp::BoneFragment& fragment : made.recipient.fragments)
    fragment.mesh = {};
  made.onDonor.clear();
}
} // namespace

vtkHaspTransplantFilter::vtkHaspTransplantFilter()
  : Recipe(std::make_unique<hasp::TransplantRecipe>()),
    Result(std::make_unique<hasp::MadeTransplant>())
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(4);
}
vtkHaspTransplantFilter::~vtkHaspTransplantFilter() = default;

void vtkHaspTransplantFilter::SetRecipe(const hasp::TransplantRecipe& recipe)
{
  if (*this->Recipe == recipe)
    return;
  *this->Recipe = recipe;
  this->Modified();
}

bool vtkHaspTransplantFilter::ReadRecipe(const std::string& path)
{
#if HASP_WITH_JSON
  return hasp::Succeeds(this, [&] { this->SetRecipe(hasp::ReadTransplantRecipe(path)); });
#else
  (void)path;
  return hasp::CannotReadRecipe(this);
#endif
}

int vtkHaspTransplantFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  return hasp::AskForImages(port, info);
}

int vtkHaspTransplantFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  // Each scan has an extent of its own; VTK would ask the donor's for that of the recipient's.
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
    if (vtkInformation* input = inputs[port]->GetInformationObject(0))
      input->Set(Pipeline::UPDATE_EXTENT(), input->Get(Pipeline::WHOLE_EXTENT()), 6);
  return 1;
}

int vtkHaspTransplantFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* recipient = vtkImageData::GetData(inputs[0]);
  vtkImageData* other = vtkImageData::GetData(inputs[1]);
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
    vtkPolyData::GetData(outputs, port)->Initialize();
  *this->Result = {};
  return hasp::Succeeds(this,
    [&]
    {
      hasp::MadeTransplant made = hasp::MakeTransplant({ hasp::ViewImage(recipient), {}, 1 },
        { hasp::ViewImage(other ? other : recipient), {}, 1 }, *this->Recipe,
        hasp::ProgressOf(this));
      AddMeshes(made, outputs);
      AddLines(made, vtkPolyData::GetData(outputs, 3));
      AddMeasures(made, vtkPolyData::GetData(outputs, 0));
      for (const std::string& warning : made.warnings)
        vtkWarningMacro(<< warning);
      DropMeshes(made);
      *this->Result = std::move(made);
    });
}

void vtkHaspTransplantFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Path: " << this->Recipe->path.size() << " places\n";
  os << indent << "Segments: " << this->Result->segments.size() << "\n";
}
