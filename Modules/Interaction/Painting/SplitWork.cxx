#include "SplitWork.h"

#include "Grid/ProgressPart.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <exception>
#include <new>
#include <utility>

namespace hasp
{

namespace
{
constexpr double BoneShare = 0.1; // of the first drag's time
}

SplitWork::SplitWork(vtkImageData* scan)
  : Scan(vtkSmartPointer<vtkImageData>::New()), // what others do to theirs is not ours to see
    Thread([this](EditThread::Ticket number) { this->Undo(number); })
{
  this->Scan->CopyStructure(scan);
  this->Scan->GetPointData()->SetScalars(scan->GetPointData()->GetScalars());
}

void SplitWork::Add(SplitDrag drag)
{
  const EditThread::Ticket number = drag.number;
  this->Thread.Add(number, [this, drag = std::move(drag)](const EditThread::Progress& progress)
    { return this->Split(drag, progress); });
}

void SplitWork::TakeBack(std::uint64_t number)
{
  this->Thread.TakeBack(number);
}

std::vector<SplitOutcome> SplitWork::TakeOutcomes()
{
  const std::lock_guard lock(this->Guard);
  return std::exchange(this->Outcomes, {});
}

bool SplitWork::Split(const SplitDrag& drag, const ProgressFunction& progress)
{
  SplitOutcome outcome;
  outcome.drag = drag.number;
  int entries = 0;
  const auto keep = [&](LabelDelta change)
  {
    outcome.changes.push_back(std::move(change));
    ++entries;
  };
  try
  {
    if (!this->Splitter)
      this->Splitter = std::make_unique<Segmenter>(this->Scan);
    Segmenter& splitter = *this->Splitter;
    if (this->Drags.empty())
    {
      keep(splitter.Apply(drag.bone, PartOf(progress, 0.0, BoneShare)));
      keep(splitter.Apply(SplitStep{ 1, drag.pieces, drag.beta, drag.crack, drag.norm },
        PartOf(progress, BoneShare, 1.0)));
    }
    else
      for (std::size_t n = 0; n < drag.pieces.size(); ++n)
      {
        const double part = 1.0 / double(drag.pieces.size());
        keep(splitter.AddStroke(
          drag.pieces[n], PartOf(progress, part * double(n), part * double(n + 1))));
      }
    this->Drags.push_back({ drag.number, entries });
    outcome.done = true;
    outcome.finding = splitter.Finding();
  }
  catch (const Cancelled&)
  {
  }
  catch (const std::bad_alloc&)
  {
    outcome.error = "there is no memory to split this scan";
  }
  catch (const std::exception& error)
  {
    outcome.error = error.what();
  }
  if (!outcome.done)
  {
    for (; entries > 0; --entries)
      this->Splitter->Undo();
    outcome.changes.clear();
  }
  const bool done = outcome.done;
  this->Publish(std::move(outcome));
  return done;
}

void SplitWork::Undo(std::uint64_t number)
{
  if (this->Drags.empty() || this->Drags.back().drag != number)
    return; // it had failed
  SplitOutcome outcome;
  outcome.drag = number;
  for (int n = 0; n < this->Drags.back().entries; ++n)
    outcome.changes.push_back(this->Splitter->Undo());
  this->Drags.pop_back();
  this->Publish(std::move(outcome));
}

void SplitWork::Publish(SplitOutcome outcome)
{
  if (this->Splitter)
    outcome.undoBytes = this->Splitter->UndoBytes();
  const std::lock_guard lock(this->Guard);
  this->Outcomes.push_back(std::move(outcome));
}

} // namespace hasp
