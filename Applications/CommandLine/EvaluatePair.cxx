#include "EvaluateSteps.h"
#include "EvaluateText.h"
#include "Failure.h"
#include "Files.h"
#include "Session.h"
#include "VerbWork.h"

#include "Evaluation/PoseDifference.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <iostream>

namespace hasp
{
namespace
{

constexpr double SamePointMm = 1e-3; // 32-bit floats some metres from the origin

/// The pose that takes one surface to the other, if they are the same triangles.
std::optional<RigidPose> SameTriangles(const TriangleMesh& a, const TriangleMesh& b)
{
  if (a.triangles != b.triangles || a.points.size() != b.points.size())
    return std::nullopt;
  const RigidPose bToA = BestAlignment(a.points, b.points);
  for (std::size_t n = 0; n < a.points.size(); ++n)
    if (glm::distance(a.points[n], bToA.Place(b.points[n])) > SamePointMm)
      return std::nullopt;
  return bToA.Inverse();
}

/// Two sides with what they share.
class Pair
{
public:
  Pair(const EvaluateOptions& options, Session& session)
    : A(ReadSide(options.first, session)),
      B(ReadSide(options.second, session)),
      Surfaces(options.volumes, options.surfaces, session),
      ReachMm(options.reachMm),
      Shared(session)
  {
    // Two single surfaces are one fragment, whatever they are called.
    if (!this->A.document && !this->B.document && this->A.fragments.size() == 1 &&
        this->B.fragments.size() == 1)
    {
      auto only = this->B.fragments.extract(this->B.fragments.begin());
      only.key() = this->A.fragments.begin()->first;
      this->B.fragments.insert(std::move(only));
    }
    this->Reference = ReferenceOf(this->A, options.reference);
    if (!this->Reference.empty() && !this->B.fragments.contains(this->Reference))
      throw Failure(ExitCode::BadInput,
        "the reference must be a fragment of both, and the second does not have it");
    this->RequireReference();
  }

  PairResult Compare()
  {
    PairResult result;
    for (const std::string& key : KeysOf(this->A))
      if (key != this->Reference)
      {
        const EvaluatedFragment& fragment = this->A.fragments.at(key);
        if (this->B.fragments.contains(key))
          result.fragments.push_back(this->CompareOne(key, fragment));
        else
          result.onlyFirst.push_back(CalledFragment(key, fragment, this->Shared));
      }
    for (const std::string& key : KeysOf(this->B))
      if (!this->A.fragments.contains(key))
        result.onlySecond.push_back(CalledFragment(key, this->B.fragments.at(key), this->Shared));
    if (result.fragments.empty())
      throw Failure(ExitCode::BadInput,
        "the two have no fragment in common, but for the reference: they are paired by their "
        "names, plans' without a name of their own by their ids");
    if (!this->Reference.empty())
      result.reference =
        CalledFragment(this->Reference, this->A.fragments.at(this->Reference), this->Shared);
    result.referenceMoved = this->ReferenceMoved;
    this->Align(result);
    this->AddFractures(result);
    return result;
  }

private:
  /// Of surfaces it must lie still; what a plan moved is taken back.
  void RequireReference()
  {
    if (this->Reference.empty())
      return;
    const EvaluatedFragment &a = this->A.fragments.at(this->Reference),
                            &b = this->B.fragments.at(this->Reference);
    if (this->A.document && this->B.document)
      this->ReferenceMoved = !(a.scanToPlanned == b.scanToPlanned);
    else if (a.surface && b.surface)
    {
      const double apart =
        MeasureSurfaceDifference(MeasuredSurface(*a.surface), MeasuredSurface(*b.surface))
          .both.meanMm;
      if (apart > 0.05)
        throw Failure(ExitCode::BadInput,
          Line("the reference's two surfaces lie %.3g mm apart, at most 0.05 is expected of one "
               "that stands still: bring both into one frame first",
            apart));
    }
  }

