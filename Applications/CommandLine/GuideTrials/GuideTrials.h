#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace hasp
{

struct ReportContext;

/// What `hasp report guides` measures without VTK; what needs it is handed in. Each puts rows into
/// the report. WORKER.

/// A run of the child process that makes random parts: a crash, or a loop without an end, costs one
/// part and not the report.
struct PartRun
{
  std::string output; ///< PartLines, as far as it came
  std::string ending; ///< empty: it came to its end; else "exit code 139", "120 s"
};
struct RandomKind
{
  std::string name;       ///< "guide", "plate" ...; "cut" for osteotomies, which are no parts
  std::size_t shares = 0; ///< of all parts; 0 of cuts
};
struct PartRunner
{
  std::string absent{}; ///< why there is no such program
  std::vector<RandomKind> kinds{};
  std::function<PartRun(const std::string& kind, std::uint32_t first, std::size_t count)> run{};
};

/// guides.manifold, guides.crashes, guides.fallback, guides.refused: so many random parts, of each
/// kind its shares of them; guides.planes: the saw planes of those that are guides, fitted to what
/// was written; guides.conservation: so many osteotomies, which no other row counts. Without the
/// program manifold, planes and conservation say that they are absent, and there are no others.
void TryParts(
  ReportContext& context, const PartRunner& runner, std::size_t parts, std::size_t cuts);

/// guides.certificate.found, guides.certificate.false: so many of each of ten defects, and ten
/// times as many clean ones.
void TryCertificates(ReportContext& context, std::size_t ofEach);

/// guides.plan: so many random plans, saved and loaded, undone and redone, damaged.
void TryPlans(ReportContext& context, std::size_t plans);

} // namespace hasp
