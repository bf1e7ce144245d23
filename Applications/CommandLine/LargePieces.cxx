#include "LargePieces.h"

#include "Distance/Coverage.h"
#include "Failure.h"
#include "Session.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <sstream>

namespace hasp
{
namespace
{

/// The largest value of the sample type below the isovalue.
template <typename T>
T JustBelow(double isovalue)
{
  if constexpr (std::numeric_limits<T>::is_integer)
    return static_cast<T>(std::ceil(isovalue) - 1.0);
  else
    return std::nextafter(static_cast<T>(isovalue), std::numeric_limits<T>::lowest());
}

} // namespace

vtkSmartPointer<vtkImageData> LargePiecesOf(vtkImageData* image, double isovalue, double leastMm3)
{
  const AnyGridView grid = ViewImage(image);
  const std::vector<std::uint8_t> keep = KeepLargePieces(grid, isovalue, leastMm3);
  if (std::find(keep.begin(), keep.end(), 1) == keep.end())
    return nullptr;
  return std::visit(
    [&]<typename T>(const GridView<const T>& view)
    {
      std::vector<T> samples(view.data, view.data + keep.size());
      for (std::size_t n = 0; n < keep.size(); ++n)
        if (!keep[n] && samples[n] >= isovalue)
          samples[n] = JustBelow<T>(isovalue);
      return MakeImage(view.geometry, samples);
    },
    grid);
}

vtkSmartPointer<vtkImageData> WithoutSmallPieces(
  vtkImageData* image, double isovalue, double leastMm3, Session& session)
{
  session.progress.Step("finding connected pieces");
  const auto start = std::chrono::steady_clock::now();
  const vtkSmartPointer<vtkImageData> large = LargePiecesOf(image, isovalue, leastMm3);
  if (!large)
  {
    std::ostringstream text;
    text << "no connected piece at or above " << isovalue << " has " << leastMm3
         << " mm3; lower --ignore-below";
    throw Failure(ExitCode::BadInput, text.str());
  }
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  session.resources.push_back({ "volume without small pieces", 1024 * large->GetActualMemorySize(),
    spent.count(), "--ignore-below" });
  return large;
}

} // namespace hasp
