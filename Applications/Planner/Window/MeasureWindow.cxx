#include "Window/MeasureWindow.h"

#include "View/FrameView.h"
#include "Window/PlannerWindow.h"

#include "vtkRenderWindow.h"

#include <QApplication>
#include <QEvent>

#include <unistd.h>

#include <cmath>
#include <ctime>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{
constexpr int EventsMs = 20;

template <typename Done>
void Wait(double mostS, const Done& done)
{
  const auto start = Clock::now();
  while (!done())
  {
    QApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents, EventsMs);
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); // as the outermost loop does
    if (MsSince(start) > 1e3 * mostS)
      throw std::runtime_error("the window does not come to rest");
  }
}
} // namespace

double MsSince(Clock::time_point start)
{
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double SinceStartS()
{
  // Its 22nd word is when the process started, in ticks since the machine did; names end with ).
  std::ifstream file("/proc/self/stat");
  std::string text((std::istreambuf_iterator<char>(file)), {});
  std::istringstream words(text.substr(text.rfind(')') + 1));
  std::string word;
  for (int n = 3; n <= 22; ++n)
    words >> word;
  timespec now{};
  clock_gettime(CLOCK_BOOTTIME, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec) -
         std::stod(word) / double(sysconf(_SC_CLK_TCK));
}

void WaitSettled(PlannerWindow& window)
{
  QTimer wake; // events must come for time to be looked at
  wake.start(EventsMs);
  QApplication::processEvents();
  Wait(120.0, [&] { return window.IsSettled(); });
}

void FinishDrawing(FrameView& view)
{
  view.makeCurrent();
  view.renderWindow()->WaitForCompletion();
}

void WaitFrame(FrameView& view)
{
  const unsigned long long before = view.Frames();
  QTimer wake;
  wake.start(EventsMs);
  Wait(10.0, [&] { return view.Frames() != before; });
  FinishDrawing(view);
}

double DrawnMs(FrameView& view)
{
  const auto start = Clock::now();
  view.Draw();
  WaitFrame(view);
  return MsSince(start);
}

void Spend(double seconds)
{
  const auto start = Clock::now();
  QTimer wake;
  wake.start(EventsMs);
  Wait(seconds + 60.0, [&] { return MsSince(start) > 1e3 * seconds; });
}

double RmsBetween(const QImage& picture, const QImage& full)
{
  const QImage a = picture.scaled(full.size()).convertToFormat(QImage::Format_RGB32);
  const QImage b = full.convertToFormat(QImage::Format_RGB32);
  double squares = 0.0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
    {
      const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
      for (const int d : { qRed(p) - qRed(q), qGreen(p) - qGreen(q), qBlue(p) - qBlue(q) })
        squares += double(d) * d;
    }
  return std::sqrt(squares / (3.0 * a.width() * a.height()));
}

std::size_t ResidentBytes()
{
  std::size_t pages = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> pages >> resident;
  return resident * std::size_t(sysconf(_SC_PAGESIZE));
}

} // namespace hasp
