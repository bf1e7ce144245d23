#pragma once
#include "ScreenHand.h"

#include <chrono>
#include <optional>

#include <X11/Xlib.h>

/// Internal to ScreenHand.
struct ScreenHand::Connection
{
  explicit Connection(const std::string& name) : display(XOpenDisplay(name.c_str())) {}
  ~Connection()
  {
    if (this->display)
      XCloseDisplay(this->display);
  }
  Window Root() const { return DefaultRootWindow(this->display); }

  /// The window on top that is neither a menu nor a tip. None: there is none.
  Window Top() const;

  Display* display;
  int x = 0, y = 0;
  std::optional<std::chrono::steady_clock::time_point> pressed; ///< when, at x, y
  int pressedX = 0, pressedY = 0;
};
