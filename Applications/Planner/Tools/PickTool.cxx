#include "Tools/PickTool.h"

#include "QVTKInteractor.h"
#include "vtkCommand.h"

namespace hasp
{

PickTool::PickTool(Planner& planner, const QString& hint, QObject* parent)
  : Tool(parent),
    Of(planner),
    Line(hint)
{
  this->Command->SetClientData(this);
  this->Command->SetCallback(
    [](vtkObject*, unsigned long, void* self, void*)
    {
      auto* tool = static_cast<PickTool*>(self);
      const vtkSmartPointer<vtkCallbackCommand> command = tool->Command.GetPointer();
      if (tool->Press())
        command->AbortFlagOn(); // it does not turn the view, too
    });
}

PickTool::~PickTool()
{
  if (this->Of.tools.InHand() == this)
    this->Of.tools.Take(nullptr);
}

void PickTool::Begin()
{
  this->Of.views.Scene().interactor()->AddObserver(
    vtkCommand::LeftButtonPressEvent, this->Command, 1.0F); // before the style
}

void PickTool::End()
{
  this->Of.views.Scene().interactor()->RemoveObserver(this->Command);
}

bool PickTool::Press()
{
  const int* at = this->Of.views.Scene().interactor()->GetEventPosition();
  const std::optional<PlanScene::Place> place = this->Of.scene.PlaceAt(at[0], at[1]);
  if (!place)
    return false;
  this->Of.tools.Take(nullptr);
  Q_EMIT this->Picked(*place);
  return true;
}

} // namespace hasp
