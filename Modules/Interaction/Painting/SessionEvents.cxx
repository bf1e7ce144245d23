// What painter, interactor and work tell a vtkHaspSegmentationSession.
#include "SessionInternals.h"

#include "LabelPalette.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

namespace
{
constexpr unsigned long PollMs = 30;
constexpr char LabelArray[] = "Labels";

/// What VTK calls back: no exception may fly through VTK.
template <typename Work>
void Guarded(vtkHaspSegmentationSession* session, const Work& work)
{
  try
  {
    work();
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorWithObjectMacro(session, << "There is no memory to go on splitting");
  }
  catch (const std::exception& error)
  {
    vtkErrorWithObjectMacro(session, << error.what());
  }
}
}

vtkHaspSegmentationSession::Internals::Internals(vtkHaspSegmentationSession* of) : session(of)
{
  this->strokes->SetClientData(this);
  this->strokes->SetCallback(
    [](vtkObject*, unsigned long event, void* self, void*)
    {
      auto* in = static_cast<Internals*>(self);
      const vtkSmartPointer<vtkHaspSegmentationSession> alive = in->session; // whatever observers
      Guarded(alive, [&] { in->Heard(event); });                             // do
    });
  this->command->SetClientData(this);
  this->command->SetCallback(
    [](vtkObject*, unsigned long event, void* self, void* data)
    {
      auto* in = static_cast<Internals*>(self);
      const vtkSmartPointer<vtkHaspSegmentationSession> alive = in->session;
      Guarded(alive,
        [&]
        {
          if (in->Handle(event, data))
            in->command->AbortFlagOn();
        });
    });
}

vtkHaspSegmentationSession::Internals::~Internals()
{
  this->Listen(nullptr);
  this->Follow(nullptr);
}

void vtkHaspSegmentationSession::Internals::Begin(vtkImageData* scan)
{
  vtkSmartPointer<vtkImageData> shown;
  vtkSmartPointer<vtkUnsignedShortArray> none;
  std::unique_ptr<hasp::SplitWork> splits;
  if (scan)
  {
    hasp::ViewImage(scan); // what cannot be read is refused
    const char* name = scan->GetPointData()->GetScalars()->GetName();
    if (name && std::string(name) == LabelArray)
      throw std::invalid_argument("its samples are called Labels; give them another name");
    none = vtkSmartPointer<vtkUnsignedShortArray>::New();
    none->SetName(LabelArray);
    none->SetNumberOfValues(scan->GetNumberOfPoints());
    none->Fill(0);
    shown = vtkSmartPointer<vtkImageData>::New();
    shown->ShallowCopy(scan);
    shown->GetPointData()->AddArray(none);
    splits = std::make_unique<hasp::SplitWork>(scan);
  }
  this->image = std::move(shown);
  this->labels = std::move(none);
  this->work = std::move(splits);
  this->drags.clear();
  this->finding = {};
  this->undoBytes = 0;
}

bool vtkHaspSegmentationSession::Internals::Take(std::list<hasp::SplitOutcome> outcomes)
{
  const hasp::VoxelBox changed = this->Change(outcomes);
  for (hasp::SplitOutcome& outcome : outcomes)
    this->Note(outcome);
  int box[6];
  if (!changed.Empty())
  {
    this->labels->Modified();
    const int* first = this->image->GetExtent();
    for (int a = 0; a < 3; ++a)
    {
      box[2 * a] = first[2 * a] + changed.low[a];
      box[2 * a + 1] = first[2 * a] + changed.high[a] - 1;
    }
    if (this->mapper && this->mapper->GetImage() == this->image)
      this->mapper->MarkLabelsModified(box);
  }
  Guarded(this->session, [this] { this->ShowStrokes(); });
  for (const hasp::SplitOutcome& outcome : outcomes)
  {
    if (!outcome.error.empty())
      vtkErrorWithObjectMacro(this->session, << "A drag split nothing: " << outcome.error);
    if (outcome.owed)
      vtkErrorWithObjectMacro(
        this->session, << "There is no memory to take a drag back: its labels "
                          "stay until the next drag, or the next Undo");
  }
  if (!changed.Empty())
    this->session->InvokeEvent(LabelsChangedEvent, box);
  return !changed.Empty();
}

