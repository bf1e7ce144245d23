#pragma once
#include "Haptics/ContactForce.h"
#include "Testing/ContactMap.h"
#include "Testing/Dice.h"
#include "Testing/ShellOfPoints.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace hasp
{

constexpr ContactTerms AllTerms[] = { ContactTerms::Force, ContactTerms::Matrix,
  ContactTerms::Snap };

/// A map in float and in int16, and whoever reads them. The reference computes in double, from
/// float distances: 1e-6 of them. int16 with a range of 8 mm is 1.2e-4 mm off at most: 1e-3 of the
/// depths here, half a millimetre, and less in a sum.
struct Reader
{
  const char* name;
  double tolerance;
  std::function<ContactSums(
    ContactTerms, const ContactPoints&, const RigidPose&, const ContactSettings&)>
    feel;
};

class Scene
{
public:
  Scene(const GridGeometry& grid, double range, const testing::DistanceFunction& distance)
    : Map(grid, range, distance)
  {
    this->Readers.push_back({ "reference", 2e-6,
      [this](ContactTerms terms, const ContactPoints& points, const RigidPose& pose,
        const ContactSettings& settings)
      {
        ContactSums sums;
        ContactForceReference(terms, points, { pose }, this->Map.Floats(), settings, sums);
        return sums;
      } });
    for (const ContactKernels& kernels : AllContactKernels())
      this->Readers.push_back({ kernels.name, 1e-3,
        [this, kernels](ContactTerms terms, const ContactPoints& points, const RigidPose& pose,
          const ContactSettings& settings)
        {
          ContactSums sums;
          kernels[terms](points, { pose }, this->Map.Shorts(), settings, sums);
          return sums;
        } });
  }

  ContactMap Map;
  std::vector<Reader> Readers;
};

inline void ExpectNear(const glm::dvec3& a, const glm::dvec3& b, double within, const char* what)
{
  EXPECT_LE(glm::length(a - b), within)
    << what << ": (" << a.x << ", " << a.y << ", " << a.z << ") against (" << b.x << ", " << b.y
    << ", " << b.z << ")";
}

inline void ExpectNothing(const ContactSums& sums, const char* who)
{
  EXPECT_EQ(sums.contacts, 0U) << who;
  EXPECT_EQ(sums.contactArea, 0.0) << who;
  EXPECT_EQ(sums.attractedArea, 0.0) << who;
  EXPECT_EQ(sums.energy, 0.0) << who;
  EXPECT_EQ(sums.deepestMm, 0.0) << who;
  EXPECT_EQ(sums.contact.force, glm::dvec3(0.0)) << who;
  EXPECT_EQ(sums.attraction.torque, glm::dvec3(0.0)) << who;
  for (const double entry : sums.matrix)
    EXPECT_EQ(entry, 0.0) << who;
}

} // namespace hasp
