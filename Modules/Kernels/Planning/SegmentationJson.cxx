#include "Planning/SegmentationJson.h"

#include "Planning/RecipeFormat.h"
#include "Planning/ValueChecks.h"

namespace hasp
{

namespace
{
constexpr const char* Subject = "segmentation recipe";
constexpr const char* Format = "hasp-segmentation-1";

constexpr std::pair<Morphology, const char*> Operations[] = { { Morphology::Dilate, "dilate" },
  { Morphology::Erode, "erode" }, { Morphology::Open, "open" }, { Morphology::Close, "close" } };

struct StepWriter
{
  Json operator()(const GaussianStep& s) const
  {
    return { { "step", "gaussian" }, { "sigmaMm", s.sigmaMm } };
  }
  Json operator()(const MedianStep& s) const
  {
    return { { "step", "median" }, { "radiusMm", s.radiusMm } };
  }
  Json operator()(const EdgePreservingStep& s) const
  {
    return { { "step", "edge-preserving" }, { "edge", s.edge }, { "iterations", s.iterations } };
  }
  Json operator()(const ConeBeamStep& s) const
  {
    return { { "step", "cone-beam-correction" }, { "fieldMm", s.fieldMm },
      { "contrastMm", s.contrastMm }, { "insideAbove", s.insideAbove } };
  }
  Json operator()(const ThresholdStep& s) const
  {
    return { { "step", "threshold" }, { "lowest", s.lowest }, { "highest", s.highest },
      { "smoothMm", s.smoothMm } };
  }
  Json operator()(const SplitStep& s) const
  {
    Json strokes = Json::array();
    for (const BrushStroke& stroke : s.strokes)
      strokes.push_back(StrokeToJson(stroke));
    return { { "step", "split" }, { "label", s.label }, { "beta", s.beta }, { "crack", s.crack },
      { "norm", s.norm }, { "strokes", std::move(strokes) } };
  }
  Json operator()(const PaintStep& s) const
  {
    return { { "step", "paint" }, { "only", s.only }, { "stroke", StrokeToJson(s.stroke) } };
  }
  Json operator()(const MergeStep& s) const
  {
    return { { "step", "merge" }, { "from", s.from }, { "into", s.into } };
  }
  Json operator()(const ComponentsStep& s) const
  {
    return { { "step", "components" }, { "label", s.label }, { "leastMm3", s.leastMm3 },
      { "keepLargestAlone", s.keepLargestAlone } };
  }
  Json operator()(const FillStep& s) const { return { { "step", "fill" }, { "label", s.label } }; }
  Json operator()(const MorphologyStep& s) const
  {
    return { { "step", "morphology" }, { "label", s.label },
      { "operation", NameOf(s.operation, Operations) }, { "radiusMm", s.radiusMm } };
  }
};

/// A step of the file, and where it stands.
struct StepText
{
  const Json& json;
  const std::string &subject, &name;

