#pragma once
#include "vtkCallbackCommand.h"
#include "vtkNew.h"

#include <array>
#include <functional>

class vtkRenderWindowInteractor;

namespace hasp
{

class StereoView;

/// Where eyes are placed apart, turned over or bent by a lens, gives mouse events the position in
/// the eye's view, scaled to the window: widgets, trackball and the mouse as a head then find
/// things where the user sees them. A drag goes on where it leaves the eye's part of the window;
/// where it leaves what a lens shows, it stays until it comes back. RENDER thread; interactor and
/// eyes must outlive it.
class ViewPointer
{
public:
  /// eyes: null for an ordinary window, in which nothing changes. before: called before each event
  /// that is changed.
  ViewPointer(vtkRenderWindowInteractor* interactor, const StereoView* eyes,
    const std::function<void()>& before);
  ~ViewPointer();
  ViewPointer(const ViewPointer&) = delete;
  ViewPointer& operator=(const ViewPointer&) = delete;

  /// Of the window, where the last event was: what the interactor itself had.
  std::array<int, 2> WindowPixel() const;

private:
  void Map(unsigned long event);

  using Pixel = std::array<int, 2>;
  vtkRenderWindowInteractor* Interactor;
  const StereoView* Eyes;
  std::function<void()> Before;
  Pixel InWindow{ -1, -1 }, InView{ -1, -1 }; ///< of the last mouse event
  int Buttons = 0;                            ///< that are down
  bool RightEye = false;                      ///< where the first of them went down
  vtkNew<vtkCallbackCommand> First;
};

} // namespace hasp
