#include "CertificateTable.h"

#include <algorithm>
#include <cstdio>
#include <initializer_list>

namespace hasp
{
namespace
{

std::string Text(const char* format, auto... figures)
{
  char text[240];
  std::snprintf(text, sizeof text, format, figures...);
  return text;
}

std::string Place(const glm::dvec3& p)
{
  return Text("(%.1f, %.1f, %.1f)", p.x, p.y, p.z);
}

class Table
{
public:
  explicit Table(const FitCertificate& certificate) : C(certificate) {}

  std::vector<CertificateRow> Rows()
  {
    this->Mesh();
    this->Walls();
    if (this->C.gap)
      this->Gap();
    for (std::size_t n = 0; n < this->C.slots.size(); ++n)
      this->Slot(n);
    for (std::size_t n = 0; n < this->C.holes.size(); ++n)
      this->Hole(n);
    if (this->C.insertion)
      this->All.push_back({ "put on along its axis",
        this->C.insertion->blocked == 0
          ? "nothing in the way"
          : Text("bone %.2f mm deep in the way, %.1f mm2 of the part", this->C.insertion->deepestMm,
              this->C.insertion->blockedMm2),
        "no bone in the way", this->Is({ FitFaultKind::Undercut }) });
    return std::move(this->All);
  }

private:
  bool Is(std::initializer_list<FitFaultKind> kinds) const
  {
    return std::any_of(this->C.faults.begin(), this->C.faults.end(),
      [&](const FitFault& fault)
      { return std::find(kinds.begin(), kinds.end(), fault.kind) != kinds.end(); });
  }
  bool IsOf(const std::string& object) const
  {
    return std::any_of(this->C.faults.begin(), this->C.faults.end(),
      [&](const FitFault& fault) { return fault.text.starts_with(object); });
  }

  void Mesh()
  {
    const MeshCheck& m = this->C.mesh;
    const glm::dvec3 size = this->C.high - this->C.low;
    const auto count = [](std::size_t n) { return std::to_string(n); };
    this->All = {
      { "box", Text("%.1f x %.1f x %.1f mm", size.x, size.y, size.z), "",
        this->Is({ FitFaultKind::Units, FitFaultKind::Mirrored, FitFaultKind::Space }) },
      { "volume, area", Text("%.1f mm3, %.1f mm2", m.volumeMm3, m.areaMm2), "" },
      { "triangles", count(m.triangles) + ", of them slivers " + count(this->C.slivers), "" },
      { "pieces", count(this->C.pieces.size()), count(this->C.claims.pieces),
        this->C.pieces.size() != this->C.claims.pieces },
      { "open edges", count(m.borderEdges), "0", this->Is({ FitFaultKind::NotClosed }) },
      { "edges and points that are not 2-manifold", count(m.crowdedEdges + m.pinchedPoints), "0",
        this->Is({ FitFaultKind::NotManifold }) },
      { "turned edges", count(m.turnedEdges) + (m.Outward() ? "" : ", inside out"), "0, outward",
        this->Is({ FitFaultKind::Turned }) },
      { "triangles without an area", count(m.degenerate), "0", this->Is({ FitFaultKind::NoArea }) },
      { "pairs of triangles that meet",
        this->C.selfIntersections ? count(*this->C.selfIntersections) : "not measured", "0",
        this->Is({ FitFaultKind::MeetsItself, FitFaultKind::NotChecked }),
        !this->C.selfIntersections },
    };
  }

  void Walls()
  {
    const WallThickness& wall = this->C.wall;
    if (wall.wallMm2 > 0.0)
      this->All.push_back(
        { "thinnest wall", Text("%.2f mm at ", wall.leastMm) + Place(wall.leastAt),
          Text("at least %.2f mm", this->C.claims.leastWallMm),
          wall.leastMm < this->C.claims.leastWallMm });
    if (const auto& uncut = this->C.uncut; uncut && uncut->wallMm2 > 0.0)
      this->All.push_back({ "thinnest wall away from slots and holes",
        Text("%.2f mm at ", uncut->leastMm) + Place(uncut->leastAt),
        Text("at least %.2f mm", this->C.claims.leastUncutMm),
        uncut->leastMm < this->C.claims.leastUncutMm });
    if (!this->C.shell || !this->C.claims.shell)
      return;
    const ClaimedShell& claim = *this->C.claims.shell;
    const double least = claim.thicknessMm - claim.thicknessToleranceMm;
    const bool there = this->C.shell->shellMm2 > 0.0;
    this->All.push_back({ "shell, least and median",
      there ? Text("%.2f mm, %.2f mm", this->C.shell->leastMm, this->C.shell->p50Mm) : "not found",
      Text(
        "at least %.2f mm: %.2f less %.2f", least, claim.thicknessMm, claim.thicknessToleranceMm),
      there && this->C.shell->leastMm < least, !there });
  }

  void Gap()
  {
    const GuideGap& gap = *this->C.gap;
    const ClaimedShell& claim = *this->C.claims.shell;
    this->All.push_back({ "gap, 5 %, median, 95 % of the area",
      Text("%.3f, %.3f, %.3f mm; asked %.3f", gap.p5, gap.p50, gap.p95, claim.gapMm), "" });
    this->All.push_back({ Text("inner wall within %.2f mm of that", claim.gapToleranceMm),
      Text("%.2f %% of %.1f mm2", 100.0 * gap.share, gap.innerWallMm2),
      Text("at least %.1f %%", 100.0 * claim.leastGapShare), this->Is({ FitFaultKind::Gap }) });
    const bool near = gap.leastAnywhere < 1e30;
    this->All.push_back({ "nearest to bone of all walls",
      near ? Text("%.3f mm at ", gap.leastAnywhere) + Place(gap.leastAnywhereAt)
           : "none within reach",
      "outside of bone", this->Is({ FitFaultKind::TouchesBone }), !near });
  }

  void Slot(std::size_t n)
  {
    const SlotFit& fit = this->C.slots[n];
    const ClaimedSlot& claim = this->C.claims.slots[n];
    const std::string name = "slots[" + std::to_string(n) + "]";
    this->All.push_back({ name,
      Text("%.3f mm wide, narrowest %.3f; flat within %.3f; off %.3f mm, %.2f degrees; guides %.1f "
           "mm",
        fit.widthMm, fit.leastWidthMm, fit.flatnessMm, fit.offsetMm, fit.tiltDegrees, fit.guideMm),
      Text("%.3f mm within %.2f, and all else within that", claim.widthMm, claim.toleranceMm),
      this->IsOf(name) });
  }

  void Hole(std::size_t n)
  {
    const HoleFit& fit = this->C.holes[n];
    const ClaimedHole& claim = this->C.claims.holes[n];
    const std::string name = NameOfHole(claim, n);
    this->All.push_back({ name,
      Text("%.3f mm, lets %.3f through; round within %.3f; off %.3f mm, %.2f degrees; guides %.1f "
           "mm",
        fit.diameterMm, fit.leastMm, fit.roundnessMm, fit.offsetMm, fit.tiltDegrees, fit.guideMm),
      Text("%.3f mm within %.2f, and its place within that", claim.diameterMm, claim.toleranceMm),
      this->IsOf(name) });
  }

  const FitCertificate& C;
  std::vector<CertificateRow> All;
};

} // namespace

std::vector<CertificateRow> CertificateTable(const FitCertificate& certificate)
{
  return Table(certificate).Rows();
}

} // namespace hasp
