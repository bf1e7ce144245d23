#include "CertificatePage.h"

#include "GapColours.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace hasp
{
namespace
{

constexpr double Left = 60.0, Right = 620.0, Top = 12.0, Bottom = 200.0;

std::string Svg(const char* format, auto... figures)
{
  char text[300];
  std::snprintf(text, sizeof text, format, figures...);
  return text;
}

} // namespace

std::string GapHistogramSvg(const GuideGap& gap, const ClaimedShell& shell)
{
  const std::vector<double>& bins = gap.histogramMm2;
  const double first = -0.5 * GuideGap::BinMm * double(bins.size());
  const auto from = [&](std::size_t bin) { return first + GuideGap::BinMm * double(bin); };
  // All that is there, and the tolerance on either side at least.
  double low = shell.gapMm - 2.0 * shell.gapToleranceMm;
  double high = shell.gapMm + 2.0 * shell.gapToleranceMm, most = 0.0;
  for (std::size_t n = 0; n < bins.size(); ++n)
    if (bins[n] > 0.0)
    {
      low = std::min(low, from(n));
      high = std::max(high, from(n + 1));
      most = std::max(most, bins[n]);
    }
  const auto x = [&](double mm) { return Left + (Right - Left) * (mm - low) / (high - low); };
  const double leastX = x(shell.gapMm - shell.gapToleranceMm);
  std::string svg =
    "<svg viewBox=\"0 0 640 250\" role=\"img\" aria-label=\"histogram of the gap\">";
  svg += Svg("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"#dfeee0\"/>\n",
    leastX, Top, x(shell.gapMm + shell.gapToleranceMm) - leastX, Bottom - Top);
  for (std::size_t n = 0; n < bins.size(); ++n)
    if (bins[n] > 0.0)
    {
      const Colour c = GapColour(shell, from(n) + 0.5 * GuideGap::BinMm);
      const double height = (Bottom - Top) * bins[n] / most;
      svg += Svg("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" "
                 "fill=\"#%02x%02x%02x\" stroke=\"#555\" stroke-width=\"0.7\"/>\n",
        x(from(n)), Bottom - height, x(from(n + 1)) - x(from(n)), height, c[0], c[1], c[2]);
    }
  svg += Svg("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"#222\" "
             "stroke-dasharray=\"4 3\"/>\n",
    x(shell.gapMm), Top, x(shell.gapMm), Bottom);
  svg += Svg("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"#222\"/>\n", Left,
    Bottom, Right, Bottom);
  const double step = high - low > 1.2 ? 0.5 : high - low > 0.5 ? 0.2 : 0.1;
  for (double mm = step * std::ceil(low / step - 1e-9); mm <= high + 1e-9; mm += step)
    svg += Svg("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"#222\"/>"
               "<text x=\"%.1f\" y=\"218\" text-anchor=\"middle\">%.1f</text>\n",
      x(mm), Bottom, x(mm), Bottom + 5.0, x(mm), std::abs(mm) < 1e-9 ? 0.0 : mm);
  svg += Svg("<text x=\"54\" y=\"%.1f\" text-anchor=\"end\">%.0f</text>"
             "<text x=\"54\" y=\"%.1f\" text-anchor=\"end\">0</text>\n",
    Top + 8.0, most, Bottom);
  return svg +
         Svg("<text x=\"340\" y=\"240\" text-anchor=\"middle\">gap to the bone, mm; area of the "
             "inner wall in a bin of %.2f mm upwards, mm2; green: within the tolerance</text>\n",
           GuideGap::BinMm) +
         "</svg>\n";
}

} // namespace hasp
