#pragma once
#include "vtkInteractorStyle.h"

#include <functional>

namespace hasp
{

/// What the mouse did in a slice, when no tool has taken it.
struct SliceMouse
{
  enum class What
  {
    Press,
    Move,
    Release,
    Forward, ///< of the wheel, a notch
    Backward
  };
  enum class Button
  {
    None,
    Left,
    Middle,
    Right
  };
  What what;
  Button button = Button::None; ///< of a press or a release
  bool shift = false;
};

/// Hands a slice view its mouse by way of VTK's interactor: a tool that observes it before and
/// aborts the event has taken the mouse. No key does anything here.
class SliceStyle : public vtkInteractorStyle
{
public:
  static SliceStyle* New();
  vtkTypeMacro(SliceStyle, vtkInteractorStyle);

  std::function<void(const SliceMouse&)> tell;

  void OnMouseMove() override { this->Tell(SliceMouse::What::Move); }
  void OnLeftButtonDown() override { this->Tell(SliceMouse::What::Press, Left); }
  void OnLeftButtonUp() override { this->Tell(SliceMouse::What::Release, Left); }
  void OnMiddleButtonDown() override { this->Tell(SliceMouse::What::Press, Middle); }
  void OnMiddleButtonUp() override { this->Tell(SliceMouse::What::Release, Middle); }
  void OnRightButtonDown() override { this->Tell(SliceMouse::What::Press, Right); }
  void OnRightButtonUp() override { this->Tell(SliceMouse::What::Release, Right); }
  void OnMouseWheelForward() override { this->Tell(SliceMouse::What::Forward); }
  void OnMouseWheelBackward() override { this->Tell(SliceMouse::What::Backward); }
  void OnChar() override {}

private:
  static constexpr auto Left = SliceMouse::Button::Left;
  static constexpr auto Middle = SliceMouse::Button::Middle;
  static constexpr auto Right = SliceMouse::Button::Right;
  void Tell(SliceMouse::What what, SliceMouse::Button button = SliceMouse::Button::None);
};

} // namespace hasp
