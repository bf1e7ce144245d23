#include "SplitWork.h"

#include "Grid/ProgressPart.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <new>
#include <utility>

namespace hasp
{

namespace
{
constexpr double BoneShare = 0.1; // of the first drag's time

void SayWhy(SplitOutcome& outcome, const char* why) noexcept
{
  try
  {
    outcome.error = why;
  }
  catch (const std::bad_alloc&)
  {
    outcome.error = "no memory"; // so short that it takes none
  }
}
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
  std::list<SplitOutcome> replies(2); // to the drag, and to its being taken back
  {
    const std::lock_guard lock(this->Guard);
    this->Replies.splice(this->Replies.end(), replies);
  }
  const EditThread::Ticket number = drag.number;
  this->Thread.Add(number, [this, drag = std::move(drag)](const EditThread::Progress& progress)
    { return this->Split(drag, progress); });
}

void SplitWork::TakeBack(std::uint64_t number)
{
  this->Thread.TakeBack(number);
}

std::list<SplitOutcome> SplitWork::TakeOutcomes()
{
  const std::lock_guard lock(this->Guard);
  return std::exchange(this->Outcomes, {});
}

// What the thread calls throws nothing, whatever memory there is.

bool SplitWork::Split(const SplitDrag& drag, const ProgressFunction& progress)
{
  std::list<SplitOutcome> reply = this->Reply(drag.number);
  SplitOutcome& outcome = reply.front();
  std::size_t before = 0;
  try
  {
    this->TakeBackOwed(outcome.changes);
    before = outcome.changes.size();
    this->Make(drag, outcome, progress);
    outcome.done = true;
  }
  catch (const Cancelled&)
  {
  }
  catch (const std::bad_alloc&)
  {
    SayWhy(outcome, "there is no memory to split this scan");
  }
  catch (const std::exception& error)
  {
    SayWhy(outcome, error.what());
  }
  const bool done = outcome.done;
  if (!done)
    this->GiveUp(outcome, before);
  this->Publish(reply);
  return done;
}

void SplitWork::Make(const SplitDrag& drag, SplitOutcome& outcome, const ProgressFunction& progress)
{
  if (!this->Splitter)
    this->Splitter = std::make_unique<Segmenter>(this->Scan);
  Segmenter& splitter = *this->Splitter;
  const bool first = this->Drags.empty();
  outcome.changes.reserve(outcome.changes.size() + drag.pieces.size() + 1);
  this->Drags.push_back({ drag.number });
  const auto keep = [&](LabelDelta change)
  {
    outcome.changes.push_back(std::move(change));
    ++this->Drags.back().entries;
  };
  if (first)
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
  outcome.finding = splitter.Finding();
}

/// Takes back what there is of its drag: then `before` of its changes are left.
void SplitWork::GiveUp(SplitOutcome& outcome, std::size_t before)
{
  if (this->Drags.empty() || this->Drags.back().drag != outcome.drag)
    return; // it did not begin
  this->Drags.back().owed = true;
  try
  {
    this->TakeBackOwed(outcome.changes);
    outcome.changes.erase(outcome.changes.begin() + std::ptrdiff_t(before), outcome.changes.end());
  }
  catch (const std::exception&)
  {
    outcome.owed = true;
  }
}

void SplitWork::Undo(std::uint64_t number)
{
  const auto drag = std::find_if(this->Drags.begin(), this->Drags.end(),
    [number](const Done& done) { return done.drag == number; });
  if (drag == this->Drags.end())
    return; // it had failed
  drag->owed = true;
  std::list<SplitOutcome> reply = this->Reply(number);
  try
  {
    this->TakeBackOwed(reply.front().changes);
  }
  catch (const std::exception&)
  {
    reply.front().owed = true;
  }
  this->Publish(reply);
}

/// Adds to the changes. If it throws, what they say is taken back and the others are still owed.
void SplitWork::TakeBackOwed(std::vector<LabelDelta>& changes)
{
  while (!this->Drags.empty() && this->Drags.back().owed)
  {
    Done& last = this->Drags.back();
    changes.reserve(changes.size() + std::size_t(last.entries));
    for (; last.entries > 0; --last.entries)
      changes.push_back(this->Splitter->Undo());
    this->Drags.pop_back();
  }
}

std::list<SplitOutcome> SplitWork::Reply(std::uint64_t number)
{
  std::list<SplitOutcome> reply;
  const std::lock_guard lock(this->Guard);
  reply.splice(reply.end(), this->Replies, this->Replies.begin());
  reply.front().drag = number;
  return reply;
}

void SplitWork::Publish(std::list<SplitOutcome>& reply)
{
  if (this->Splitter)
    reply.front().undoBytes = this->Splitter->UndoBytes();
  const std::lock_guard lock(this->Guard);
  this->Outcomes.splice(this->Outcomes.end(), reply);
}

} // namespace hasp
