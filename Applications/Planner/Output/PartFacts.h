#pragma once
#include "Evaluation/FitCertificate.h"
#include "Planning/Plan.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <string>

namespace hasp
{

struct Planner;

enum class PartState
{
  NotMade,
  OutOfDate,
  InDate,
  DoesNotHold ///< it was made of the plan as it is, does not hold, and is not kept
};

enum class FitVerdict
{
  Green,
  Red,
  NotCertified ///< nothing that can be measured is claimed of it: WhyNotCertified
};

/// What is known of a part of the plan.
struct PartFacts
{
  PlanId object = 0;
  QString called; ///< "guide 8"
  PartState state = PartState::NotMade;
  QString why; ///< it is not in date; empty: it is
  /// Of the part as it is in date, or does not hold; else none.
  std::optional<FitVerdict> verdict;
  QStringList faults; ///< of a red one, in words
  PlanId heldTo = 0;  ///< a fragment alone; 0: all bone
  double volumeMm3 = 0.0;
  std::optional<FitCertificate> certificate;
  std::string report; ///< that all this was read from; empty: none
  std::string stl;    ///< the SHA-256 of the kept part's bytes; empty: none is kept
};

/// Reads the report of the part of that object, from the plan's folder or RedParts. One that is
/// damaged is as good as not made, and `why` says so. RENDER; some milliseconds: keep it until the
/// plan, its parts or RedParts change.
PartFacts FactsOf(Planner& planner, PlanId object);

/// Why a part that is in date has no certificate, and what to do about it; empty: it has one, or is
/// not in date.
QString WhyNotCertified(const Plan& plan, const PartFacts& facts);

/// Whether it can be put on bone: it says how, or has a wall that lies on it.
bool IsPutOnBone(const PartFacts& facts);

/// Why it must not leave the planner: "guide 8 is out of date: cut 6 has changed"; empty: it may.
QString WhyNotExported(const PartFacts& facts);

} // namespace hasp
