#pragma once
#include <QApplication>

/// Qt for widgets that nobody sees; made once. RENDER thread.
inline void UseOffscreenQt()
{
  static int count = 1;
  static char name[] = "test", *names[] = { name, nullptr };
  if (qApp)
    return;
  qputenv("QT_QPA_PLATFORM", "offscreen");
  new QApplication(count, names); // until the process ends: Qt's own statics go before ours
}