  StrictJson Read(std::initializer_list<const char*> keys) const
  {
    return StrictJson(this->json, this->subject, this->name, keys);
  }
};

std::uint16_t ReadLabel(const StrictJson& object, const char* key, std::uint64_t least = 1)
{
  return static_cast<std::uint16_t>(object.Count(key, least, 65535));
}

SegmentationStep ReadGaussian(const StepText& text)
{
  return GaussianStep{ text.Read({ "step", "sigmaMm" }).Number("sigmaMm") };
}

SegmentationStep ReadMedian(const StepText& text)
{
  return MedianStep{ text.Read({ "step", "radiusMm" }).Number("radiusMm") };
}

SegmentationStep ReadEdgePreserving(const StepText& text)
{
  const StrictJson read = text.Read({ "step", "edge", "iterations" });
  return EdgePreservingStep{ read.Number("edge"), int(read.Count("iterations", 1, 100)) };
}

SegmentationStep ReadConeBeam(const StepText& text)
{
  const StrictJson read = text.Read({ "step", "fieldMm", "contrastMm", "insideAbove" });
  return ConeBeamStep{ read.Number("fieldMm"), read.Number("contrastMm"),
    read.Number("insideAbove") };
}

SegmentationStep ReadThreshold(const StepText& text)
{
  const StrictJson read = text.Read({ "step", "lowest", "highest", "smoothMm" });
  return ThresholdStep{ read.Number("lowest"), read.Number("highest"), read.Number("smoothMm") };
}

SegmentationStep ReadSplit(const StepText& text)
{
  const StrictJson read = text.Read({ "step", "label", "beta", "crack", "norm", "strokes" });
  SplitStep step{ ReadLabel(read, "label"), {}, read.Number("beta"), read.Number("crack"),
    read.Number("norm") };
  for (const Json& stroke : read.List("strokes", MostStrokes))
    step.strokes.push_back(StrokeFromJson(
      stroke, text.subject, text.name + "." + ListKey("strokes", step.strokes.size())));
  return step;
}

SegmentationStep ReadPaint(const StepText& text)
{
  const StrictJson read = text.Read({ "step", "only", "stroke" });
  return PaintStep{ StrokeFromJson(read.Get("stroke"), text.subject, text.name + ".stroke"),
    ReadLabel(read, "only", 0) };
}

SegmentationStep ReadMerge(const StepText& text)
{
  const StrictJson read = text.Read({ "step", "from", "into" });
  return MergeStep{ ReadLabel(read, "from"), ReadLabel(read, "into", 0) };
}

SegmentationStep ReadComponents(const StepText& text)
{
  const StrictJson read = text.Read({ "step", "label", "leastMm3", "keepLargestAlone" });
  return ComponentsStep{ ReadLabel(read, "label"), read.Number("leastMm3"),
    read.Flag("keepLargestAlone") };
}

SegmentationStep ReadFill(const StepText& text)
{
  return FillStep{ ReadLabel(text.Read({ "step", "label" }), "label") };
}

SegmentationStep ReadMorphology(const StepText& text)
{
  const StrictJson read = text.Read({ "step", "label", "operation", "radiusMm" });
  return MorphologyStep{ ReadLabel(read, "label"), read.Named("operation", Operations),
    read.Number("radiusMm") };
}

using ReadStep = SegmentationStep (*)(const StepText&);
constexpr std::pair<ReadStep, const char*> Steps[] = { { ReadGaussian, "gaussian" },
  { ReadMedian, "median" }, { ReadEdgePreserving, "edge-preserving" },
  { ReadConeBeam, "cone-beam-correction" }, { ReadThreshold, "threshold" }, { ReadSplit, "split" },
  { ReadPaint, "paint" }, { ReadMerge, "merge" }, { ReadComponents, "components" },
  { ReadFill, "fill" }, { ReadMorphology, "morphology" } };
static_assert(std::size(Steps) == std::variant_size_v<SegmentationStep>);
} // namespace

Json PointsToJson(const std::vector<glm::dvec3>& points)
{
  Json list = Json::array();
  for (const glm::dvec3& point : points)
    list.push_back(ToJson(point));
  return list;
}

Json StrokeToJson(const BrushStroke& stroke)
{
  return { { "label", stroke.label }, { "radiusMm", stroke.radiusMm },
    { "points", PointsToJson(stroke.points) } };
}

BrushStroke StrokeFromJson(const Json& json, const std::string& subject, const std::string& name)
{
  const StrictJson read(json, subject, name, { "label", "radiusMm", "points" });
  return { ReadLabel(read, "label", 0), read.Number("radiusMm"),
    read.Vectors("points", MostStrokePoints) };
}

Json StepToJson(const SegmentationStep& step)
{
  return std::visit(StepWriter{}, step);
}

SegmentationStep StepFromJson(const Json& json, const std::string& subject, const std::string& name)
{
  const ReadStep read = StrictJson(json, subject, name).Named("step", Steps);
  return read({ json, subject, name });
}

SegmentationRecipe SegmentationRecipeFromJson(const Json& json)
{
  CheckFormat(json, Subject, { Format });
  const StrictJson top(json, Subject, "", { "format", "steps", "names" });
  SegmentationRecipe recipe;
  for (const Json& step : top.List("steps", MostSegmentationSteps))
    recipe.steps.push_back(StepFromJson(step, Subject, ListKey("steps", recipe.steps.size())));
  for (const Json& value : top.List("names", 65535))
  {
    const StrictJson name(
      value, Subject, ListKey("names", recipe.names.size()), { "label", "name", "colour" });
    recipe.names.push_back({ ReadLabel(name, "label"), name.Text("name"), name.Colour("colour") });
  }
  ValidateSegmentationRecipe(recipe);
  return recipe;
}

Json SegmentationRecipeToJson(const SegmentationRecipe& recipe)
{
  ValidateSegmentationRecipe(recipe);
  Json json = { { "format", Format }, { "steps", Json::array() }, { "names", Json::array() } };
  for (const SegmentationStep& step : recipe.steps)
    json["steps"].push_back(StepToJson(step));
  for (const LabelName& name : recipe.names)
    json["names"].push_back(
      { { "label", name.label }, { "name", name.name }, { "colour", ColourText(name.colour) } });
  return json;
}

} // namespace hasp
