#ifndef FailedUpdate_h
#define FailedUpdate_h
// Private to the mappers.

#include "vtkDataObject.h"

#include <optional>

/// What an update depended on that failed. VTK asks a mapper three times a frame: nothing is tried,
/// nor said, again before there is reason to. Threads: RENDER.
class FailedUpdate
{
public:
  /// Is this an update that has failed, with nothing changed since? Else it is forgotten.
  bool Repeats(vtkObject* mapper, vtkDataObject* input)
  {
    this->Now = { mapper->GetMTime(), input ? input->GetMTime() : 0, input };
    if (this->Last != this->Now)
      this->Last.reset();
    return this->Last.has_value();
  }
  /// The update that Repeats was asked about has failed.
  void Remember() { this->Last = this->Now; }

private:
  struct Causes
  {
    vtkMTimeType mapper = 0, input = 0;
    const vtkDataObject* data = nullptr;
    bool operator==(const Causes&) const = default;
  };
  Causes Now;
  std::optional<Causes> Last;
};

#endif
