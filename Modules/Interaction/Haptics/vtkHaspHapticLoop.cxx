#include "vtkHaspHapticLoop.h"

#include "HapticChain.h"
#include "Realtime/LoopThread.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkWeakPointer.h"

#include <cmath>
#include <exception>
#include <optional>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkHaspHapticLoop);

namespace
{
constexpr float ExitPriority = -1.0F; // behind the application's own observers
}

struct vtkHaspHapticLoop::Internals
{
  std::unique_ptr<hasp::HapticRecorder> recorder;
  std::unique_ptr<hasp::HapticChain> chain;
  hasp::LoopThread thread; // behind what it ticks: it ends first
  hasp::LoopSettings settings;
  hasp::HapticControl control;
  hasp::HapticSnapshot snapshot;
  std::unique_ptr<hasp::HapticDiscRequest> discs;
  bool asked = false; // discs are on their way
  bool started = false, touchable = false;
  std::uint64_t scenes = 0;
  std::size_t sceneBytes = 0;
  std::optional<hasp::RigidPose> start; // of the tool, as long as it is not started

  static inline std::vector<vtkHaspHapticLoop*> All; // RENDER's: FollowExit tells them from others
  vtkNew<vtkCallbackCommand> goes, exits;
  vtkWeakPointer<vtkRenderWindow> window;
  vtkWeakPointer<vtkRenderWindowInteractor> interactor;

  void StopThread() noexcept
  {
    this->thread.Stop();
    if (this->chain)
      this->chain->Rest();
  }
  void Unobserve()
  {
    if (this->window)
      this->window->RemoveObserver(this->goes);
    if (this->interactor)
    {
      this->interactor->RemoveObserver(this->goes);
      this->interactor->RemoveObserver(this->exits);
    }
  }
};

vtkHaspHapticLoop::vtkHaspHapticLoop() : Self(std::make_unique<Internals>())
{
  Internals::All.push_back(this);
  this->Self->goes->SetClientData(this);
  this->Self->goes->SetCallback([](vtkObject*, unsigned long, void* self, void*)
    { static_cast<vtkHaspHapticLoop*>(self)->Stop(); });
  this->Self->exits->SetClientData(this);
  this->Self->exits->SetCallback([](vtkObject*, unsigned long, void* self, void*)
    { static_cast<vtkHaspHapticLoop*>(self)->FollowExit(); });
}

vtkHaspHapticLoop::~vtkHaspHapticLoop()
{
  std::erase(Internals::All, this);
  this->Self->Unobserve();
  this->Stop();
}

bool vtkHaspHapticLoop::SetDevice(std::unique_ptr<hasp::HapticDevice> device)
{
  return this->SetDevice(std::move(device), {});
}

bool vtkHaspHapticLoop::SetDevice(
  std::unique_ptr<hasp::HapticDevice> device, const hasp::HapticChainSettings& settings)
{
  Internals& self = *this->Self;
  self.StopThread();
  self.chain.reset();
  self.snapshot = {};
  self.discs.reset();
  self.asked = self.touchable = false;
  self.control = {};
  self.start.reset();
  this->Modified();
  if (!device)
    return true;
  try
  {
    self.chain = std::make_unique<hasp::HapticChain>(std::move(device), settings);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< "The haptic device is not used: " << error.what());
    return false;
  }
  self.chain->Record(self.recorder.get());
  self.control.contact = settings.step.contact;
  self.control.spring = settings.step.coupling.spring;
  self.control.scale = settings.workspace.scale;
  self.chain->Control(self.control);
  return true;
}

hasp::HapticDevice* vtkHaspHapticLoop::GetDevice()
{
  return this->Self->chain ? &this->Self->chain->Guarded() : nullptr;
}

const hasp::DeviceProfile* vtkHaspHapticLoop::GetProfile()
{
  return this->Self->chain ? &this->Self->chain->Profile() : nullptr;
}

void vtkHaspHapticLoop::SetLoopSettings(const hasp::LoopSettings& settings)
{
  this->Self->settings = settings;
}

