#pragma once
#include <cstdint>
#include <type_traits>

/// What hasp-xml-decode and hasp-3mf-decode write to their standard output, in the machine's own
/// byte order: any number of XMLFrames that say it is busy, one that says the answer is next, the
/// record asked for, and what follows that. Nothing in it is trusted by the reading side.
///
/// Standard input: the file's path, ended by a NUL. Arguments: image-header|image|surface (of 3MF
/// surface alone), memory in bytes, processor seconds. Exit code 3: out of memory.
namespace hasp
{

struct XMLFrame
{
  static constexpr std::uint32_t Magic = 0x31465848; // "HXF1"
  enum Kind : std::uint32_t
  {
    Busy,
    Answer
  };

  std::uint32_t magic;
  std::uint32_t kind;
  double share; ///< of the file that has been read, in [0,1]
};

enum class XMLStatus : std::uint32_t
{
  Good,
  Damaged,   ///< the reader reports an error
  NoScalars, ///< an image without active point scalars
  TooFew,    ///< samples that do not fill the image's extent
  TooMany,   ///< a 3MF that builds more than 100,000 objects, or of components 64 deep
  Last = TooMany
};

/// With image-header no samples follow. Extent, origin, spacing and direction (by rows) are VTK's.
struct XMLImageRecord
{
  std::uint32_t status; ///< all else is 0 unless it is Good
  std::int32_t vtkType, components;
  std::int32_t extent[6];
  std::uint32_t reserved; ///< 0
  double origin[3], spacing[3], direction[9];
  std::uint64_t sampleBytes; ///< that follow
};

/// `points` times three coordinates follow, then for each face 32-bit words: how many corners it
/// has, and their points from 0. Strips have become triangles.
struct XMLSurfaceRecord
{
  std::uint32_t status;                      ///< all else is 0 unless it is Good
  std::uint32_t coordinateBytes;             ///< 4: float32, 8: float64
  std::uint32_t saysLps, saysRas, saysOther; ///< 1 or 0: the field data's SPACE
  std::uint32_t reserved;                    ///< 0
  std::uint64_t points, faces, corners;      ///< corners of all faces together
  std::uint64_t otherCells;                  ///< vertices and lines, left out
};

/// `objects` records follow, each with its points, three doubles each in the file's unit and where
/// it is built, and its triangles, three 32-bit words each, from 0 in its own points.
struct ThreeMfRecord
{
  static constexpr std::uint32_t MostObjects = 100'000;
  std::uint32_t status;  ///< all else is 0 unless it is Good
  std::uint32_t unit;    ///< 0 micrometre, 1 mm, 2 cm, 3 inch, 4 foot, 5 metre
  std::uint32_t objects; ///< that are built, each time one
  std::uint32_t reserved;
  std::uint64_t points, triangles; ///< of all objects together
  char description[256];           ///< the metadata of that name, cut off, with a NUL at its end
};
struct ThreeMfObject
{
  std::uint64_t points, triangles;
  char name[32]; ///< cut off, with a NUL at its end
};

static_assert(std::is_trivially_copyable_v<ThreeMfRecord> && sizeof(ThreeMfRecord) == 288);
static_assert(std::is_trivially_copyable_v<ThreeMfObject> && sizeof(ThreeMfObject) == 48);
static_assert(std::is_trivially_copyable_v<XMLFrame> && sizeof(XMLFrame) == 16);
static_assert(
  std::is_trivially_copyable_v<XMLImageRecord> && sizeof(XMLImageRecord) == 40 + 15 * 8 + 8);
static_assert(std::is_trivially_copyable_v<XMLSurfaceRecord> && sizeof(XMLSurfaceRecord) == 56);

} // namespace hasp
