#include "DynamicScene.h"

#include "Haptics/ContactForce.h"

#include <glm/geometric.hpp>

namespace hasp
{

DynamicScene::DynamicScene(int pointsOfTruth) : truth(this->body.Shell(pointsOfTruth, 7))
{
  this->volume.grid = this->body.View();
  this->volume.blocks = std::make_shared<MinMaxBlocks>(this->volume.grid);
  this->volume.insideAbove = false;
}

Wrench DynamicScene::Feel(const RigidPose& pose, const ContactPoints& points) const
{
  ContactSums sums;
  FastestContactKernels()[ContactTerms::Force](
    points, { pose }, this->body.Map()->View(), {}, sums);
  return sums.contact;
}

Wrench DynamicScene::Feel(const RigidPose& pose, const PointShell& shell) const
{
  Wrench sum;
  for (const ContactPoints& run : UpTo(shell, shell.Levels() - 1))
    sum += this->Feel(pose, run);
  return sum;
}

RigidPose DynamicScene::Touching(
  const glm::dvec3& way, const glm::dquat& turn, const PointShell& shell, double deep) const
{
  double near = 0.5 * this->body.Size(), far = this->body.Size();
  while (far - near > 0.01)
  {
    const double middle = 0.5 * (near + far);
    const bool touches = glm::length(this->Feel({ middle * way, turn }, shell).force) > 0.0;
    (touches ? near : far) = middle;
  }
  return { (near - deep) * way, turn };
}

} // namespace hasp
