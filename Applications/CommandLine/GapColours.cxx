#include "GapColours.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

namespace hasp
{
namespace
{

constexpr double Shown = 1.5; // tolerances to either side on the scale

/// Colours of a gap that is so many tolerances off what was asked; straight in between.
struct Stop
{
  double off;
  Colour colour;
};
constexpr Stop Within[] = { { -1.0, { 4, 20, 60 } }, { -0.5, { 16, 66, 140 } },
  { -0.25, { 66, 146, 198 } }, { 0.0, { 247, 247, 247 } }, { 0.25, { 239, 101, 72 } },
  { 0.5, { 160, 15, 20 } }, { 1.0, { 80, 0, 0 } } };
constexpr Colour TooNear{ 150, 40, 200 }, TooFar{ 245, 180, 0 };

std::string Hex(const Colour& colour)
{
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", colour[0], colour[1], colour[2]);
  return text;
}

std::string StopSvg(double off, const Colour& colour)
{
  char text[80];
  std::snprintf(text, sizeof text, "<stop offset=\"%.4f\" stop-color=\"%s\"/>",
    0.5 * (1.0 + off / Shown), Hex(colour).c_str());
  return text;
}

} // namespace

Colour GapColour(const ClaimedShell& shell, double gapMm)
{
  const double off = (gapMm - shell.gapMm) / shell.gapToleranceMm;
  if (off < -1.0 || off > 1.0)
    return off < 0.0 ? TooNear : TooFar;
  const Stop* above = std::find_if(
    std::begin(Within) + 1, std::end(Within) - 1, [off](const Stop& s) { return off <= s.off; });
  const Stop &a = above[-1], &b = *above;
  const double share = (off - a.off) / (b.off - a.off);
  Colour colour;
  for (std::size_t n = 0; n < colour.size(); ++n)
    colour[n] = static_cast<std::uint8_t>(
      std::lround(a.colour[n] + share * (double(b.colour[n]) - a.colour[n])));
  return colour;
}

std::string GapScaleSvg(const ClaimedShell& shell)
{
  constexpr double Left = 30.0, Width = 580.0;
  std::string svg = "<svg viewBox=\"0 0 640 56\" role=\"img\" aria-label=\"colours of the gap\">"
                    "<defs><linearGradient id=\"gap\">" +
                    StopSvg(-Shown, TooNear) + StopSvg(-1.0, TooNear);
  for (const Stop& stop : Within)
    svg += StopSvg(stop.off, stop.colour);
  svg += StopSvg(1.0, TooFar) + StopSvg(Shown, TooFar) +
         "</linearGradient></defs><rect x=\"30\" y=\"4\" width=\"580\" height=\"18\" "
         "fill=\"url(#gap)\" stroke=\"#666\"/>\n";
  for (const double off : { -1.0, -0.5, 0.0, 0.5, 1.0 })
  {
    char text[160];
    const double x = Left + Width * 0.5 * (1.0 + off / Shown);
    std::snprintf(text, sizeof text,
      "<line x1=\"%.1f\" y1=\"22\" x2=\"%.1f\" y2=\"28\" stroke=\"#222\"/><text x=\"%.1f\" "
      "y=\"42\" text-anchor=\"middle\">%.2f mm</text>\n",
      x, x, x, shell.gapMm + off * shell.gapToleranceMm);
    svg += text;
  }
  return svg + "<text x=\"78\" y=\"54\" text-anchor=\"middle\">too near</text>"
               "<text x=\"562\" y=\"54\" text-anchor=\"middle\">too far</text></svg>\n";
}

} // namespace hasp
