#pragma once
#include "IsosurfaceMethods.h"
#include "Pairing.h"
#include "SurfaceErrors.h"

#include <memory>
#include <string>

namespace hasp
{

struct ReportContext;
struct ReportRow;

/// Clustered cells against other methods on one volume: frames in turn, errors against one truth.
/// Rows, curves and unused resources go into the report as they are measured. RENDER thread.
class IsosurfaceComparison
{
public:
  /// data names the rows ("gyroid256"); the view must outlive this. voxelMm turns millimetres into
  /// voxels. curve names the chart this volume belongs to.
  IsosurfaceComparison(ReportContext& context, const std::string& data, const std::string& curve,
    double voxelMm, const IsosurfaceView& view, SurfaceTruth truth);

  /// Draws ours and theirs in turn; `id` ends the rows' ids, `method` names the rival's curve.
  void Against(IsosurfaceMethod& rival, const std::string& method, const std::string& id);
  /// When all rivals have run: our own errors; bytes against a mesh of `meshBytes`.
  void Finish(std::size_t meshBytes);

private:
  struct Measured
  {
    std::string name; ///< empty: ours
    SurfaceErrors error;
    Timing frame;
  };
  ReportRow Row(
    const std::string& id, double value, const std::string& unit, const Measured& measured) const;
  void ErrorRows(const Measured& measured, const std::string& id);
  void CurvePoint(const std::string& method, const Measured& measured);

  ReportContext& Context;
  std::string Data, CurveId;
  double VoxelMm;
  const IsosurfaceView& View;
  SurfaceTruth Truth;
  std::unique_ptr<IsosurfaceMethod> Cells;
  Measured Ours;
};

} // namespace hasp
