#pragma once
#include <QGroupBox>
#include <QVBoxLayout>

namespace hasp
{

/// A frame with a title around widgets, one below the other, at the end of a column. RENDER.
template <typename... Widgets>
QGroupBox* AddGroup(QBoxLayout* column, const QString& title, Widgets*... widgets)
{
  auto* group = new QGroupBox(title);
  auto* inside = new QVBoxLayout(group);
  (inside->addWidget(widgets), ...);
  column->addWidget(group);
  return group;
}

} // namespace hasp
