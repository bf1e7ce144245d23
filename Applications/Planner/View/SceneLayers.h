#pragma once
#include "View/BladeProps.h"
#include "View/BrightestVolume.h"
#include "View/FragmentProps.h"
#include "View/GhostProps.h"
#include "View/MeasureProps.h"
#include "View/PartProps.h"
#include "View/ScanSurface.h"
#include "View/SkinSurface.h"
#include "View/SurfaceProps.h"

#include "vtkBoundingBox.h"

#include <array>

namespace hasp
{

/// All that a scene is made of. Threads: RENDER.
struct SceneLayers
{
  explicit SceneLayers(SceneContext& of)
    : fragments(of),
      scan(of),
      skin(of, this->scan),
      brightest(of, this->scan),
      surfaces(of),
      parts(of),
      ghosts(of),
      blades(of),
      measures(of)
  {
  }
  /// The scan after the fragments, on which it rests whether it is seen; measures last, for they
  /// follow what is there.
  std::array<SceneLayer*, 9> All()
  {
    return { &this->fragments, &this->scan, &this->skin, &this->brightest, &this->surfaces,
      &this->parts, &this->ghosts, &this->blades, &this->measures };
  }
  /// Around bone.
  vtkBoundingBox BoneBounds() const
  {
    vtkBoundingBox box;
    this->fragments.AddBounds(box);
    this->scan.AddBounds(box);
    this->surfaces.AddBounds(box);
    return box;
  }
  /// Around all but blades, which are larger than what they cut, and measures; around these where
  /// there is nothing else.
  vtkBoundingBox Bounds() const
  {
    vtkBoundingBox box = this->BoneBounds();
    this->skin.AddBounds(box);
    this->brightest.AddBounds(box);
    this->parts.AddBounds(box);
    this->ghosts.AddBounds(box);
    if (!box.IsValid())
    {
      this->blades.AddBounds(box);
      this->measures.AddBounds(box);
    }
    return box;
  }
  void Forget() ///< another plan
  {
    this->fragments.Forget();
    this->scan.Forget();
    this->skin.Forget();
    this->parts.Forget();
    this->ghosts.Forget();
  }

  FragmentProps fragments;
  ScanSurface scan;
  SkinSurface skin;
  BrightestVolume brightest;
  SurfaceProps surfaces;
  PartProps parts;
  GhostProps ghosts;
  BladeProps blades;
  MeasureProps measures;
};

} // namespace hasp
