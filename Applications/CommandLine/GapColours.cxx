#include "GapColours.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace hasp
{
namespace
{

constexpr Colour Nearer{ 33, 92, 172 }, AsAsked{ 247, 247, 247 }, Farther{ 178, 24, 43 };

std::string Hex(const Colour& colour)
{
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", colour[0], colour[1], colour[2]);
  return text;
}

} // namespace

Colour GapColour(const ClaimedShell& shell, double gapMm)
{
  const double off = std::clamp((gapMm - shell.gapMm) / (2.0 * shell.gapToleranceMm), -1.0, 1.0);
  const Colour& end = off < 0.0 ? Nearer : Farther;
  Colour colour;
  for (std::size_t n = 0; n < colour.size(); ++n)
    colour[n] = static_cast<std::uint8_t>(
      std::lround(AsAsked[n] + std::abs(off) * (double(end[n]) - AsAsked[n])));
  return colour;
}

std::string GapScaleSvg(const ClaimedShell& shell)
{
  constexpr double Left = 30.0, Width = 580.0;
  std::string svg =
    "<svg viewBox=\"0 0 640 56\" role=\"img\" aria-label=\"colours of the gap\"><defs>"
    "<linearGradient id=\"gap\"><stop offset=\"0\" stop-color=\"" +
    Hex(Nearer) + "\"/><stop offset=\"0.5\" stop-color=\"" + Hex(AsAsked) +
    "\"/><stop offset=\"1\" stop-color=\"" + Hex(Farther) +
    "\"/></linearGradient></defs><rect x=\"30\" y=\"4\" width=\"580\" height=\"18\" "
    "fill=\"url(#gap)\" stroke=\"#666\"/>\n";
  for (int n = -2; n <= 2; ++n)
  {
    char text[160];
    const double x = Left + Width * (n + 2) / 4.0;
    std::snprintf(text, sizeof text,
      "<line x1=\"%.1f\" y1=\"22\" x2=\"%.1f\" y2=\"28\" stroke=\"#222\"/><text x=\"%.1f\" "
      "y=\"42\" text-anchor=\"middle\">%.2f mm</text>\n",
      x, x, x, shell.gapMm + n * shell.gapToleranceMm);
    svg += text;
  }
  return svg + "</svg>\n";
}

} // namespace hasp
