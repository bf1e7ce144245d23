#pragma once
#include "vtkSmartPointer.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkImageData;

namespace hasp
{

/// A volume and an isovalue that clustered cells are measured on.
struct CellScene
{
  std::string tag;  ///< ends the rows' ids: "" on the data that the bars name, else "@gyroid256"
  std::string data; ///< "phantom head, 256^3 int16, 300 HU"
  vtkSmartPointer<vtkImageData> image;
  double isovalue = 0.0;
};

/// The head of Grid/Phantom.h as a scanner shows it: blurred by 0.8 mm, 25 HU of noise from `seed`,
/// bone at 300 HU. n^3 samples, int16. Without a tag if `named`.
CellScene HeadScene(int n, std::uint64_t seed, bool named = false);
/// Four periods of a gyroid, and spongy bone of ten periods in a shell: int16, from closed forms.
CellScene GyroidScene(int n);
CellScene SpongyBoneScene(int n);

} // namespace hasp