std::uint64_t vtkHaspHapticLoop::SetScene(std::vector<hasp::HapticShell> shells,
  std::vector<hasp::HapticBody> bodies, const hasp::RigidPose* start)
{
  Internals& self = *this->Self;
  if (!self.chain)
  {
    vtkErrorMacro(<< "A haptic scene needs a device; call SetDevice before SetScene");
    return 0;
  }
  if (start != nullptr && !hasp::IsPose(*start))
  {
    vtkErrorMacro(<< "The haptic scene stays as it was: the start of the tool is no pose; give it "
                     "finite numbers and a turn of length 1");
    return 0;
  }
  const bool touchable = !shells.empty() && !bodies.empty(), tool = !shells.empty();
  auto offer = std::make_unique<hasp::HapticSceneOffer>();
  try
  {
    offer->scene = std::make_unique<hasp::HapticScene>(std::move(shells), std::move(bodies));
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< "The haptic scene stays as it was: " << error.what());
    return 0;
  }
  if (start != nullptr)
    offer->start = { start->position, glm::normalize(start->orientation) };
  if (offer->start || !tool)
    self.start = offer->start;
  offer->number = ++self.scenes;
  hasp::ResourceList made;
  offer->scene->ListResources(made);
  self.sceneBytes = 0;
  for (const hasp::ResourceUse& use : made)
    self.sceneBytes += touchable ? use.bytes : 0;
  self.touchable = touchable;
  self.chain->OfferScene(std::move(offer));
  if (!this->RunOrRest())
    return 0;
  if (self.started)
    self.start.reset(); // the chain's from here on
  return self.scenes;
}

bool vtkHaspHapticLoop::SetControl(const hasp::HapticControl& control)
{
  if (const char* wrong = hasp::WrongIn(control))
  {
    vtkErrorMacro(<< "The haptic control stays as it was: " << wrong);
    return false;
  }
  this->Self->control = control;
  if (this->Self->chain)
    this->Self->chain->Control(control);
  return true;
}

const hasp::HapticControl& vtkHaspHapticLoop::GetControl() const
{
  return this->Self->control;
}

const hasp::HapticSnapshot& vtkHaspHapticLoop::GetSnapshot() const
{
  return this->Self->snapshot;
}

bool vtkHaspHapticLoop::SetRecorder(std::unique_ptr<hasp::HapticRecorder> recorder)
{
  if (this->Self->started)
  {
    vtkErrorMacro(
      << "A haptic recorder is set or taken away between Stop and Start, not while ticks "
         "may push into it");
    return false;
  }
  if (this->Self->chain)
    this->Self->chain->Record(recorder.get());
  this->Self->recorder = std::move(recorder);
  return true;
}

const hasp::HapticDiscRequest* vtkHaspHapticLoop::AskForDiscs(std::size_t most)
{
  Internals& self = *this->Self;
  if (!self.chain)
    return nullptr;
  auto& requests = self.chain->Discs();
  std::unique_ptr<hasp::HapticDiscRequest> spare;
  if (auto answered = requests.Collect())
  {
    spare = std::exchange(self.discs, std::move(answered));
    self.asked = false;
  }
  if (!self.asked)
  {
    if (!spare)
      spare = std::make_unique<hasp::HapticDiscRequest>();
    spare->room.resize(most);
    requests.Offer(std::move(spare));
    self.asked = true;
  }
  return self.discs.get();
}

hasp::RateCounts vtkHaspHapticLoop::GetRates() const
{
  return this->Self->thread.Rates();
}

bool vtkHaspHapticLoop::Start()
{
  if (!this->Self->chain)
  {
    vtkErrorMacro(<< "There is no haptic device to start; call SetDevice first");
    return false;
  }
  this->FollowWindow();
  Internals& self = *this->Self;
  self.started = true;
  if (self.start)
    self.chain->Place(*self.start); // Update has let the tool go along with the device since
  if (!this->RunOrRest())
    return false;
  self.start.reset();
  return true;
}

void vtkHaspHapticLoop::Stop()
{
  this->Self->started = false;
  this->Self->StopThread();
}

bool vtkHaspHapticLoop::GetStarted() const
{
  return this->Self->started;
}

bool vtkHaspHapticLoop::IsRunning() const
{
  return this->Self->thread.Running();
}

