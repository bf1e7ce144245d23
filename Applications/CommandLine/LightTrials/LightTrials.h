#pragma once
#include "Grid/TriangleMesh.h"
#include "Isosurface/CellTracer.h"
#include "WorldRay.h"

#include <functional>
#include <memory>
#include <span>
#include <string>

namespace hasp
{

struct ReportContext;

/// What `hasp report light` measures, free of VTK. Each puts rows into the report. RENDER thread;
/// all cores inside.

/// A surface that light is measured on.
struct LightData
{
  std::string tag;  ///< ends the rows' ids: "" on the data that the bars name, else "@cranium"
  std::string data; ///< "phantom head, 256^3 int16, 300 HU"
  std::shared_ptr<const CellTracer> cells;
  TriangleMesh mesh; ///< of the same surface: what rays against cells are compared with
  double voxelMm = 1.0;
};

/// Who traces single rays against the mesh, on all cores.
struct RayRival
{
  std::string name;
  /// The way to the first triangle of each ray, infinite where there is none.
  std::function<void(std::span<const WorldRay>, std::span<float>)> nearest;
  /// The same of any triangle: infinite where there is none, else anything less.
  std::function<void(std::span<const WorldRay>, std::span<float>)> any;
};

/// light.furnace.diffuse, .coat, .metal: radiance 1 from everywhere on a ball that gives all back;
/// .concave: on a gyroid, whose light bounces. Truth: 1. samples: of each of 512 looks at a ball.
void MeasureFurnace(ReportContext& context, int samples);

/// light.sphere: what a sphere on a plane leaves of an even sky; .sky: of daylight.
void MeasureSphere(ReportContext& context);

/// light.reciprocity: a lamp and an eye change places.
void MeasureReciprocity(ReportContext& context);

/// light.energy, light.energy.increments: radiance by bounces.
void MeasureEnergy(ReportContext& context, const LightData& data);

/// light.sobol.ao, .bounce1, .bounce3: error against time of scrambled Sobol points and of random
/// ones at so many pixels, and with .slope how both fall. Throws std::runtime_error where light has
/// no noise.
void MeasureSobol(ReportContext& context, const LightData& data, std::size_t pixels);

struct HybridSettings
{
  int side = 128;         ///< of the picture, pixels
  int truthSamples = 512; ///< of a pixel's truth, even
  int mostSamples = 64;   ///< that paths anew are followed to
};
/// light.hybrid.still, .still.1 ..., .moving: light that is kept, against paths anew, at equal
/// error.
void MeasureHybrid(
  ReportContext& context, const LightData& data, const HybridSettings& settings = {});

/// light.rays.ao, .bounces: single rays against cells and against the rival's triangles; .paths:
/// whole paths against cells and against Light/TriangleTracer.h; .rate: rays a second.
void MeasureRays(ReportContext& context, const LightData& data, const RayRival& rival);

/// light.extreme.pixel, .black, .inside: one bright pixel of a map, no light, an eye in bone.
void MeasureLightExtremes(ReportContext& context);

/// light.extreme.small, .large, .spacing: scenes of other sizes, cells of 100:1.
void MeasureLightScales(ReportContext& context);

/// What is not made while nothing asks for light.
void AddUnusedLight(ReportContext& context);

/// `id`: the worst of the rows whose ids begin so and end in no data set, with their bar. After
/// all of them; nothing where there are none.
void AddWorstLight(ReportContext& context, const std::string& id);

} // namespace hasp
