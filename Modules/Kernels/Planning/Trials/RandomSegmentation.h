#pragma once
#include "Planning/SegmentationRecipe.h"

#include <cmath>
#include <random>
#include <string>

/// Recipes with steps of all kinds, the same for the same state of `random`. Values are anywhere in
/// their ranges.
class RandomSegmentation
{
public:
  explicit RandomSegmentation(std::mt19937& random) : Random(random) {}

  /// Up to three filters and `most` other steps; two labels have names.
  hasp::SegmentationRecipe Recipe(int most, const std::string& name)
  {
    hasp::SegmentationRecipe recipe;
    for (int n = this->Whole(0, 3); n > 0; --n)
      recipe.steps.push_back(this->Filter());
    for (int n = this->Whole(0, most); n > 0; --n)
      recipe.steps.push_back(this->Step());
    const int label = this->Whole(1, 65534);
    recipe.names = { { std::uint16_t(label), name, this->Colour() },
      { std::uint16_t(label + 1), "", this->Colour() } };
    return recipe;
  }

  hasp::SegmentationStep Filter()
  {
    switch (this->Whole(0, 3))
    {
      case 0:
        return hasp::GaussianStep{ this->Real(1e-9, 10) };
      case 1:
        return hasp::MedianStep{ this->Real(1e-9, 10) };
      case 2:
        return hasp::EdgePreservingStep{ this->Real(1e-9, 1e6), this->Whole(1, 100) };
      default:
        return hasp::ConeBeamStep{ this->Real(10, 500), this->Whole(0, 1) * this->Real(5, 100),
          this->Real(-1e6, 1e6) };
    }
  }

  /// None that is a filter.
  hasp::SegmentationStep Step()
  {
    switch (this->Whole(0, 6))
    {
      case 0:
      {
        const double lowest = this->Real(-1e6, 1e6);
        return hasp::ThresholdStep{ lowest, this->Real(lowest, 1e6), this->Real(0.0, 10.0) };
      }
      case 1:
      {
        hasp::SplitStep step{ this->Label(1), {}, std::pow(10.0, this->Real(-12, 12)) };
        for (int n = this->Whole(0, 3); n > 0; --n)
          step.strokes.push_back(this->Stroke(1));
        return step;
      }
      case 2:
        return hasp::PaintStep{ this->Stroke(0), this->Label(0) };
      case 3:
      {
        const std::uint16_t from = this->Label(1);
        return hasp::MergeStep{ from, std::uint16_t(from - 1) };
      }
      case 4:
        return hasp::ComponentsStep{ this->Label(1), this->Real(0, 1e9), this->Whole(0, 1) == 1 };
      case 5:
        return hasp::FillStep{ this->Label(1) };
      default:
        return hasp::MorphologyStep{ this->Label(1), hasp::Morphology(this->Whole(0, 3)),
          this->Real(1e-9, 50) };
    }
  }

  hasp::BrushStroke Stroke(int leastLabel)
  {
    hasp::BrushStroke stroke{ this->Label(leastLabel), this->Real(1e-9, 50), {} };
    for (int n = this->Whole(1, 5); n > 0; --n)
      stroke.points.emplace_back(
        this->Real(-4000, 4000), this->Real(-1e-9, 1e-9), this->Whole(0, 1) == 0 ? -0.0 : 4000.0);
    return stroke;
  }

  std::array<std::uint8_t, 3> Colour()
  {
    return { std::uint8_t(this->Whole(0, 255)), std::uint8_t(this->Whole(0, 255)),
      std::uint8_t(this->Whole(0, 255)) };
  }

private:
  int Whole(int low, int high)
  {
    return std::uniform_int_distribution<int>(low, high)(this->Random);
  }
  double Real(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Random);
  }
  std::uint16_t Label(int least) { return std::uint16_t(this->Whole(least, 65535)); }

  std::mt19937& Random;
};
