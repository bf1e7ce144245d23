#include "ReportChart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace hasp
{
namespace
{

constexpr double Width = 640, Height = 380, Left = 78, Right = 170, Top = 16, Bottom = 52;
// Okabe and Ito's palette: told apart by colour-blind readers.
constexpr std::array Colors{ "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9",
  "#000000" };

std::string Number(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

/// Figures to pixels along one axis.
class Axis
{
public:
  Axis(double pixel0, double pixel1) : first(pixel0), last(pixel1) {}

  void Include(double figure)
  {
    this->low = std::min(this->low, figure);
    this->high = std::max(this->high, figure);
  }
  void Finish()
  {
    this->logarithmic = this->low > 0.0 && this->high > 5.0 * this->low;
    if (this->logarithmic)
    {
      this->low = std::pow(10.0, std::floor(std::log10(this->low)));
      this->high = std::pow(10.0, std::ceil(std::log10(this->high)));
      return;
    }
    const double margin = this->high > this->low ? 0.08 * (this->high - this->low)
                                                 : std::max(0.5 * std::abs(this->high), 1e-12);
    this->low -= margin;
    this->high += margin;
  }
  double Pixel(double figure) const
  {
    const double share = this->logarithmic
                           ? std::log(figure / this->low) / std::log(this->high / this->low)
                           : (figure - this->low) / (this->high - this->low);
    return std::lerp(this->first, this->last, share);
  }
  std::vector<double> Ticks() const
  {
    std::vector<double> ticks;
    if (this->logarithmic)
      for (double tick = this->low; tick <= this->high * 1.001; tick *= 10.0)
        ticks.push_back(tick);
    else
      for (int k = 0; k <= 4; ++k)
        ticks.push_back(std::lerp(this->low, this->high, 0.25 * k));
    return ticks;
  }

private:
  double first, last;
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();
  bool logarithmic = false;
};

std::string Text(double x, double y, const char* anchor, const std::string& text)
{
  return "<text x=\"" + Number(x) + "\" y=\"" + Number(y) + "\" text-anchor=\"" + anchor + "\">" +
         EscapeHtml(text) + "</text>\n";
}

std::string Line(double x0, double y0, double x1, double y1)
{
  return "<line class=\"grid\" x1=\"" + Number(x0) + "\" y1=\"" + Number(y0) + "\" x2=\"" +
         Number(x1) + "\" y2=\"" + Number(y1) + "\"/>\n";
}

std::string Grid(const Axis& x, const Axis& y, const ReportCurve& units)
{
  std::string svg;
  for (const double tick : x.Ticks())
    svg += Line(x.Pixel(tick), Top, x.Pixel(tick), Height - Bottom) +
           Text(x.Pixel(tick), Height - Bottom + 18, "middle", Number(tick));
  for (const double tick : y.Ticks())
    svg += Line(Left, y.Pixel(tick), Width - Right, y.Pixel(tick)) +
           Text(Left - 6, y.Pixel(tick) + 4, "end", Number(tick));
  svg += Text((Left + Width - Right) / 2, Height - 10, "middle", "time [" + units.xUnit + "]");
  const std::string middle = Number((Top + Height - Bottom) / 2);
  return svg + "<text transform=\"translate(16 " + middle +
         ") rotate(-90)\" text-anchor=\"middle\">" + "error [" + EscapeHtml(units.yUnit) +
         "]</text>\n";
}

std::string Curve(const ReportCurve& curve, const Axis& x, const Axis& y, const char* color)
{
  std::string line, points;
  for (const auto& [time, error] : curve.points)
  {
    const std::string px = Number(x.Pixel(time)), py = Number(y.Pixel(error));
    line += px + "," + py + " ";
    points += "<circle cx=\"" + px + "\" cy=\"" + py + "\" r=\"4\" fill=\"" + color + "\"><title>" +
              EscapeHtml(curve.method + ": " + Number(time) + " " + curve.xUnit + ", " +
                         Number(error) + " " + curve.yUnit) +
              "</title></circle>\n";
  }
  return "<polyline fill=\"none\" stroke=\"" + std::string(color) +
         "\" stroke-width=\"2\" points=\"" + line + "\"/>\n" + points;
}

} // namespace

std::string EscapeHtml(const std::string& text)
{
  std::string safe;
  for (const char c : text)
    switch (c)
    {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  return safe;
}

std::string ErrorTimeChart(const std::vector<ReportCurve>& curves)
{
  Axis x(Left, Width - Right), y(Height - Bottom, Top);
  std::vector<const ReportCurve*> drawn;
  for (const ReportCurve& curve : curves)
    if (!curve.points.empty())
      drawn.push_back(&curve);
  if (drawn.empty())
    return "";
  for (const ReportCurve* curve : drawn)
    for (const auto& [time, error] : curve->points)
    {
      x.Include(time);
      y.Include(error);
    }
  x.Finish();
  y.Finish();
  std::string svg = "<svg viewBox=\"0 0 " + Number(Width) + " " + Number(Height) +
                    "\" role=\"img\" aria-label=\"error against time\">\n" +
                    Grid(x, y, *drawn.front());
  for (std::size_t k = 0; k < drawn.size(); ++k)
  {
    const char* color = Colors[k % Colors.size()];
    const double legend = Top + 14 + 20.0 * static_cast<double>(k);
    svg += Curve(*drawn[k], x, y, color) + "<circle cx=\"" + Number(Width - Right + 16) +
           "\" cy=\"" + Number(legend - 4) + "\" r=\"5\" fill=\"" + color + "\"/>\n" +
           Text(Width - Right + 28, legend, "start", drawn[k]->method);
  }
  return svg + "</svg>\n";
}

} // namespace hasp
