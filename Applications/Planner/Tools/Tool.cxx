#include "Tools/Tool.h"

namespace hasp
{

void ToolBox::Take(Tool* tool)
{
  if (tool == this->Now)
    return;
  while (Tool* before = this->Now) // what one tells at its end may have another one taken
  {
    this->Now = nullptr;
    disconnect(before, nullptr, this, nullptr);
    before->End();
  }
  this->Now = tool;
  if (tool)
  {
    connect(tool, &Tool::HintChanged, this, &ToolBox::Changed);
    connect(tool, &QObject::destroyed, this,
      [this, tool]
      {
        if (this->Now == tool)
          this->Now = nullptr;
      });
    tool->Begin();
  }
  Q_EMIT this->Changed();
}

} // namespace hasp
