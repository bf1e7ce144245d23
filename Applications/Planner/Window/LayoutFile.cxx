#include "Window/LayoutFile.h"

#include "Window/LayoutNames.h"
#include "Window/LayoutWidgets.h"

#include <nlohmann/json.hpp>

#include <QAbstractButton>
#include <QApplication>
#include <QEvent>
#include <QTabBar>
#include <QTabWidget>
#include <QWidget>

#include <algorithm>
#include <fstream>

namespace hasp
{
namespace
{

constexpr int LeastMs = 50; // between two files
constexpr int DownMs = 200; // for 100 ms a button is down that a key has pressed
constexpr int NoisyMs = 2;  // until it is looked again whether more has come

nlohmann::ordered_json NameOrNull(const QWidget* widget)
{
  const QString name = widget ? LayoutName(*widget) : QString();
  return name.isEmpty() ? nlohmann::ordered_json(nullptr)
                        : nlohmann::ordered_json(name.toStdString());
}

/// A bar of tabs has the keyboard for the pages that it is of.
nlohmann::ordered_json DescribeFocus()
{
  const QWidget* focus = QApplication::focusWidget();
  const bool tabs =
    qobject_cast<const QTabBar*>(focus) && qobject_cast<const QTabWidget*>(focus->parentWidget());
  return NameOrNull(tabs ? focus->parentWidget() : focus);
}

nlohmann::ordered_json DescribeModal()
{
  const QWidget* modal = QApplication::activeModalWidget();
  if (!modal)
    return nullptr;
  return { { "name", NameOrNull(modal) }, { "class", modal->metaObject()->className() },
    { "title", modal->windowTitle().toStdString() } };
}

bool IsAnyButtonDown()
{
  const QWidgetList widgets = QApplication::allWidgets();
  return std::any_of(widgets.begin(), widgets.end(),
    [](const QWidget* widget)
    {
      const auto* button = qobject_cast<const QAbstractButton*>(widget);
      return button && button->isDown() && button->isVisible();
    });
}

} // namespace

LayoutFile::LayoutFile(std::filesystem::path file, State state, UserWords words, QObject* parent)
  : QObject(parent),
    File(std::move(file)),
    Of(std::move(state)),
    Words(std::move(words))
{
  this->Looking.setSingleShot(true);
  this->Looking.setTimerType(Qt::PreciseTimer);
  connect(&this->Looking, &QTimer::timeout, this, &LayoutFile::Look);
  this->Noise.start();
  this->Looking.start(0);
  qApp->installEventFilter(this);
}

LayoutFile::~LayoutFile()
{
  std::error_code ignored; // it is not there if it could not be written
  std::filesystem::remove(this->File, ignored);
}

bool LayoutFile::eventFilter(QObject* watched, QEvent* event)
{
  if (watched == &this->Looking)
    return false;
  this->Count(watched, event);
  // A tool that is held has a clock that ticks for as long. What a tick does brings other events.
  this->Seen += event->type() == QEvent::Timer ? 0 : 1;
  if (!this->Looking.isActive())
  {
    this->Noise.start();
    this->Looking.start(NoisyMs);
  }
  return false;
}

/// Inputs come to a window first, and from there to widgets, one after the other.
void LayoutFile::Count(QObject* watched, QEvent* event)
{
  if (!watched->isWindowType() || !event->spontaneous())
    return;
  switch (event->type())
  {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::Wheel:
      ++this->Events;
      this->Input.start();
      break;
    case QEvent::ShortcutOverride: // comes before the key itself, which a shortcut swallows
      this->Overridden = true;
      ++this->Events;
      this->Input.start();
      break;
    case QEvent::KeyPress:
      this->Events += this->Overridden ? 0 : 1;
      this->Overridden = false;
      break;
    default:
      break;
  }
}

void LayoutFile::Look()
{
  const bool quiet = this->Seen == this->SeenAtLook;
  this->SeenAtLook = this->Seen;
  if (!quiet && this->Noise.elapsed() < LeastMs)
    return this->Looking.start(NoisyMs);
  if (this->Wrote.isValid() && this->Wrote.elapsed() < LeastMs)
    return this->Looking.start(static_cast<int>(LeastMs - this->Wrote.elapsed()));
  const std::string text = this->Describe(quiet);
  // A blinking cursor alone is no reason to say that it is not settled.
  if (text != this->Last && (quiet || this->Describe(true) != this->Last))
    this->Write(text);
  if (!quiet || this->ComesUpSoon())
    this->Looking.start(LeastMs);
}

/// A button comes up by itself, and does then what it is for. Some are down for good.
bool LayoutFile::ComesUpSoon() const
{
  return this->Input.isValid() && this->Input.elapsed() < DownMs &&
         QApplication::mouseButtons() == Qt::NoButton && IsAnyButtonDown();
}

std::string LayoutFile::Describe(bool quiet) const
{
  nlohmann::ordered_json state = this->Of ? this->Of() : nlohmann::ordered_json::object();
  state["events"] = this->Events;
  state["settled"] =
    quiet && !state.value("busy", false) && !state.value("pending", false) && !this->ComesUpSoon();
  const nlohmann::ordered_json layout{ { "format", "hasp-layout-1" }, { "state", state },
    { "modal", DescribeModal() }, { "popup", NameOrNull(QApplication::activePopupWidget()) },
    { "focus", DescribeFocus() },
    { "widgets", DescribeWidgets(this->Words ? this->Words() : QStringList()) } };
  return layout.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void LayoutFile::Write(const std::string& text)
{
  this->Wrote.start();
  std::filesystem::path temporary = this->File;
  temporary += ".part";
  std::error_code error;
  if (std::ofstream(temporary, std::ios::binary | std::ios::trunc) << text << std::flush)
    std::filesystem::rename(temporary, this->File, error);
  else
    error = std::make_error_code(std::errc::io_error);
  if (!error)
    this->Last = text;
  else if (!this->Told)
  {
    this->Told = true;
    Q_EMIT this->Failed(
      tr("The layout file cannot be written: give --layout a place that can be, or "
         "free space on its disk."));
  }
}

} // namespace hasp