hasp::VoxelBox vtkHaspSegmentationSession::Internals::Change(
  std::list<hasp::SplitOutcome>& outcomes)
{
  const hasp::GridView<hasp::Label> map{ this->labels->GetPointer(0),
    hasp::ImageGeometry(this->image) };
  try
  {
    hasp::VoxelBox changed{ map.geometry.dims, glm::ivec3(0) };
    for (const hasp::SplitOutcome& outcome : outcomes)
      for (const hasp::LabelDelta& change : outcome.changes)
        if (!change.Empty())
        {
          ApplyDelta(change, map);
          const hasp::VoxelBox box = change.Box();
          changed = { glm::min(changed.low, box.low), glm::max(changed.high, box.high) };
        }
    return changed;
  }
  catch (const std::exception& error)
  {
    vtkErrorWithObjectMacro(this->session,
      << "The labels shown are not those of the split, and are shown anew: " << error.what());
    this->work->Wait();
    outcomes.splice(outcomes.end(), this->work->TakeOutcomes());
    if (hasp::Segmenter* made = this->work->Made())
      std::copy_n(static_cast<const hasp::Label*>(made->Labels()->GetScalarPointer()),
        map.geometry.Size(), map.data);
    else
      std::fill_n(map.data, map.geometry.Size(), hasp::Label(0));
    return { glm::ivec3(0), map.geometry.dims };
  }
}

void vtkHaspSegmentationSession::Internals::Note(hasp::SplitOutcome& outcome)
{
  this->undoBytes = outcome.undoBytes;
  const auto drag = std::find_if(this->drags.begin(), this->drags.end(),
    [&](const Drag& one) { return one.number == outcome.drag; });
  if (drag == this->drags.end())
    return; // taken back meanwhile
  drag->shown = outcome.done;
  if (outcome.done)
    this->finding = std::move(outcome.finding);
  else
    this->drags.erase(drag);
}

void vtkHaspSegmentationSession::Internals::SetUpMapper()
{
  if (!this->mapper)
    return;
  this->mapper->SetInputData(this->image);
  this->mapper->SetLabelArrayName(LabelArray);
  this->ColourLabels(this->session->GetStrokes());
}

void vtkHaspSegmentationSession::Internals::ColourLabels(
  const std::vector<hasp::BrushStroke>& painted)
{
  for (const hasp::BrushStroke& stroke : painted)
  {
    const hasp::CellLabels* said = this->mapper ? &this->mapper->GetLabels() : nullptr;
    if (!said || (said->count(stroke.label) && said->at(stroke.label).color))
      continue;
    const glm::dvec3 colour = hasp::PaletteColour(stroke.label);
    this->mapper->SetLabelColor(stroke.label, colour.x, colour.y, colour.z);
  }
}

void vtkHaspSegmentationSession::Internals::ShowStrokes()
{
  if (!this->actor)
    return;
  std::vector<hasp::BrushStroke> all = this->session->GetStrokes();
  if (this->painter && this->painter->IsPainting())
    for (const hasp::BrushStroke& piece : this->painter->GetPieces())
      all.push_back(piece);
  this->actor->SetStrokes(all);
}

void vtkHaspSegmentationSession::Internals::Listen(vtkHaspSeedPainter* whose)
{
  if (this->painter)
    this->painter->RemoveObserver(this->strokes);
  this->painter = whose;
  if (whose == nullptr)
    return;
  this->Heard(vtkCommand::ModifiedEvent);
  whose->AddObserver(vtkCommand::ModifiedEvent, this->strokes); // it may be enabled
  for (const unsigned long event :
    { vtkHaspSeedPainter::StrokeStartedEvent, vtkHaspSeedPainter::StrokeChangedEvent,
      vtkHaspSeedPainter::StrokeEndedEvent, vtkHaspSeedPainter::StrokeCancelledEvent })
    whose->AddObserver(event, this->strokes);
}

