#pragma once
#include <QImage>

#include <cstddef>
#include <memory>
#include <string>

/// A hand at a screen: the pointer and the keys of an X display, by events that no program can tell
/// from a mouse's and a keyboard's (XTest). Pixels from the upper left. What it does has been done
/// by the display when a function returns, and may not have reached a program yet.
///
/// There is no window manager on a screen of Xvfb: the window on top gets the keys here. Throws
/// std::runtime_error where the display cannot be opened or has no XTest.
class ScreenHand
{
public:
  explicit ScreenHand(const std::string& display);
  ~ScreenHand();
  ScreenHand(const ScreenHand&) = delete;
  void operator=(const ScreenHand&) = delete;

  void Move(int x, int y);
  ///@{
  /// Buttons: 1 left, 2 middle, 3 right.
  void Press(int button = 1);
  void Release(int button = 1);
  /// Never half of a double click: waits for as long as that takes where it would be one.
  void Click(int x, int y, int button = 1);
  void DoubleClick(int x, int y);
  /// Down at one place, along a line in so many moves, up at its end.
  void Drag(int fromX, int fromY, int toX, int toY, int button = 1, int moves = 12);
  ///@}
  /// So many steps, upwards if positive.
  void Wheel(int x, int y, int steps);

  ///@{
  /// "a", "Return", "Escape", "F1", "ctrl+shift+z", "alt+f": names of X key symbols, and modifiers.
  /// Throws std::runtime_error on a key that the keyboard lacks.
  void Key(const std::string& keys);
  void HoldKey(const std::string& key);
  void LetGoOfKey(const std::string& key);
  void Type(const std::string& latin1);
  ///@}

  bool SeesWindow() const; ///< any, but menus and tips
  void FillScreen();       ///< with the window on top
  void CloseWindow();      ///< on top, as a window manager's close button
  QImage Picture() const;  ///< of the whole screen

  std::size_t Clicks() const { return this->ButtonPresses; } ///< of buttons so far
  std::size_t Keys() const { return this->KeyPresses; }      ///< but for modifiers
  /// Events that a layout file counts: presses and releases of buttons, keys' presses, wheel.
  unsigned long long Events() const { return this->Sent; }

private:
  void FocusTop();
  void KeyCode(unsigned char code, bool down);

  struct Connection;
  std::unique_ptr<Connection> Self;
  std::size_t ButtonPresses = 0, KeyPresses = 0;
  unsigned long long Sent = 0;
};
