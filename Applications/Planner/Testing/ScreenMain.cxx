// Runs cases with Qt on a screen of their own; without Xvfb they say so and are skipped.
#include "TestScreen.h"

#include <QApplication>
#include <QSurfaceFormat>
#include <QVTKOpenGLNativeWidget.h>

#include <gtest/gtest.h>

#include <cstdlib>

namespace
{

class NoScreen : public testing::Environment
{
  void SetUp() override { GTEST_SKIP() << "Xvfb is not installed"; }
};

} // namespace

int main(int argc, char* argv[])
{
  testing::InitGoogleTest(&argc, argv);
  if (testing::GTEST_FLAG(list_tests))
    return RUN_ALL_TESTS();
  const TestScreen screen({ "-screen", "0", "1280x1024x24" });
  if (screen.Display().empty())
  {
    testing::AddGlobalTestEnvironment(new NoScreen);
    return RUN_ALL_TESTS();
  }
  setenv("DISPLAY", screen.Display().c_str(), 1);
  setenv("QT_QPA_PLATFORM", "xcb", 1);
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication application(argc, argv);
  QLocale::setDefault(QLocale::c());
  return RUN_ALL_TESTS();
}