void vtkHaspSegmentationSession::Internals::Heard(unsigned long event)
{
  if (event == vtkCommand::ModifiedEvent)
  {
    // Switched off it is followed on: what is at work now will be shown.
    vtkRenderer* renderer = this->painter->GetEnabled() ? this->painter->GetRenderer() : nullptr;
    if (vtkRenderWindow* window = renderer ? renderer->GetRenderWindow() : nullptr)
      this->Follow(window->GetInteractor());
    return;
  }
  if (event == vtkHaspSeedPainter::StrokeEndedEvent)
    this->session->AddStrokes(this->painter->GetPieces());
  this->ShowStrokes();
}

void vtkHaspSegmentationSession::Internals::Follow(vtkRenderWindowInteractor* whose)
{
  if (this->interactor == whose)
    return;
  this->EndTimer();
  if (this->interactor)
    this->interactor->RemoveObserver(this->command);
  this->interactor = whose;
  if (whose == nullptr)
    return;
  whose->AddObserver(vtkCommand::KeyPressEvent, this->command, 1.0F); // before styles
  whose->AddObserver(vtkCommand::TimerEvent, this->command, 1.0F);
}

bool vtkHaspSegmentationSession::Internals::Handle(unsigned long event, void* data)
{
  if (event == vtkCommand::TimerEvent)
  {
    if (this->timerId == 0 || data == nullptr || *static_cast<int*>(data) != this->timerId)
      return false;
    // A timer that is ended while it fires takes VTK's list of them with it: so each fires once.
    this->timerId = 0;
    if (this->session->Update() && this->interactor)
      this->interactor->Render();
    if (this->working)
      this->BeginTimer();
    return true; // a style takes any timer for its own, and repeats the last step of a drag
  }
  const char* symbol = this->interactor->GetKeySym();
  const std::string key = symbol ? symbol : "";
  const bool undo = key == "z" && this->interactor->GetControlKey();
  const bool digit = key.size() == 1 && key[0] >= '2' && key[0] <= '9';
  if (!this->painter || !this->painter->GetEnabled())
    return false;
  if (digit && !this->interactor->GetControlKey() && !this->interactor->GetAltKey())
    this->painter->SetLabel(key[0] - '0');
  else if (undo && this->painter->IsPainting())
    this->painter->Cancel();
  else if (undo)
    this->session->Undo();
  else if (key == "Escape" && !this->drags.empty() && !this->drags.back().shown &&
           !this->painter->IsPainting())
    this->session->Cancel();
  else
    return false;
  if (this->interactor)
    this->interactor->Render(); // without its strokes
  return true;
}

void vtkHaspSegmentationSession::Internals::Working()
{
  ++this->requests;
  this->BeginTimer(); // whether or not it is done by now: somebody must see what came of it
  if (!std::exchange(this->working, true))
    this->session->InvokeEvent(WorkStartedEvent);
}

void vtkHaspSegmentationSession::Internals::Rested()
{
  this->EndTimer();
  if (std::exchange(this->working, false))
    this->session->InvokeEvent(WorkEndedEvent);
}

void vtkHaspSegmentationSession::Internals::BeginTimer()
{
  if (this->timerId != 0 || !this->interactor || !this->interactor->GetInitialized())
    return; // strokes come from an interactor that runs, or from a program
  this->timerId = this->interactor->CreateOneShotTimer(PollMs); // 0 where it has none
}

void vtkHaspSegmentationSession::Internals::EndTimer()
{
  const int timer = std::exchange(this->timerId, 0);
  if (timer != 0 && this->interactor)
    this->interactor->DestroyTimer(timer);
}
