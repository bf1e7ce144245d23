#ifndef HapticInteractorInternals_h
#define HapticInteractorInternals_h

#include "HapticDrawing.h"
#include "HapticGrab.h"
#include "HapticInput.h"
#include "HapticProps.h"
#include "vtkHaspHapticInteractor.h"
#include "vtkHaspHapticLoop.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkWeakPointer.h"

#include <cstdint>

/// What vtkHaspHapticInteractor.cxx (what is said) and HapticInteractorFrame.cxx (what a frame
/// does) share. Threads: RENDER.
struct vtkHaspHapticInteractor::Internals
{
  vtkNew<vtkHaspHapticLoop> loop;
  hasp::HapticProps props;
  hasp::HapticGrab grab;
  hasp::HapticDrawing drawing;
  hasp::HapticInput input;
  vtkWeakPointer<vtkRenderer> renderer;
  vtkWeakPointer<vtkRenderWindowInteractor> interactor;
  vtkNew<vtkCallbackCommand> timer;
  int timerId = 0;
  std::uint32_t buttons = 0;
  std::uint64_t yieldedAt = 0; ///< tick
  bool touching = false, wasBaking = false, placed = false, faulty = false;
  bool stands = false; ///< SetDeviceToWorld has put CameraRelative off

  void EndTimer()
  {
    if (this->interactor)
    {
      this->interactor->RemoveObserver(this->timer);
      if (this->timerId != 0)
        this->interactor->DestroyTimer(this->timerId);
    }
    this->timerId = 0;
    this->interactor = nullptr;
  }
};

#endif
