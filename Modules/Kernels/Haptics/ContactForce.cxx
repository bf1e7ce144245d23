#include "Haptics/ContactForce.h"

#include "Haptics/ContactFrame.h"
#include "Haptics/Solve6.h"

#include <algorithm>

namespace hasp
{
namespace
{

void AddWrench(const std::array<double, 6>& sum, const glm::dmat3& turn, double factor, Wrench& to)
{
  to.force += factor * (turn * glm::dvec3(sum[0], sum[1], sum[2]));
  to.torque += factor * (turn * glm::dvec3(sum[3], sum[4], sum[5]));
}

/// Turns each 3x3 block: T B T^t.
void AddMatrix(const std::array<double, 21>& sum, const glm::dmat3& turn, double factor,
  std::array<double, 21>& to)
{
  const glm::dmat3 back = glm::transpose(turn);
  for (int rows = 0; rows < 6; rows += 3)
    for (int columns = rows; columns < 6; columns += 3)
    {
      glm::dmat3 block;
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
          block[c][r] =
            sum[UpperIndex(std::min(rows + r, columns + c), std::max(rows + r, columns + c))];
      block = turn * block * back;
      for (int r = 0; r < 3; ++r)
        for (int c = rows == columns ? r : 0; c < 3; ++c)
          to[UpperIndex(rows + r, columns + c)] += factor * block[c][r];
    }
}

} // namespace

ContactSums& ContactSums::operator+=(const ContactSums& other) noexcept
{
  this->contact += other.contact;
  this->attraction += other.attraction;
  for (std::size_t n = 0; n < this->matrix.size(); ++n)
    this->matrix[n] += other.matrix[n];
  this->contactArea += other.contactArea;
  this->attractedArea += other.attractedArea;
  this->deepestMm = std::min(this->deepestMm, other.deepestMm);
  this->energy += other.energy;
  this->contacts += other.contacts;
  return *this;
}

void ShellSums::Scale(double pointArea, double depthMm, double pushMm) noexcept
{
  for (double& sum : this->push)
    sum *= pointArea * pushMm;
  for (double& sum : this->pull)
    sum *= pointArea;
  for (double& sum : this->matrix)
    sum *= pointArea;
  this->squares *= pointArea * depthMm * depthMm;
  this->area *= pointArea;
  this->attractedArea *= pointArea;
  this->deepestMm *= depthMm;
}

void ShellSums::AddTo(ContactTerms terms, const glm::dmat3& shellToMap,
  const ContactSettings& settings, ContactSums& sums) const noexcept
{
  const double k = settings.stiffness;
  if (this->contacts > 0)
  {
    AddWrench(this->push, shellToMap, -k, sums.contact);
    if (terms != ContactTerms::Force)
      AddMatrix(this->matrix, shellToMap, k, sums.matrix);
    sums.contactArea += this->area;
    sums.deepestMm = std::min(sums.deepestMm, this->deepestMm);
    sums.energy += 0.5 * k * this->squares;
    sums.contacts += this->contacts;
  }
  if (this->attractedArea > 0.0)
  {
    const double most = static_cast<double>(settings.fade) * settings.attraction;
    AddWrench(this->pull, shellToMap, -most, sums.attraction);
    sums.attractedArea += this->attractedArea;
  }
}

} // namespace hasp
