#include "SelectionScope.h"

#include "vtkHardwareSelector.h"
#include "vtkShaderProgram.h"

SelectionScope::SelectionScope(vtkHardwareSelector* selector, vtkIdType cells) : Selector(selector)
{
  if (!selector)
    return;
  selector->UpdateMaximumCellId(cells); // decides if high bits get a pass
  selector->BeginRenderProp();
  if (selector->GetCurrentPass() == vtkHardwareSelector::COMPOSITE_INDEX_PASS)
    selector->RenderCompositeIndex(1);
}

SelectionScope::~SelectionScope()
{
  if (this->Selector)
    this->Selector->EndRenderProp();
}

void SetSelectionUniforms(vtkShaderProgram* program, vtkHardwareSelector* selector)
{
  const int pass = selector->GetCurrentPass();
  int shift = -1;
  if (pass == vtkHardwareSelector::CELL_ID_LOW24)
    shift = 0;
  if (pass == vtkHardwareSelector::CELL_ID_HIGH24)
    shift = 24;
  float color[3] = { 0, 0, 0 }; // no id: there are no points
  if (pass != vtkHardwareSelector::POINT_ID_LOW24 && pass != vtkHardwareSelector::POINT_ID_HIGH24)
    selector->GetPropColorValue(color);
  program->SetUniformi("selectionShift", shift);
  program->SetUniform3f("selectionColor", color);
}
