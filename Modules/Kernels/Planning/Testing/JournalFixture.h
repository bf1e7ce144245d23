#pragma once
#include "InChild.h"
#include "PlanFixture.h"
#include "Planning/PlanJournal.h"

#include <fstream>
#include <utility>

/// A folder for a journal.
class JournalFolder : public PlanFolder
{
public:
  std::filesystem::path Path() const { return this->Plan().parent_path(); }
  std::filesystem::path Journal() const { return this->Path() / "7.journal"; }
};

/// What a planner does, the same for the same seed: steps, some of them undone and done again, and
/// parts. Each action changes the document.
class RandomActions
{
public:
  explicit RandomActions(unsigned seed) : RandomActions(seed, RandomDocument(seed, 5)) {}
  RandomActions(unsigned seed, hasp::PlanDocument start)
    : Random(seed + 1000),
      Document(std::move(start))
  {
  }

  const hasp::PlanDocument& Now() const { return this->Document; }
  const hasp::PlanDocument& Next()
  {
    hasp::PlanHistory& history = this->Document.history;
    const int kind = this->Random.Below(10);
    if (kind < 2 && history.ToUndo())
      history.Undo();
    else if (kind < 4 && history.ToRedo())
      history.Redo();
    else if (kind == 4)
      hasp::KeepPart(this->Document.parts,
        { hasp::PlanId(1 + this->Random.Below(3)), hasp::PartFormat::Stl,
          { { 2, hasp::PartFacet::Place, this->Random.Hash() } }, this->Random.Hash(), "" });
    else
      history.Do(this->Random.Next(history.Current(), history.NewId()));
    return this->Document;
  }

private:
  RandomEdits Random;
  hasp::PlanDocument Document;
};

/// A plan with a segmentation, and strokes of so many points: actions as large as one likes.
inline hasp::PlanDocument ToPaint()
{
  hasp::PlanDocument document;
  document.history.Do({ hasp::AddObject<hasp::PlanVolume>{ { 1, "", std::string(64, 'a') } },
    hasp::AddObject<hasp::PlanSegmentation>{ { 2, "", 1, "", {} } } });
  document.history.Do(hasp::AddSegmentationStep{ 2, hasp::SplitStep{} });
  return document;
}

inline hasp::AddSegmentationStroke Stroke(RandomEdits& random, std::size_t points)
{
  hasp::BrushStroke stroke;
  while (stroke.points.size() < points)
    stroke.points.emplace_back(
      random.Number(-200, 200), random.Number(-200, 200), random.Number(-200, 200));
  return { 2, std::move(stroke) };
}
