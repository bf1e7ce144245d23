#include "RendererChoice.h"

#include <cstdio>

namespace hasp
{
namespace
{
bool FarFrom(std::size_t now, std::size_t then)
{
  return now > 2 * then || then > 2 * now;
}
}

bool RendererChoice::Trace(std::size_t cells, std::size_t pixels)
{
  if (FarFrom(cells, this->Cells) || FarFrom(pixels, this->Pixels))
  {
    *this = {};
    this->Cells = cells;
    this->Pixels = pixels;
  }
  return this->Decided() ? this->TraceWins() : this->Step < TracedSteps;
}

void RendererChoice::Note(double milliseconds)
{
  if (this->Decided())
    return;
  if (this->Step < TracedSteps)
    this->TraceMilliseconds = milliseconds;
  else
    this->RasterMilliseconds = milliseconds;
  ++this->Step;
  const double allowance = this->Step == TracedSteps + 1 ? 1000.0 : 0.0; // shaders
  if (this->Step > TracedSteps &&
      this->RasterMilliseconds > 4.0 * this->TraceMilliseconds + allowance)
    this->Step = Steps;
}

std::string RendererChoice::Text() const
{
  if (this->Step == 0)
    return "traced: OpenGL is software, so rays are tried first";
  char figures[96];
  if (this->Step <= TracedSteps)
    std::snprintf(figures, sizeof figures,
      "traced: OpenGL is software, so rays are tried first; they took %.1f ms",
      this->TraceMilliseconds);
  else if (!this->Decided())
    std::snprintf(figures, sizeof figures,
      "rasterised: to compare; traced in %.1f ms, rasterised in %.1f ms so far",
      this->TraceMilliseconds, this->RasterMilliseconds);
  else
    std::snprintf(figures, sizeof figures, "%s: traced in %.1f ms, rasterised in %.1f ms",
      this->TraceWins() ? "traced" : "rasterised", this->TraceMilliseconds,
      this->RasterMilliseconds);
  return figures;
}

} // namespace hasp
