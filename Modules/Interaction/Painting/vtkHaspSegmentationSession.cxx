#include "vtkHaspSegmentationSession.h"

#include "SessionInternals.h"

#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <exception>
#include <stdexcept>
#include <utility>

vtkStandardNewMacro(vtkHaspSegmentationSession);

vtkHaspSegmentationSession::vtkHaspSegmentationSession() : Self(std::make_unique<Internals>(this))
{
}

vtkHaspSegmentationSession::~vtkHaspSegmentationSession() = default;

bool vtkHaspSegmentationSession::SetScan(vtkImageData* scan)
{
  Internals& self = *this->Self;
  try
  {
    self.Begin(scan);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< "This scan cannot be split: " << error.what());
    return false;
  }
  self.ShowStrokes();
  self.SetUpMapper();
  self.Rested();
  this->Modified();
  return true;
}

vtkImageData* vtkHaspSegmentationSession::GetImage() const
{
  return this->Self->image;
}

void vtkHaspSegmentationSession::SetPainter(vtkHaspSeedPainter* painter)
{
  this->Self->Listen(painter);
  this->Modified();
}

void vtkHaspSegmentationSession::SetMapper(vtkHaspClusteredCellMapper* mapper)
{
  this->Self->mapper = mapper;
  this->Self->SetUpMapper();
  this->Modified();
}

void vtkHaspSegmentationSession::SetStrokeActor(vtkHaspStrokeActor* actor)
{
  this->Self->actor = actor;
  this->Self->ShowStrokes();
  this->Modified();
}

bool vtkHaspSegmentationSession::AddStrokes(const std::vector<hasp::BrushStroke>& pieces)
{
  Internals& self = *this->Self;
  if (pieces.empty())
    return true;
  try
  {
    if (!self.work)
      throw std::invalid_argument("there is no scan to be split; call SetScan");
    for (const hasp::BrushStroke& piece : pieces)
      ValidateBrushStroke(piece, "stroke"); // label 0, too
    const std::uint64_t number = self.last + 1;
    self.work->Add({ number, pieces, { this->LowestBone, this->HighestBone }, this->Beta,
      this->Crack, this->Norm });
    self.last = number;
    self.drags.push_back({ number, pieces });
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< "These strokes split nothing: " << error.what());
    return false;
  }
  self.ColourLabels(pieces);
  self.ShowStrokes();
  self.Working();
  return true;
}

std::vector<hasp::BrushStroke> vtkHaspSegmentationSession::GetStrokes() const
{
  std::vector<hasp::BrushStroke> strokes;
  for (const Internals::Drag& drag : this->Self->drags)
    strokes.insert(strokes.end(), drag.pieces.begin(), drag.pieces.end());
  return strokes;
}

hasp::SegmentationRecipe vtkHaspSegmentationSession::GetRecipe()
{
  this->Finish();
  const Internals& self = *this->Self;
  return self.work && self.work->Made() ? self.work->Made()->Recipe() : hasp::SegmentationRecipe{};
}

const hasp::SegmentationFinding& vtkHaspSegmentationSession::GetFinding() const
{
  return this->Self->finding;
}

int vtkHaspSegmentationSession::GetNumberOfDrags() const
{
  return static_cast<int>(this->Self->drags.size());
}

bool vtkHaspSegmentationSession::Undo()
{
  Internals& self = *this->Self;
  if (self.drags.empty())
    return false;
  self.work->TakeBack(self.drags.back().number);
  self.drags.pop_back();
  self.ShowStrokes();
  self.Working();
  return true;
}

void vtkHaspSegmentationSession::Cancel()
{
  while (!this->Self->drags.empty() && !this->Self->drags.back().shown)
    this->Undo();
}

bool vtkHaspSegmentationSession::IsWorking() const
{
  return this->Self->work && !this->Self->work->Idle();
}

double vtkHaspSegmentationSession::GetProgress() const
{
  return this->Self->work ? this->Self->work->Share() : 0.0;
}

bool vtkHaspSegmentationSession::Update()
{
  Internals& self = *this->Self;
  if (!self.work)
    return false;
  const bool idle = self.work->Idle(); // before what there is: nothing is left behind then
  const std::uint64_t requests = self.requests;
  const bool changed = self.Take(self.work->TakeOutcomes());
  if (idle && self.requests == requests) // nobody who heard of it asked for more
    self.Rested();
  return changed;
}

bool vtkHaspSegmentationSession::Finish()
{
  bool changed = false;
  do // who hears of what is done may ask for more
  {
    if (this->Self->work)
      this->Self->work->Wait();
    changed = this->Update() || changed;
  } while (this->IsWorking());
  return changed;
}

bool vtkHaspSegmentationSession::Settle()
{
  Internals& self = *this->Self;
  const bool changed = this->Finish();
  if (!self.work || !self.work->Made())
    return changed;
  try
  {
    hasp::SplitOutcome settled;
    settled.changes.push_back(self.work->Made()->Settle());
    settled.undoBytes = self.work->Made()->UndoBytes();
    std::list<hasp::SplitOutcome> all;
    all.push_back(std::move(settled));
    return self.Take(std::move(all)) || changed;
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< "The split is not settled: " << error.what());
    return changed;
  }
}

void vtkHaspSegmentationSession::ListResources(hasp::ResourceList& resources) const
{
  const Internals& self = *this->Self;
  const std::size_t samples = self.image ? std::size_t(self.image->GetNumberOfPoints()) : 0;
  resources.push_back({ "split labels", samples * sizeof(hasp::Label), 0.0,
    self.image ? "shown; the split has as many of its own once there is a stroke" : "no scan" });
  resources.push_back(
    { "split undo", self.undoBytes, 0.0, std::to_string(self.drags.size()) + " drags" });
}

void vtkHaspSegmentationSession::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Drags: " << this->GetNumberOfDrags() << "\n"
     << indent << "Working: " << (this->IsWorking() ? "yes" : "no") << "\n"
     << indent << "LowestBone: " << this->LowestBone << "\n"
     << indent << "HighestBone: " << this->HighestBone << "\n"
     << indent << "Beta: " << this->Beta << "\n"
     << indent << "Crack: " << this->Crack << "\n"
     << indent << "Norm: " << this->Norm << "\n";
}
