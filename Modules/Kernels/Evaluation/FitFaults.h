#pragma once
#include "Evaluation/FitCertificate.h"

#include <vector>

namespace hasp
{

/// The rules of CertifyFit, one function a measure. They add to `faults`; any thread.
using FitFaults = std::vector<FitFault>;

/// How a claimed shell's gap is measured; claims.shell must be there.
GuideGapSettings GapSettingsOf(const PartClaims& claims);

void JudgeMesh(const FitCertificate& certificate, FitFaults& faults);
void JudgeWalls(const FitCertificate& certificate, FitFaults& faults);
/// `volumeMm3`: of the part.
void JudgeGap(const GuideGap& gap, const ClaimedShell& shell, double volumeMm3, FitFaults& faults);
void JudgeSlot(const SlotFit& fit, const ClaimedSlot& slot, std::size_t number, FitFaults& faults);
void JudgeHole(const HoleFit& fit, const ClaimedHole& hole, std::size_t number, FitFaults& faults);
void JudgeInsertion(const Insertion& insertion, FitFaults& faults);

} // namespace hasp
