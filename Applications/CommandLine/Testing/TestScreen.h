#pragma once
#include <sys/types.h>

#include <string>
#include <vector>

/// A screen of Xvfb, of its own display, while it lives. Display() is empty where Xvfb is not
/// installed. `more`: words of Xvfb's; `size`: pixels.
class TestScreen
{
public:
  explicit TestScreen(
    const std::vector<std::string>& more = {}, const std::string& size = "800x600");
  ~TestScreen();
  TestScreen(const TestScreen&) = delete;
  void operator=(const TestScreen&) = delete;
  const std::string& Display() const { return this->Name; }

private:
  pid_t Server = 0;
  std::string Name;
};

/// A user in front of a screen: sees the first window that opens after it was made.
class ScreenUser
{
public:
  explicit ScreenUser(const std::string& display);
  ~ScreenUser();
  ScreenUser(const ScreenUser&) = delete;
  void operator=(const ScreenUser&) = delete;

  /// Waits for the window, a minute at most; its title. Throws std::runtime_error.
  std::string SeeWindow();
  void Press(unsigned long keySym);
  /// The left button, down at one place and up at another, where the pointer was not yet; pixels
  /// from the upper left. Waits until the program listens to the mouse.
  void Drag(int fromX, int fromY, int toX, int toY);
  /// As a window manager's close button.
  void CloseWindow();

private:
  struct Connection;
  Connection* Self;
};
