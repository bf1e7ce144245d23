#pragma once
#include <functional>

class vtkRenderWindowInteractor;

namespace hasp
{

/// Calls back once, soon, when the interactor has nothing else to do. For frame after frame start
/// it in each: a chain of timers for one shot. VTK 9.1's X interactor writes to a repeating one
/// after its event, so that it could not be stopped there. RENDER thread; the interactor must
/// outlive it.
class FrameTimer
{
public:
  FrameTimer(vtkRenderWindowInteractor* interactor, std::function<void()> call);
  ~FrameTimer();
  FrameTimer(const FrameTimer&) = delete;
  void operator=(const FrameTimer&) = delete;

  /// In so many milliseconds. Nothing happens where it runs, or the interactor is not initialised.
  void Start(int ms = 1);
  bool Runs() const { return this->Id != 0; }

private:
  void Fire(void* id);

  vtkRenderWindowInteractor* Interactor;
  std::function<void()> Call;
  unsigned long Tag;
  int Id = 0, Spent = 0; ///< of the interactor's timers; 0: none
};

} // namespace hasp
