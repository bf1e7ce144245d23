#include "CertificateText.h"

#include <cstdio>

namespace hasp
{
namespace
{

const char* YesNo(bool yes)
{
  return yes ? "yes" : "NO";
}

std::string Line(const char* format, auto... figures)
{
  char text[240];
  std::snprintf(text, sizeof text, format, figures...);
  return text;
}

std::string WallText(const char* name, const WallThickness& wall, double leastMm)
{
  return Line("%-20s%.2f mm at (%.1f, %.1f, %.1f); at least %.2f\n", name, wall.leastMm,
    wall.leastAt.x, wall.leastAt.y, wall.leastAt.z, leastMm);
}

std::string MeshText(const FitCertificate& c)
{
  const glm::dvec3 size = c.high - c.low;
  return Line("triangles           %zu, %zu piece(s), %.1f mm3, %.1f mm2\n", c.mesh.triangles,
           c.mesh.pieces, c.mesh.volumeMm3, c.mesh.areaMm2) +
         Line("box                 %.1f x %.1f x %.1f mm\n", size.x, size.y, size.z) +
         Line("closed              %s\n", YesNo(c.mesh.Closed())) +
         Line("2-manifold          %s\n", YesNo(c.mesh.TwoManifold())) +
         Line("outward             %s\n", YesNo(c.mesh.Outward())) + "self-intersections  " +
         (c.selfIntersections ? std::to_string(*c.selfIntersections) : "not measured") + "\n" +
         Line("slivers             %zu\n", c.slivers) +
         WallText("thinnest wall", c.wall, c.claims.leastWallMm) +
         (c.uncut ? WallText("away from holes", *c.uncut, c.claims.leastUncutMm) : "");
}

std::string ShellText(const FitCertificate& c)
{
  const GuideGap& gap = *c.gap;
  const ClaimedShell& claim = *c.claims.shell;
  return Line("shell               %.2f mm least, %.2f median; asked %.2f less %.2f at most\n",
           c.shell->leastMm, c.shell->p50Mm, claim.thicknessMm, claim.thicknessToleranceMm) +
         Line("gap asked           %.3f mm; inner wall, what faces bone: %.1f mm2\n", claim.gapMm,
           gap.innerWallMm2) +
         Line("gap p5 p50 p95      %.3f  %.3f  %.3f mm by area, least %.3f, most %.3f\n", gap.p5,
           gap.p50, gap.p95, gap.least, gap.most) +
         Line("within %.2f mm      %.2f %% of the inner wall, at least %.1f %%\n",
           claim.gapToleranceMm, 100.0 * gap.share, 100.0 * claim.leastGapShare) +
         Line("nearest of all      %.3f mm, whichever way the wall faces\n", gap.leastAnywhere);
}

std::string CutsText(const FitCertificate& c)
{
  std::string text;
  for (std::size_t n = 0; n < c.slots.size(); ++n)
    text += Line("slots[%zu]            %.3f mm, narrowest %.3f, asked %.3f; flat within %.3f, off "
                 "%.3f mm, %.2f degrees; guides %.1f mm\n",
      n, c.slots[n].widthMm, c.slots[n].leastWidthMm, c.claims.slots[n].widthMm,
      c.slots[n].flatnessMm, c.slots[n].offsetMm, c.slots[n].tiltDegrees, c.slots[n].guideMm);
  for (std::size_t n = 0; n < c.holes.size(); ++n)
    text += Line("%-20s%.3f mm, lets %.3f through, asked %.3f; round within %.3f, off "
                 "%.3f mm, %.2f degrees; guides %.1f mm\n",
      NameOfHole(c.claims.holes[n], n).c_str(), c.holes[n].diameterMm, c.holes[n].leastMm,
      c.claims.holes[n].diameterMm, c.holes[n].roundnessMm, c.holes[n].offsetMm,
      c.holes[n].tiltDegrees, c.holes[n].guideMm);
  return text;
}

} // namespace

std::string CertificateVerdict(const FitCertificate& c)
{
  if (!c.Holds())
    return "DOES NOT HOLD";
  return ClaimFit(c.claims) ? "holds" : "the mesh is sound; not held to a recipe";
}

std::string CertificateText(const FitCertificate& c)
{
  std::string text = MeshText(c);
  if (c.gap)
    text += ShellText(c);
  text += CutsText(c);
  if (c.insertion)
    text +=
      c.insertion->blocked == 0
        ? "put on along its axis  yes, no bone in the way\n"
        : Line("put on along its axis  NO, bone %.2f mm deep in the way\n", c.insertion->deepestMm);
  return text + "verdict             " + CertificateVerdict(c) + "\n";
}

} // namespace hasp
