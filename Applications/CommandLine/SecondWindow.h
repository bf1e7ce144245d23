#pragma once
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"

#include <array>
#include <functional>
#include <optional>

namespace hasp
{

/// The right eye's window of two. What happens in it happens to the main window's interactor: its
/// mouse, its keys, its close button, and that it wants to be drawn again. RENDER thread; the main
/// interactor must outlive it.
class SecondWindow
{
public:
  /// at: its place on the desktop, without borders; none: where the window manager has it.
  SecondWindow(vtkRenderWindowInteractor* main, std::array<int, 2> size,
    const std::optional<std::array<int, 2>>& at);
  ~SecondWindow();
  SecondWindow(const SecondWindow&) = delete;
  SecondWindow& operator=(const SecondWindow&) = delete;

  vtkRenderWindow* Window() { return this->Shown; }
  /// Called with true before an event with a position in this window, and with false after it.
  void OnPointer(const std::function<void(bool)>& here) { this->Here = here; }
  /// Ends its part of the event loop, which goes on as long as any interactor's does.
  void Close() { this->Own->TerminateApp(); }

private:
  void Pass(vtkObject*, unsigned long event, void*);

  vtkRenderWindowInteractor* Main;
  vtkNew<vtkRenderWindow> Shown;
  vtkNew<vtkRenderWindowInteractor> Own;
  std::function<void(bool)> Here;
};

} // namespace hasp
