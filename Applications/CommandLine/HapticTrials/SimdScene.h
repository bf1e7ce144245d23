#pragma once
#include "ContactRivals.h"
#include "Haptics/ContactForce.h"
#include "TrialBody.h"

#include <string>

namespace hasp
{

/// A bumpy ball against itself, turned and moved by half a voxel: half of the points in contact, in
/// the shell's own order; and what rivals read of the same body.
class SimdScene
{
public:
  SimdScene(int samples, int points);

  int Size() const { return this->Body.Size(); }
  double Radius() const { return this->Body.Radius(); }
  std::uint32_t Points() const { return this->Count; }

  ContactSums Ours(const ContactKernels& kernels, ContactTerms terms) const;
  /// Float distances, in double precision.
  ContactSums Truth(ContactTerms terms) const;
  /// Plain code, Force or Matrix: compiled with -O2, or with -O3 -march=native.
  ContactSums Rival(ContactTerms terms, bool native) const;

private:
  TrialBody Body;
  std::shared_ptr<const PointShell> Shell;
  std::uint32_t Count = 0;
  std::vector<ContactPoints> Runs;
  std::vector<rival::Point> Structures; ///< the same, in the same order
  ContactPlacement Placement;
  ContactSettings Settings{ .attraction = 0.01F, .captureMm = 3.0F };
  rival::Pose RivalPose;
  rival::Map RivalMap;
};

/// Those of this build and processor whose name begins so: "AVX2", or "AVX3" for AVX-512. Null:
/// none.
const ContactKernels* FindKernels(const std::string& prefix);
/// Why not: of this build, or of the processor.
std::string WhyNoKernels(const std::string& name);

} // namespace hasp
