#include "ScreenHand.h"

#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "ScreenConnection.h" // last: X defines words as macros

#include <X11/Xutil.h>
#include <X11/extensions/XTest.h>

namespace
{

/// Qt's: two presses that are so close in time and place are a double click. A little more of both.
constexpr auto DoubleClickTime = std::chrono::milliseconds(450);
constexpr int DoubleClickPixels = 12;
constexpr int WheelUp = 4, WheelDown = 5;

/// A window may be gone before it is asked about.
int IgnoreError(Display*, XErrorEvent*)
{
  return 0;
}

} // namespace

/// The last of a window's children is on top.
Window ScreenHand::Connection::Top() const
{
  Window root = 0, parent = 0, *children = nullptr, top = None;
  unsigned int count = 0;
  if (!XQueryTree(this->display, this->Root(), &root, &parent, &children, &count))
    return None;
  for (unsigned int n = 0; n < count; ++n)
  {
    XWindowAttributes attributes{};
    if (XGetWindowAttributes(this->display, children[n], &attributes) &&
        attributes.map_state == IsViewable && !attributes.override_redirect &&
        attributes.c_class == InputOutput)
      top = children[n];
  }
  XFree(children);
  return top;
}

ScreenHand::ScreenHand(const std::string& display) : Self(std::make_unique<Connection>(display))
{
  if (!this->Self->display)
    throw std::runtime_error("the display cannot be opened");
  int event = 0, error = 0, major = 0, minor = 0;
  if (!XTestQueryExtension(this->Self->display, &event, &error, &major, &minor))
    throw std::runtime_error("the display has no XTest");
  XSetErrorHandler(IgnoreError);
  XAutoRepeatOff(this->Self->display); // a busy machine may be late with a key's release
  this->Move(1, 1);
}

ScreenHand::~ScreenHand() = default;

void ScreenHand::Move(int x, int y)
{
  XTestFakeMotionEvent(this->Self->display, -1, x, y, CurrentTime);
  XSync(this->Self->display, False);
  this->Self->x = x;
  this->Self->y = y;
}

void ScreenHand::Press(int button)
{
  XTestFakeButtonEvent(this->Self->display, button, True, CurrentTime);
  XSync(this->Self->display, False);
  ++this->Sent;
  ++this->ButtonPresses;
  this->Self->pressed = std::chrono::steady_clock::now();
  this->Self->pressedX = this->Self->x;
  this->Self->pressedY = this->Self->y;
}

void ScreenHand::Release(int button)
{
  XTestFakeButtonEvent(this->Self->display, button, False, CurrentTime);
  XSync(this->Self->display, False);
  ++this->Sent;
}

void ScreenHand::Click(int x, int y, int button)
{
  const Connection& at = *this->Self;
  if (at.pressed && std::abs(at.pressedX - x) < DoubleClickPixels &&
      std::abs(at.pressedY - y) < DoubleClickPixels)
    std::this_thread::sleep_until(*at.pressed + DoubleClickTime);
  this->Move(x, y);
  this->Press(button);
  this->Release(button);
}

void ScreenHand::DoubleClick(int x, int y)
{
  this->Click(x, y);
  this->Press();
  this->Release();
}

void ScreenHand::Drag(int fromX, int fromY, int toX, int toY, int button, int moves)
{
  this->Move(fromX, fromY);
  this->Press(button);
  for (int n = 1; n <= moves; ++n)
    this->Move(fromX + (toX - fromX) * n / moves, fromY + (toY - fromY) * n / moves);
  this->Release(button);
}

void ScreenHand::Wheel(int x, int y, int steps)
{
  this->Move(x, y);
  const unsigned int button = steps > 0 ? WheelUp : WheelDown;
  for (int n = 0; n < std::abs(steps); ++n)
  {
    XTestFakeButtonEvent(this->Self->display, button, True, CurrentTime);
    XTestFakeButtonEvent(this->Self->display, button, False, CurrentTime);
    ++this->Sent;
  }
  XSync(this->Self->display, False);
}

bool ScreenHand::SeesWindow() const
{
  return this->Self->Top() != None;
}

void ScreenHand::FillScreen()
{
  Display* display = this->Self->display;
  const int screen = DefaultScreen(display);
  XMoveResizeWindow(display, this->Self->Top(), 0, 0,
    static_cast<unsigned int>(DisplayWidth(display, screen)),
    static_cast<unsigned int>(DisplayHeight(display, screen)));
  XSync(display, False);
}

void ScreenHand::CloseWindow()
{
  Display* display = this->Self->display;
  XEvent event{};
  event.xclient.type = ClientMessage;
  event.xclient.window = this->Self->Top();
  event.xclient.message_type = XInternAtom(display, "WM_PROTOCOLS", False);
  event.xclient.format = 32;
  event.xclient.data.l[0] = static_cast<long>(XInternAtom(display, "WM_DELETE_WINDOW", False));
  XSendEvent(display, event.xclient.window, False, NoEventMask, &event);
  XSync(display, False);
}

QImage ScreenHand::Picture() const
{
  Display* display = this->Self->display;
  const int screen = DefaultScreen(display);
  const int width = DisplayWidth(display, screen), height = DisplayHeight(display, screen);
  XImage* image = XGetImage(display, this->Self->Root(), 0, 0, static_cast<unsigned int>(width),
    static_cast<unsigned int>(height), AllPlanes, ZPixmap);
  if (!image || image->bits_per_pixel != 32)
    throw std::runtime_error("the screen cannot be read: it must have 24 bits a pixel");
  const QImage picture = QImage(reinterpret_cast<const uchar*>(image->data), width, height,
    image->bytes_per_line, QImage::Format_RGB32)
                           .copy();
  XDestroyImage(image);
  return picture;
}