bool vtkHaspHapticLoop::RunOrRest()
{
  Internals& self = *this->Self;
  const bool wanted = self.started && self.touchable;
  if (wanted == self.thread.Running())
    return true;
  if (!wanted)
  {
    self.StopThread();
    return true;
  }
  hasp::HapticChain* chain = self.chain.get();
  const double periodS = 1e-9 * static_cast<double>(self.settings.periodNs);
  if (std::abs(periodS - chain->TickS()) > 1e-6 * chain->TickS())
  {
    self.started = false;
    vtkErrorMacro(<< "The haptic thread does not start: the loop's periodNs is "
                  << self.settings.periodNs << ", the step's tickS " << chain->TickS()
                  << " s; give both the same time");
    return false;
  }
  try
  {
    self.thread.Start(self.settings,
      [chain](const hasp::LoopTick& tick) noexcept
      {
        chain->Tick(tick.number, tick.nowNs);
        return true;
      });
  }
  catch (const std::exception& error)
  {
    self.started = false;
    vtkErrorMacro(<< "The haptic thread does not start: " << error.what());
    return false;
  }
  return true;
}

void vtkHaspHapticLoop::Update()
{
  Internals& self = *this->Self;
  this->FollowWindow();
  if (!self.chain)
    return;
  self.chain->Collect();
  // Nobody else reads the device: where it is and what it presses is known all the same.
  if ((self.started || self.snapshot.ticks > 0) && !self.thread.Running())
    self.chain->Poll(hasp::MonotonicClock().NowNs());
  if (const hasp::HapticSnapshot* newest = self.chain->Latest())
    self.snapshot = *newest;
}

std::string vtkHaspHapticLoop::GetSchedulingReport() const
{
  std::string report;
  for (const std::string& sentence : this->Self->thread.Scheduling().Shortfalls())
    report += sentence + "\n";
  if (this->Self->thread.Dropped())
    report +=
      "The haptic thread took too much time and lost its real-time scheduling; give it fewer "
      "points or a faster core\n";
  return report;
}

void vtkHaspHapticLoop::FollowWindow()
{
  vtkRenderWindow* window = this->Self->window;
  if (window != nullptr && window->GetInteractor() != this->Self->interactor.GetPointer())
    this->SetRenderWindow(window);
}

void vtkHaspHapticLoop::SetRenderWindow(vtkRenderWindow* window)
{
  Internals& self = *this->Self;
  self.Unobserve();
  self.window = window;
  self.interactor = window != nullptr ? window->GetInteractor() : nullptr;
  if (self.window)
    self.window->AddObserver(vtkCommand::DeleteEvent, self.goes);
  if (self.interactor)
  {
    self.interactor->AddObserver(vtkCommand::DeleteEvent, self.goes);
    self.interactor->AddObserver(vtkCommand::ExitEvent, self.exits, ExitPriority);
  }
}

/// Called when all others were asked. An interactor ends by itself only if nobody listens to its
/// ExitEvent, so what it would have done without us, and others like us, is done here: by the first
/// of them, for all.
void vtkHaspHapticLoop::FollowExit()
{
  vtkRenderWindowInteractor* interactor = this->Self->interactor;
  std::vector<vtkHaspHapticLoop*> loops;
  for (vtkHaspHapticLoop* loop : Internals::All)
    if (loop->Self->interactor == interactor)
      loops.push_back(loop);
  for (vtkHaspHapticLoop* loop : loops)
    interactor->RemoveObserver(loop->Self->exits);
  const bool asked = interactor->HasObserver(vtkCommand::ExitEvent);
  for (vtkHaspHapticLoop* loop : loops) // not called again for this event
    interactor->AddObserver(vtkCommand::ExitEvent, loop->Self->exits, ExitPriority);
  if (asked && !interactor->GetDone())
    return; // somebody has refused to end
  for (vtkHaspHapticLoop* loop : loops)
    loop->Stop();
  if (!asked)
    interactor->TerminateApp();
}

void vtkHaspHapticLoop::ListResources(hasp::ResourceList& resources) const
{
  const Internals& self = *this->Self;
  const std::string why = !self.chain       ? "no haptic device"
                          : !self.started   ? "not started"
                          : !self.touchable ? "no tool, or nothing to touch"
                                            : "a tool and something to touch";
  const bool there = this->IsRunning();
  resources.push_back({ "haptic thread", there ? sizeof(hasp::HapticChain) : 0, 0.0, why });
  resources.push_back({ "haptic scene", self.touchable ? self.sceneBytes : 0, 0.0, why });
}

void vtkHaspHapticLoop::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Device: " << (this->Self->chain ? "set" : "none") << "\n";
  os << indent << "Started: " << this->Self->started << "\n";
  os << indent << "Running: " << this->IsRunning() << "\n";
  os << indent << "Ticks: " << this->Self->snapshot.ticks << "\n";
}
