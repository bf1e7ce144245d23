#pragma once
#include "vtkWeakPointer.h"

#include <vector>

class vtkProp;

namespace hasp
{

class FrameView;

/// Props that are not drawn while something else is seen in their place. They are what they were
/// for all who ask the scene: visible, and moved by hands. Threads: RENDER.
class PropCover
{
public:
  explicit PropCover(FrameView& view) : In(view) {}
  ~PropCover() { this->Set({}); }
  PropCover(const PropCover&) = delete;
  PropCover& operator=(const PropCover&) = delete;

  /// These and no others, of the view.
  void Set(const std::vector<vtkProp*>& props);

private:
  FrameView& In;
  std::vector<vtkWeakPointer<vtkProp>> Covered;
};

} // namespace hasp
