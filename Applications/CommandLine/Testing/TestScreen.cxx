#include "TestScreen.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>

#include <X11/Xlib.h> // last: it defines words as macros
#include <X11/Xutil.h>

extern char** environ;

namespace
{

constexpr int DisplayFd = 3; // of the server
constexpr int MostWaitMs = 60'000;

} // namespace

TestScreen::TestScreen(const std::vector<std::string>& more, const std::string& size)
{
  // Without -noreset it would reset when a program's first window closes.
  std::vector<std::string> words{ "Xvfb", "-displayfd", std::to_string(DisplayFd), "-screen", "0",
    size + "x24", "-noreset", "-nolisten", "tcp" };
  words.insert(words.end(), more.begin(), more.end());
  std::vector<char*> pointers;
  for (std::string& word : words)
    pointers.push_back(word.data());
  pointers.push_back(nullptr);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    throw std::runtime_error("no pipe");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  if (ends[1] == DisplayFd) // dup2 onto itself would leave it closed there
    posix_spawn_file_actions_adddup2(&actions, ends[1], DisplayFd + 10);
  posix_spawn_file_actions_adddup2(
    &actions, ends[1] == DisplayFd ? DisplayFd + 10 : ends[1], DisplayFd);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  const int failed =
    posix_spawnp(&this->Server, "Xvfb", &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  std::string number;
  char letter = 0; // the server writes its number when it is ready, and "\n"
  while (!failed && read(ends[0], &letter, 1) == 1 && letter != '\n')
    number += letter;
  close(ends[0]);
  if (failed)
    this->Server = 0;
  else if (number.empty())
    throw std::runtime_error("Xvfb ended");
  else
    this->Name = ":" + number;
}

TestScreen::~TestScreen()
{
  if (this->Server == 0)
    return;
  kill(this->Server, SIGTERM);
  waitpid(this->Server, nullptr, 0);
}

struct ScreenUser::Connection
{
  Display* display;
  Window window = 0;
};

ScreenUser::ScreenUser(const std::string& display)
  : Self(new Connection{ XOpenDisplay(display.c_str()) })
{
  if (!this->Self->display)
    throw std::runtime_error("cannot open the display");
  XSelectInput(this->Self->display, DefaultRootWindow(this->Self->display), SubstructureNotifyMask);
  XSync(this->Self->display, False);
}

ScreenUser::~ScreenUser()
{
  XCloseDisplay(this->Self->display);
  delete this->Self;
}

std::string ScreenUser::SeeWindow()
{
  Display* display = this->Self->display;
  pollfd events{ ConnectionNumber(display), POLLIN, 0 };
  XEvent event;
  do
  {
    if (XPending(display) == 0 && poll(&events, 1, MostWaitMs) != 1)
      throw std::runtime_error("no window opened");
    XNextEvent(display, &event);
  } while (event.type != MapNotify);
  this->Self->window = event.xmap.window;
  char* name = nullptr;
  XFetchName(display, this->Self->window, &name);
  const std::string title = name ? name : "";
  XFree(name);
  return title;
}

void ScreenUser::Press(unsigned long keySym)
{
  Display* display = this->Self->display;
  XEvent event{};
  event.xkey.type = KeyPress;
  event.xkey.display = display;
  event.xkey.window = this->Self->window;
  event.xkey.root = DefaultRootWindow(display);
  event.xkey.same_screen = True;
  event.xkey.keycode = XKeysymToKeycode(display, keySym);
  XSendEvent(display, this->Self->window, True, KeyPressMask, &event);
  XFlush(display);
}

void ScreenUser::Drag(int fromX, int fromY, int toX, int toY)
{
  Display* display = this->Self->display;
  const Window window = this->Self->window;
  XWindowAttributes attributes{};
  while (!(attributes.all_event_masks & ButtonPressMask)) // else nobody would get it
    XGetWindowAttributes(display, window, &attributes);
  const auto button = [&](int type, long mask, int x, int y)
  {
    XEvent event{};
    event.xbutton = { type, 0, False, display, window, DefaultRootWindow(display), None,
      CurrentTime, x, y, 0, 0, 0, Button1, True };
    XSendEvent(display, window, True, mask, &event);
  };
  button(ButtonPress, ButtonPressMask, fromX, fromY);
  XWarpPointer(display, None, window, 0, 0, 0, 0, toX, toY); // VTK asks where the pointer is
  XSync(display, False);
  button(ButtonRelease, ButtonReleaseMask, toX, toY);
  XFlush(display);
}

void ScreenUser::CloseWindow()
{
  Display* display = this->Self->display;
  XEvent event{};
  event.xclient.type = ClientMessage;
  event.xclient.window = this->Self->window;
  event.xclient.message_type = XInternAtom(display, "WM_PROTOCOLS", False);
  event.xclient.format = 32;
  event.xclient.data.l[0] = static_cast<long>(XInternAtom(display, "WM_DELETE_WINDOW", False));
  XSendEvent(display, this->Self->window, False, NoEventMask, &event);
  XFlush(display);
}
