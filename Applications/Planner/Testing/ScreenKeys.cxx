#include "ScreenHand.h"

#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "ScreenConnection.h" // last: X defines words as macros

#include <X11/XKBlib.h>
#include <X11/extensions/XTest.h>
#include <X11/keysym.h>

namespace
{

KeySym SymbolOf(const std::string& key)
{
  if (key == "ctrl")
    return XK_Control_L;
  if (key == "shift")
    return XK_Shift_L;
  if (key == "alt")
    return XK_Alt_L;
  // Latin-1's letters are their own symbols.
  const KeySym symbol =
    key.size() == 1 ? static_cast<unsigned char>(key.front()) : XStringToKeysym(key.c_str());
  if (symbol == NoSymbol)
    throw std::runtime_error("there is no key " + key);
  return symbol;
}

/// The key, and whether shift is needed for that symbol.
std::pair<KeyCode, bool> FindKey(Display* display, KeySym symbol)
{
  const KeyCode code = XKeysymToKeycode(display, symbol);
  for (const unsigned int level : { 0U, 1U })
    if (code != 0 && XkbKeycodeToKeysym(display, code, 0, level) == symbol)
      return { code, level == 1 };
  throw std::runtime_error("the keyboard has no key for symbol " + std::to_string(symbol));
}

} // namespace

/// As a window manager: what is on top has the keyboard.
void ScreenHand::FocusTop()
{
  Display* display = this->Self->display;
  const Window top = this->Self->Top();
  Window focused = None;
  int revert = 0;
  XGetInputFocus(display, &focused, &revert);
  if (top == None || top == focused)
    return;
  XSetInputFocus(display, top, RevertToPointerRoot, CurrentTime);
  XSync(display, False);
}

void ScreenHand::KeyCode(unsigned char code, bool down)
{
  XTestFakeKeyEvent(this->Self->display, code, down ? True : False, CurrentTime);
  this->Sent += down ? 1 : 0;
}

void ScreenHand::HoldKey(const std::string& key)
{
  this->FocusTop();
  this->KeyCode(FindKey(this->Self->display, SymbolOf(key)).first, true);
  XSync(this->Self->display, False);
}

void ScreenHand::LetGoOfKey(const std::string& key)
{
  this->KeyCode(FindKey(this->Self->display, SymbolOf(key)).first, false);
  XSync(this->Self->display, False);
}

void ScreenHand::Key(const std::string& keys)
{
  std::vector<unsigned char> codes;
  std::istringstream parts(keys == "+" ? "plus" : keys);
  for (std::string part; std::getline(parts, part, '+');)
  {
    const auto [code, shifted] = FindKey(this->Self->display, SymbolOf(part));
    if (shifted)
      codes.push_back(FindKey(this->Self->display, XK_Shift_L).first);
    codes.push_back(code);
  }
  this->FocusTop();
  for (const unsigned char code : codes)
    this->KeyCode(code, true);
  for (auto code = codes.rbegin(); code != codes.rend(); ++code)
    this->KeyCode(*code, false);
  ++this->KeyPresses;
  XSync(this->Self->display, False);
}

void ScreenHand::Type(const std::string& latin1)
{
  for (const char letter : latin1)
    this->Key(letter == '+' ? "plus" : letter == '\n' ? "Return" : std::string(1, letter));
}
