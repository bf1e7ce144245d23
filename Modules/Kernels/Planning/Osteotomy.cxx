#include "Planning/Osteotomy.h"

#include "Planning/ValueChecks.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace hasp
{

void ValidateOsteotomy(const Osteotomy& cut, const std::string& subject)
{
  const ValueChecks check(subject);
  check.Point("point", cut.point);
  check.Unit("normal", cut.normal);
  check.Unit("along", cut.along);
  if (const double cosine = glm::dot(cut.normal, cut.along); !(std::abs(cosine) <= 1e-3))
    check.Refuse("along: its cosine with normal", cosine, "0 within 0.001");
  check.AboveUpTo("widthMm", cut.widthMm, 0.0, 500.0);
  check.AboveUpTo("depthMm", cut.depthMm, 0.0, 500.0);
  check.AboveUpTo("kerfMm", cut.kerfMm, 0.0, 5.0);
}

} // namespace hasp
