#include "SimdScene.h"

#include <algorithm>

namespace hasp
{

SimdScene::SimdScene(int samples, int points)
  : Body(samples, BumpyShape(samples)),
    Shell(this->Body.Shell(points)),
    Runs(UpTo(*this->Shell, this->Shell->Levels() - 1)),
    Placement{ { { 0.25, -0.2, 0.3 }, TurnBy({ 0.02, -0.01, 0.015 }) } }
{
  this->Count = this->Shell->LevelEnd(this->Shell->Levels() - 1);
  for (const ContactPoints& run : this->Runs)
    for (std::uint32_t n = 0; n < run.count; ++n)
      if (run.x[n] != ContactPoints::FarAway)
        this->Structures.push_back(
          { { run.x[n], run.y[n], run.z[n] }, { run.nx[n], run.ny[n], run.nz[n] } });
  const RigidPose& pose = this->Placement.shellInMap;
  this->RivalPose = { glm::mat3(glm::mat3_cast(pose.orientation)), glm::vec3(pose.position) };
  const GridView<const float> view = this->Body.View();
  this->RivalMap = { view.data, view.geometry.dims, glm::vec3(view.geometry.origin), 1.0F };
}

ContactSums SimdScene::Ours(const ContactKernels& kernels, ContactTerms terms) const
{
  ContactSums sums;
  kernels[terms](std::span<const ContactPoints>(this->Runs), this->Placement,
    this->Body.Map()->View(), this->Settings, sums);
  return sums;
}

ContactSums SimdScene::Truth(ContactTerms terms) const
{
  ContactSums sums;
  ContactForceReference(terms, std::span<const ContactPoints>(this->Runs), this->Placement,
    this->Body.Map()->Reference(), this->Settings, sums);
  return sums;
}

ContactSums SimdScene::Rival(ContactTerms terms, bool native) const
{
  const float stiffness = this->Settings.stiffness * this->Runs.front().area;
  const auto feel = terms == ContactTerms::Force
                      ? (native ? rival::native::Force : rival::o2::Force)
                      : (native ? rival::native::Matrix : rival::o2::Matrix);
  const rival::Sums felt = feel(this->Structures, this->RivalPose, this->RivalMap, stiffness);
  ContactSums sums;
  sums.contact = { glm::dvec3(felt.force), glm::dvec3(felt.torque) };
  std::copy(std::begin(felt.matrix), std::end(felt.matrix), sums.matrix.begin());
  sums.contacts = static_cast<std::uint32_t>(felt.contacts);
  return sums;
}

const ContactKernels* FindKernels(const std::string& prefix)
{
  static const std::vector<ContactKernels> all = AllContactKernels();
  const auto found = std::find_if(all.rbegin(), all.rend(),
    [&](const ContactKernels& kernels) { return std::string(kernels.name).starts_with(prefix); });
  return found == all.rend() ? nullptr : &*found;
}

std::string WhyNoKernels(const std::string& name)
{
#if HASP_WITH_HIGHWAY
  return "this processor has no " + name;
#else
  return "this build has no Highway (HASP_ENABLE_HIGHWAY), so no " + name;
#endif
}

} // namespace hasp
