#ifndef SelectionScope_h
#define SelectionScope_h

#include "vtkType.h"

class vtkHardwareSelector;
class vtkShaderProgram;

/// While one lives, VTK's selector knows which actor is drawn and has blending off. Nothing if
/// there is no selector. Threads: RENDER.
class SelectionScope
{
public:
  /// cells: their ids are less.
  SelectionScope(vtkHardwareSelector* selector, vtkIdType cells);
  ~SelectionScope();
  SelectionScope(const SelectionScope&) = delete;
  SelectionScope& operator=(const SelectionScope&) = delete;

private:
  vtkHardwareSelector* Selector;
};

/// Of SelectionColor.glsl: what this pass asks for. See vtkHardwareSelector::PassTypes.
void SetSelectionUniforms(vtkShaderProgram* program, vtkHardwareSelector* selector);

#endif
