#ifndef LitActors_h
#define LitActors_h

#include "Light/LitScene.h"

#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <memory>
#include <vector>

class vtkActor;
class vtkMapper;
class vtkPropCollection;

/// The opaque actors of a renderer, in sight or not, as bodies that share light; trees are kept
/// while surfaces stay. Threads: RENDER.
class LitActors
{
public:
  /// linear: are colours sRGB, and light linear? glow: what ambient colours are multiplied by.
  /// Trees of new surfaces are made: 30 ms a million active cells, 0.2 s a million triangles.
  /// Throws std::runtime_error.
  void Update(vtkPropCollection* props, bool linear, double glow);
  /// Of the last update, in the order of the props.
  const std::vector<hasp::LitBody>& Bodies() const { return this->LastBodies; }
  /// Opaque actors that are left as they were drawn.
  int LeftOut() const { return this->LeftOutCount; }
  std::size_t TreeBytes() const;
  double TreeMilliseconds() const { return this->Milliseconds; } ///< of the last tree that was made

private:
  struct Entry
  {
    vtkWeakPointer<vtkActor> actor;
    vtkWeakPointer<vtkMapper> mapper;
    vtkMTimeType time = 0; ///< of a mesh
    bool smooth = false;
    std::shared_ptr<const hasp::ClusteredCells> cells;
    hasp::LitBody body;
  };
  Entry& EntryOf(vtkActor* actor);
  bool UpdateSurface(Entry& entry, vtkActor* actor, bool linear);
  void UpdateMaterial(Entry& entry, vtkActor* actor, bool linear, double glow);

  std::vector<Entry> Entries;
  std::vector<hasp::LitBody> LastBodies;
  bool Linear = false;
  int LeftOutCount = 0;
  double Milliseconds = 0.0;
};

/// Surface for surface, place for place: nothing has changed.
bool AreSame(const std::vector<hasp::LitBody>& a, const std::vector<hasp::LitBody>& b);

#endif
