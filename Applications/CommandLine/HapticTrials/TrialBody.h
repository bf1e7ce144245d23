#pragma once
#include "Grid/RigidPose.h"
#include "Haptics/DistanceMap.h"
#include "Haptics/PointShell.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace hasp
{

/// A body in closed form: about a distance, mm, negative inside, and rough in each direction.
struct TrialShape
{
  double radius = 38.0; ///< mm
  double bump = 0.8;    ///< height of its bumps, mm; their slope stays within a fifth of 1
  double perBump = 6.0; ///< bumps are 2 pi radius / perBump apart; not the same along all axes
};

/// It on n^3 samples, 1 mm apart, the grid's middle at the origin; with its int16 map, which keeps
/// the float one as well. WORKER.
class TrialBody
{
public:
  TrialBody(int samples, const TrialShape& shape);

  GridView<const float> View() const { return { this->Samples.data(), this->Grid }; }
  const std::shared_ptr<const DistanceMap>& Map() const { return this->BakedMap; }
  double Radius() const { return this->Shape.radius; }
  int Size() const { return this->Grid.dims.x; }
  std::shared_ptr<const PointShell> Shell(int points, std::uint32_t seed = 1) const;
  /// The part that fits: the same surface, which looks the other way.
  std::shared_ptr<const PointShell> FittingShell(int points) const;

private:
  TrialShape Shape;
  GridGeometry Grid;
  std::vector<float> Samples;
  std::shared_ptr<const DistanceMap> BakedMap;
};

/// The body that the SIMD rows name: bumpy, with room around it.
TrialShape BumpyShape(int samples);

/// The levels up to `last`, each point for its share of the whole surface.
std::vector<ContactPoints> UpTo(const PointShell& shell, int last);

/// Against its own surface, moved by up to 1 mm: half of the points in contact.
std::vector<RigidPose> FitPoses(int count, std::uint64_t seed);
/// Against a body as round, pressed in by 0.2 to 1 mm: less than one in a hundred.
std::vector<RigidPose> PressPoses(int count, double radius, std::uint64_t seed);

/// What `wrench` is off by: of the force, or of the torque at the radius, relative to the force.
double WrenchError(const Wrench& wrench, const Wrench& truth, double radius);

/// The larger one; what is no number is worse than any.
double WorseOf(double a, double b);

/// "id", or "id@figure" where the figure is not the one that the plain id stands for.
std::string IdAt(const std::string& id, int figure, int plain);

} // namespace hasp
