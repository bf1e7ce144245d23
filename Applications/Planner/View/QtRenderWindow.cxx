#include "View/QtRenderWindow.h"

#include "vtkObjectFactory.h"

#include <QOpenGLContext>

namespace hasp
{

vtkStandardNewMacro(QtRenderWindow);

void QtRenderWindow::PushContext()
{
  QOpenGLContext* now = QOpenGLContext::currentContext();
  this->Before.emplace_back(now, now ? now->surface() : nullptr);
  this->MakeCurrent();
}

void QtRenderWindow::PopContext()
{
  const auto [context, surface] = this->Before.back();
  this->Before.pop_back();
  if (context && context != QOpenGLContext::currentContext())
    context->makeCurrent(surface);
}

} // namespace hasp
