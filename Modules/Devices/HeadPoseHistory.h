#pragma once
#include "Devices/HeadMotionFit.h"
#include "Devices/HeadPose.h"

#include <array>
#include <cstddef>

namespace hasp
{

struct PredictionLimits
{
  double timeS = 0.15;
  double lengthMm = 80.0;
  double angleRad = 0.35;
};

/// The last poses of a head and the even motion through them. Takes no memory; one thread.
class HeadPoseHistory
{
public:
  /// fitS  how long the poses of a fit lie apart at most, where there are five or more
  explicit HeadPoseHistory(double fitS) : FitS(fitS) {}

  bool Empty() const { return this->Count == 0; }
  const TimedHeadPose& Newest() const { return this->Poses[this->Count - 1]; } ///< not if Empty

  void Clear() { this->Count = 0; }
  /// A pose later than the newest. Where they come closer than FitS / 20 the newest gives way.
  void Add(const TimedHeadPose& pose);
  /// The head keeps still: the newest pose alone is left, now of this time. True if it moved
  /// before.
  bool KeepStill(double timeS);

  /// Where the head will be, as far as the limits go. Not if Empty.
  HeadPose Predict(double timeS, const PredictionLimits& limits) const;

private:
  void Fit();

  double FitS;
  std::array<TimedHeadPose, MostMotionSamples> Poses; ///< by time
  std::size_t Count = 0;
  EvenMotion Position; ///< at the newest pose's time
  EvenMotion Turn;     ///< rotation vector from the newest orientation, room axes, radians
};

} // namespace hasp
