#include "Window/RunPlanner.h"

#include "Devices/Drivers/DeviceList.h"
#include "Model/ErrorText.h"
#include "Model/WorkFolder.h"
#include "Output/StudyLog.h"
#include "Tools/HandDevices.h"
#include "Tools/RecordedHand.h"
#include "VtkMessages.h"
#include "Window/LayoutFile.h"
#include "Window/PlannerOptions.h"
#include "Window/PlannerScript.h"
#include "Window/PlannerWindow.h"
#include "Window/Recovery.h"
#include "Window/StudyMode.h"
#include "Window/WindowState.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QLibraryInfo>
#include <QLocale>
#include <QPointer>
#include <QSettings>
#include <QSurfaceFormat>
#include <QTimer>
#include <QTranslator>

#include <X11/Xlib.h> // last: it defines words as macros

#include <csignal>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace hasp
{
namespace
{

constexpr int QuietMs = 1000;

/// What is thrown where an event is handled goes no further: in Qt it would end the program.
class Application : public QApplication
{
public:
  using QApplication::QApplication;
  std::function<void(const QString& text, bool fault)> say;

  bool notify(QObject* receiver, QEvent* event) override
  {
    try
    {
      return QApplication::notify(receiver, event);
    }
    catch (const std::exception& error)
    {
      const QString text = PlannerWindow::tr("The last action was not finished: %1. Undo it if the "
                                             "plan is not as it should be.")
                             .arg(ErrorText(error));
      if (this->say)
        this->say(text, true);
      else
        std::cerr << "hasp-planner: " << text.toStdString() << "\n";
      return false;
    }
  }
};

/// For what VTK says, on any of its threads. What it says of each frame is told once, until it has
/// been quiet: else nothing else could be read.
VtkMessageCapture::Say Teller(Application& application, bool fault)
{
  return [&application, fault, last = std::make_shared<std::pair<std::string, QElapsedTimer>>()](
           const std::string& text)
  {
    std::cerr << "hasp-planner: " + text + "\n"; // at once: it may be the last
    QMetaObject::invokeMethod(
      &application,
      [&application, fault, last, text]
      {
        auto& [before, since] = *last;
        const bool again = text == before && since.isValid() && !since.hasExpired(QuietMs);
        before = text;
        since.start();
        if (application.say && !again)
          application.say(QString::fromStdString(text), fault);
      },
      Qt::QueuedConnection);
  };
}

/// Qt's dialogues of files keep the folders that they have shown, whose names may be patients'.
void ForgetFolders()
{
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, "/dev/null");
}

/// Qt ends the process where there is no display: ask before.
bool CanShow()
{
  const char* platform = std::getenv("QT_QPA_PLATFORM");
  if (platform && *platform && std::string(platform) != "xcb")
    return true; // who sets it knows
  Display* display = XOpenDisplay(nullptr);
  int code = 0, event = 0, error = 0;
  const bool openGL = display && XQueryExtension(display, "GLX", &code, &event, &error);
  if (display)
    XCloseDisplay(display);
  if (!openGL)
    std::cerr << (display ? "hasp-planner: the display has no OpenGL"
                          : "hasp-planner: no display; set DISPLAY to one (over ssh: ssh -X; on a "
                            "server: xvfb-run -s '-noreset' hasp-planner)")
              << "\n";
  return openGL;
}

void Translate(QApplication& application, const std::string& language)
{
  const QLocale locale = language.empty() ? QLocale() : QLocale(QString::fromStdString(language));
  // Qt has no Swedish of its own; where it has a language, its words come before ours.
  for (const auto& [file, folder] : { std::pair{ QString("hasp-planner"), QString(":/i18n") },
         std::pair{ QString("qtbase"), QString(":/i18n") },
         std::pair{ QString("qtbase"), QLibraryInfo::location(QLibraryInfo::TranslationsPath) } })
  {
    auto* translator = new QTranslator(&application);
    if (translator->load(locale, file, "_", folder))
      application.installTranslator(translator);
  }
}

/// Moves tools in place of a haptic device. Throws as ReadHapticRecording does.
void UseRecordedHand(Planner& planner, const std::string& file)
{
  const auto hand = std::make_shared<const HapticRecording>(ReadHapticRecording(file));
  planner.openDevice = [hand] { return std::make_unique<RecordedHand>(hand); };
}

HandDevices::Places DevicePlaces()
{
  return { .folders = {}, .settings = DeviceSettingsFile(), .guard = BesideProgram() };
}

int Show(Application& application, const PlannerOptions& options)
{
  WorkFolder work(options.state);
  PlannerWindow window({ options.state, options.plans }, work);
  const QPointer<Planner> parts(&window.Parts());
  application.say = [parts](const QString& text, bool fault)
  {
    if (!parts)
      return;
    if (fault)
      parts->SayFault(text);
    else
      parts->Say(text);
  };
  std::optional<HandDevices> devices;
  if (options.device.empty())
    devices.emplace(window.Parts(), DevicePlaces());
  else
    UseRecordedHand(window.Parts(), options.device);
  const auto study = BeginStudy(window, options);
  window.resize(options.size);
  window.show();
  std::optional<LayoutFile> layout;
  if (!options.layout.empty())
  {
    layout.emplace(
      options.layout, [&window] { return StateOf(window); }, [&window] { return WordsOf(window); });
    QObject::connect(&*layout, &LayoutFile::Failed, parts, &Planner::SayFault);
  }
  PlannerScript script(window, options);
  // Once the window is there: what is asked then stands before something.
  QTimer::singleShot(0, &window,
    [&]
    {
      if (options.recover && !options.IsScript())
        OfferRecovery(window);
      script.Begin();
    });
  application.exec();
  return script.ExitCode();
}

} // namespace

int RunPlanner(int argc, char* argv[])
{
  std::signal(SIGPIPE, SIG_IGN); // whoever read what is said here may be gone
  PlannerOptions options;
  int exitCode = 0;
  if (!ReadPlannerOptions(argc, argv, options, exitCode))
    return exitCode;
  if (!CanShow())
    return 4;
  QSurfaceFormat::setDefaultFormat(FrameView::defaultFormat());
  QCoreApplication::setApplicationName("hasp-planner");
  QCoreApplication::setOrganizationName({}); // nothing is kept in settings of Qt's
  QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs); // they keep more than Qt's
  int words = 1; // Qt has its own meaning for some of ours
  Application application(words, argv);
  ForgetFolders();
  // VTK's own words name files, and those may be called as patients are.
  const VtkMessageCapture vtk(Teller(application, false), Teller(application, true));
  Translate(application, options.language);
  try
  {
    return Show(application, options);
  }
  catch (const std::exception& error)
  {
    std::cerr << "hasp-planner: " << ErrorText(error).toStdString() << "\n";
    return 2;
  }
}

} // namespace hasp
