#pragma once
#include "Planning/PlanFile.h"
#include "RandomEdits.h"

/// A history of `steps` steps, some of them undone, and parts.
inline hasp::PlanDocument RandomDocument(unsigned seed, int steps)
{
  RandomEdits random(seed);
  hasp::PlanDocument document{ hasp::PlanHistory(random.MakePlan(random.Below(8))), {} };
  for (int n = 0; n < steps; ++n)
  {
    hasp::PlanHistory& history = document.history;
    history.Do(random.Next(history.Current(), history.NewId()));
    if (random.Below(5) == 0)
      history.Undo();
  }
  for (int n = random.Below(3); n > 0; --n)
  {
    const auto facet = hasp::PartFacet(random.Below(3));
    const hasp::PlanId of = facet == hasp::PartFacet::CaseLabel ? 0 : 2;
    document.parts.push_back({ 1, hasp::PartFormat(random.Below(5)),
      { { of, facet, random.Hash() } }, random.Hash(), random.Below(2) == 0 ? "" : random.Hash() });
  }
  return document;
}
