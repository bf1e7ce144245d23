// The direct ray cast among the methods of IsosurfaceMethods.h: no window, no GPU.
#include "IsosurfaceMethods.h"

#include "Grid/MinMaxBlocks.h"
#include "Grid/ParallelFor.h"
#include "Isosurface/RayCaster.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace hasp
{
namespace
{

class DirectMethod : public IsosurfaceMethod
{
public:
  explicit DirectMethod(const IsosurfaceView& view) : View(view), Isovalue(view.isovalue) {}
  void SetIsovalue(double isovalue) override { this->Isovalue = isovalue; }
  std::string Name() const override { return "direct ray cast on the CPU, exact root, all cores"; }
  std::size_t Bytes() const override { return this->Blocks.Bytes(); }
  SurfacePoints Points() override { return this->Hits; }
  void Draw() override
  {
    const AnyGridView grid = ViewImage(this->View.image);
    if (this->Blocks.Count() == 0)
      this->Blocks = MinMaxBlocks(grid);
    const RayCaster caster(grid, this->Blocks, this->Isovalue);
    const int width = this->View.width;
    this->Hits.assign(std::size_t(width) * this->View.height, std::nullopt);
    this->Grey.assign(this->Hits.size(), 0);
    ParallelFor(0, this->View.height, 8,
      [&](std::int64_t first, std::int64_t last)
      {
        for (auto y = int(first); y < last; ++y)
          for (int x = 0; x < width; ++x)
          {
            const auto [origin, direction] = this->View.Ray(x, y);
            const auto hit = caster.Cast(origin, direction);
            if (!hit)
              continue;
            const std::size_t n = std::size_t(y) * width + x;
            this->Hits[n] = hit->position;
            this->Grey[n] = static_cast<unsigned char>(
              255.0 * std::abs(glm::dot(glm::normalize(hit->gradient), direction)));
          }
      });
  }

private:
  const IsosurfaceView& View;
  double Isovalue;
  MinMaxBlocks Blocks;
  SurfacePoints Hits;
  std::vector<unsigned char> Grey; ///< headlight shading, so that the others' work is matched
};

} // namespace

std::unique_ptr<IsosurfaceMethod> MakeDirectMethod(const IsosurfaceView& view)
{
  return std::make_unique<DirectMethod>(view);
}

} // namespace hasp
