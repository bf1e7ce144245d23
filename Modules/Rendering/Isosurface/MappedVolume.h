#ifndef MappedVolume_h
#define MappedVolume_h

#include "Grid/MinMaxBlocks.h"
#include "vtkHaspRenderingIsosurfaceModule.h" // for export macro

#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <array>
#include <limits>

class vtkImageData;

/// The volume a mapper draws: what of it is kept from frame to frame, and which of its samples have
/// changed in place. Private to the mappers. Threads: RENDER.
class VTKHASPRENDERINGISOSURFACE_EXPORT MappedVolume
{
public:
  /// Makes the min-max blocks if this is another image than the last, or has been modified; true
  /// then, and no change is remembered. Throws std::invalid_argument if it cannot be drawn.
  bool Update(vtkImageData* image);
  void Forget() { *this = {}; }

  /// MarkModified of the mappers. False if nothing is kept that could be stale.
  bool Mark(vtkImageData* image, const int extent[6]);
  /// The same where another array than the samples has changed. Joins the extent to a box of
  /// samples, low to high.
  bool MarkOther(vtkImageData* image, const int extent[6], glm::ivec3& low, glm::ivec3& high);
  bool Changed() const { return this->Low.x <= this->High.x; }
  void ForgetChanges();
  /// First and last sample that has changed, if any has.
  const glm::ivec3& ChangedLow() const { return this->Low; }
  const glm::ivec3& ChangedHigh() const { return this->High; }

  /// Between the least and the largest sample; 0 if none is a number.
  double MiddleOfRange() const;

  hasp::MinMaxBlocks Blocks;
  double BlocksMilliseconds = 0.0;

private:
  /// Where an image has its samples, and where these lie in space.
  struct Place
  {
    std::array<int, 6> extent{};
    std::array<double, 15> geometry{}; ///< origin, spacing, direction
    int type = 0;                      ///< VTK_VOID
    const void* samples = nullptr;
    bool operator==(const Place&) const = default;
  };
  static Place PlaceOf(vtkImageData* image);

  vtkWeakPointer<vtkImageData> Image; ///< the blocks were made from, and
  vtkMTimeType ImageTime = 0;         ///< when: images that share their samples share MTimes, too
  Place ImagePlace;                   ///< then
  glm::ivec3 Low{ std::numeric_limits<int>::max() };
  glm::ivec3 High{ std::numeric_limits<int>::min() };
};

#endif