  FragmentResult CompareOne(const std::string& key, const EvaluatedFragment& a)
  {
    const EvaluatedFragment& b = this->B.fragments.at(key);
    FragmentResult result;
    result.id = a.id;
    result.called = CalledFragment(key, a, this->Shared);
    this->Shared.progress.Step("measuring " + result.called);
    const bool oneBone = this->AreOneBone(key);
    const auto first = this->Surfaces.Of(key, this->SidesOf(this->A, key));
    const auto second = this->Surfaces.Of(key, this->SidesOf(this->B, key));
    const RigidPose aPose = PoseBeside(this->A, key, this->Reference),
                    bPose = PoseBeside(this->B, key, this->Reference);
    result.surface = MeasureSurfaceDifference(*first, aPose, *second, bPose);
    std::optional<RigidPose> moved; // from the first surface to the second one
    if (oneBone)
      moved = RigidPose{};
    else if (a.surface && b.surface)
      moved = SameTriangles(*a.surface, *b.surface);
    if (moved)
    {
      const auto points = WeightedPoints(first->Samples());
      result.pose = ComparePoses(aPose, bPose * *moved, points);
      this->Posed.push_back({ aPose, bPose * *moved, points });
      this->PosedAt.push_back(this->Count);
    }
    ++this->Count;
    return result;
  }

  bool AreOneBone(const std::string& key) const
  {
    if (!this->A.fragments.contains(key) || !this->B.fragments.contains(key))
      return false;
    const PlanId a = this->A.fragments.at(key).id, b = this->B.fragments.at(key).id;
    return a != 0 && b != 0 && IsOneBone(this->A, a, this->B, b);
  }
  /// Where the surface of a side's fragment is looked for.
  std::vector<const EvaluatedSide*> SidesOf(const EvaluatedSide& side, const std::string& key) const
  {
    if (this->AreOneBone(key))
      return { &this->A, &this->B };
    return { &side };
  }

  void AddFractures(PairResult& result)
  {
    const auto measured = [&](const EvaluatedSide& side)
    {
      return MeasureFractures(
        side,
        [&](const std::string& key)
        { return this->Surfaces.AtHand(key, this->SidesOf(side, key)); },
        this->ReachMm, this->Shared);
    };
    result.firstFractures = measured(this->A);
    result.secondFractures = measured(this->B);
  }

  /// What is left when all fragments are brought together as one body.
  void Align(PairResult& result)
  {
    if (this->Posed.size() < 2)
      return;
    std::vector<PosedPoints> posed;
    for (const OwnPoints& own : this->Posed)
      posed.push_back({ own.first, own.second, own.points });
    const RigidPose aligned = BestAlignment(posed);
    for (std::size_t n = 0; n < posed.size(); ++n)
      result.fragments[this->PosedAt[n]].aligned =
        ComparePoses(posed[n].first, aligned * posed[n].second, posed[n].points);
  }

  struct OwnPoints
  {
    RigidPose first, second;
    std::vector<WeightedPoint> points;
  };
  EvaluatedSide A, B;
  EvaluatedSurfaces Surfaces;
  double ReachMm;
  Session& Shared;
  std::string Reference;
  bool ReferenceMoved = false;
  std::vector<OwnPoints> Posed;
  std::vector<std::size_t> PosedAt;
  std::size_t Count = 0;
};

} // namespace

std::string CalledFragment(
  const std::string& key, const EvaluatedFragment& fragment, const Session& session)
{
  if (session.showNames && key.front() != '#')
    return PrintableName(key);
  return fragment.id != 0 ? "fragment " + std::to_string(fragment.id) : "the fragment";
}

RigidPose PoseBeside(
  const EvaluatedSide& side, const std::string& key, const std::string& reference)
{
  const RigidPose& pose = side.fragments.at(key).scanToPlanned;
  return reference.empty() ? pose : side.fragments.at(reference).scanToPlanned.Inverse() * pose;
}

void EvaluatePair(const EvaluateOptions& options, Session& session)
{
  if (!options.csv.empty())
    RequireWritable(options.csv, { ".csv" });
  const PairResult result =
    Try(ExitCode::BadInput, "", [&] { return Pair(options, session).Compare(); });
  session.progress.Wipe();
  session.result.update(JsonOf(result));
  if (!session.json)
    std::cout << TextOf(result);
  if (!options.csv.empty())
    WriteFile(options.csv, CsvOf(result));
}

} // namespace hasp
