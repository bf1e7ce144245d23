#include "Haptics/HapticScene.h"
#include "Haptics/Solve6.h"
#include "Haptics/VirtualCoupling.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace hasp
{
namespace
{

/// The share of its own area that a point of `level` stands for, if levels up to `finest` count:
/// areas of coarser shells are larger, S / LevelEnd.
double AreaShare(const PointShell& shell, int level, double finest) noexcept
{
  const int last = shell.Levels() - 1;
  const int low = std::clamp(static_cast<int>(finest), 0, last), high = std::min(low + 1, last);
  const double blend = std::clamp(finest - low, 0.0, 1.0);
  const auto area = [&](int n) { return 1.0 / shell.LevelEnd(n); };
  const double mine =
    (level <= low ? (1.0 - blend) * area(low) : 0.0) + (level <= high ? blend * area(high) : 0.0);
  return mine / area(level);
}

/// What a share of a pair's contact feels: its stiffness by the cube of how grown it is. Hardening
/// comes last of all, for a little of it is felt more than much of the stiffness.
ContactSettings Grown(ContactSettings settings, double grown, double share = 1.0) noexcept
{
  const double weight = grown * grown * grown;
  settings.stiffness *= static_cast<float>(weight * share);
  settings.attraction *= static_cast<float>(weight * share);
  settings.hardening *= static_cast<float>(weight * weight);
  return settings;
}

/// Of the ball around the body's origin that holds the whole volume, mm.
double RadiusOf(const DynamicShellSource& source)
{
  const GridGeometry& grid = GeometryOf(source.volume.grid);
  double radius = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::ivec3 at = glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2) * grid.Cells();
    radius = std::max(radius, glm::distance(grid.IndexToWorld(at), source.origin));
  }
  return radius;
}

/// [R 0; [p]x R  R]: how a force and its torque are seen from elsewhere.
std::array<std::array<double, 6>, 6> Transform(const glm::dquat& turn, const glm::dvec3& p) noexcept
{
  const glm::dmat3 r = glm::mat3_cast(turn); // columns
  std::array<std::array<double, 6>, 6> t{};
  for (int column = 0; column < 3; ++column)
  {
    const glm::dvec3 crossed = glm::cross(p, r[column]);
    for (int row = 0; row < 3; ++row)
    {
      t[row][column] = t[row + 3][column + 3] = r[column][row];
      t[row + 3][column] = crossed[row];
    }
  }
  return t;
}

} // namespace

ContactSums Moved(const ContactSums& sums, const glm::dquat& turn, const glm::dvec3& arm) noexcept
{
  ContactSums moved = sums;
  const auto seen = [&](const Wrench& wrench)
  {
    const glm::dvec3 force = turn * wrench.force;
    return Wrench{ force, turn * wrench.torque + glm::cross(arm, force) };
  };
  moved.contact = seen(sums.contact);
  moved.attraction = seen(sums.attraction);
  if (sums.contacts == 0)
    return moved; // nothing is in the matrix
  const auto t = Transform(turn, arm);
  std::array<std::array<double, 6>, 6> half{}; // T M
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j)
      for (std::size_t k = 0; k < 6; ++k)
        half[i][j] += t[i][k] * sums.matrix[UpperIndex(std::min(k, j), std::max(k, j))];
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = i; j < 6; ++j)
    {
      double sum = 0.0;
      for (std::size_t k = 0; k < 6; ++k)
        sum += half[i][k] * t[j][k];
      moved.matrix[UpperIndex(i, j)] = sum;
    }
  return moved;
}

HapticScene::HapticScene(
  std::vector<HapticShell> shells, std::vector<HapticBody> bodies, const ContactKernels& kernels)
  : Shells(std::move(shells)),
    Bodies(std::move(bodies)),
    Kernels(kernels),
    FinestMm(std::numeric_limits<double>::infinity())
{
  int levels = 0;
  for (HapticShell& shell : this->Shells)
  {
    if (!IsPose(shell.shellInTool))
      throw std::invalid_argument("A shell of a haptic scene has no pose");
    shell.shellInTool.orientation = glm::normalize(shell.shellInTool.orientation);
    if ((shell.shell == nullptr) == (shell.dynamic == nullptr))
      throw std::invalid_argument(
        "A shell of a haptic scene is neither static nor dynamic, or both; set one of them");
    levels = std::max(levels, shell.shell ? shell.shell->Levels() : 1);
    const double radius = shell.shell ? shell.shell->Radius() : RadiusOf(*shell.dynamic);
    this->FarthestMm = std::max(this->FarthestMm, glm::length(shell.shellInTool.position) + radius);
  }
  for (HapticBody& body : this->Bodies)
  {
    if (!body.map || !IsPose(body.mapInWorld))
      throw std::invalid_argument("A body of a haptic scene is null or has no pose");
    body.mapInWorld.orientation = glm::normalize(body.mapInWorld.orientation);
    this->FinestMm = std::min(this->FinestMm, body.map->SmallestSpacing());
  }
  this->Near.resize(static_cast<std::size_t>(levels));
  for (std::size_t s = 0; s < this->Shells.size(); ++s)
    for (std::size_t b = 0; b < this->Bodies.size(); ++b)
    {
      const HapticShell& shell = this->Shells[s];
      const auto& map = this->Bodies[b].map;
      Pair& pair = this->Pairs.emplace_back(Pair{ s, b, map->View(), 1.0, {}, {} });
      if (shell.shell)
        pair.coarse.emplace(shell.shell, map);
      else
        pair.dynamic = std::make_unique<DynamicPointShell>(
          shell.dynamic->volume, map, shell.dynamic->origin, shell.dynamic->settings);
    }
}

RigidPose HapticScene::ShellInMap(const Pair& pair, const RigidPose& tool) const noexcept
{
  return this->Bodies[pair.body].mapInWorld.Inverse() * tool * this->Shells[pair.shell].shellInTool;
}

void HapticScene::Update(const RigidPose& tool) noexcept
{
  const double reachMm = this->Attracts() ? this->Now.contact.captureMm : 0.0;
  for (Pair& pair : this->Pairs)
    if (pair.dynamic)
      pair.dynamic->Update(this->ShellInMap(pair, tool), reachMm);
}

void HapticScene::SetIsovalue(std::size_t shell, double isovalue) noexcept
{
  for (Pair& pair : this->Pairs)
    if (pair.shell == shell && pair.dynamic)
      pair.dynamic->SetIsovalue(isovalue);
}

std::uint32_t HapticScene::CopyDynamicDiscs(std::span<ShellDisc> out) const noexcept
{
  std::uint32_t copied = 0;
  for (const Pair& pair : this->Pairs)
  {
    if (!pair.dynamic)
      continue;
    const RigidPose& inTool = this->Shells[pair.shell].shellInTool;
    const std::span<ShellDisc> rest = out.subspan(copied);
    const std::uint32_t count = CopyDiscs(pair.dynamic->Points(), 0, rest);
    for (ShellDisc& disc : rest.first(count))
    {
      disc.center = inTool.Place(disc.center);
      disc.normal = inTool.Turn(disc.normal);
    }
    copied += count;
  }
  return copied;
}

ToolContact::Answer HapticScene::At(const RigidPose& tool) noexcept
{
  Answer answer;
  answer.clearanceMm = std::numeric_limits<double>::infinity();
  std::fill(this->Near.begin(), this->Near.end(), 0U);
  this->Done = 0;
  for (Pair& pair : this->Pairs)
    this->AddPair(pair, tool, this->Attracts() ? ContactTerms::Snap : ContactTerms::Matrix, answer);
  return answer;
}

void HapticScene::AddPair(
  Pair& pair, const RigidPose& tool, ContactTerms terms, Answer& answer) noexcept
{
  const ContactPlacement at{ this->ShellInMap(pair, tool) };
  ContactSums sums;
  const double clearanceMm =
    pair.dynamic ? this->AddDynamic(pair, at, terms, sums) : this->AddStatic(pair, at, terms, sums);
  answer.clearanceMm = std::min(answer.clearanceMm, clearanceMm);
  const glm::dvec3 arm = tool.Turn(this->Shells[pair.shell].shellInTool.position);
  answer.sums += Moved(sums, this->Bodies[pair.body].mapInWorld.orientation, arm);
}

/// Returns the clearance, mm.
double HapticScene::AddDynamic(
  Pair& pair, const ContactPlacement& at, ContactTerms terms, ContactSums& sums) noexcept
{
  const std::uint32_t points = pair.dynamic->LastTick().points;
  this->Near[0] += points;
  if (points > 0)
  {
    const ContactSettings settings = Grown(this->Now.contact, pair.grown);
    this->Kernels[terms](pair.dynamic->Points(), at, pair.view, settings, sums);
    this->Done += points;
  }
  return pair.dynamic->ClearanceMm(at.shellInMap);
}

double HapticScene::AddStatic(
  Pair& pair, const ContactPlacement& at, ContactTerms terms, ContactSums& sums) noexcept
{
  const PointShell& shell = *this->Shells[pair.shell].shell;
  pair.coarse->Begin(
    at.shellInMap, terms == ContactTerms::Snap ? this->Now.contact.captureMm : 0.0);
  const int levels = std::min(shell.Levels(), static_cast<int>(std::ceil(this->Now.finest)) + 1);
  double nearBefore = 0.0;
  for (int level = 0; level < levels; ++level)
  {
    const std::span<const ContactPoints> runs = pair.coarse->Near(level);
    std::uint32_t points = 0;
    for (const ContactPoints& run : runs)
      points += run.count;
    this->Near[static_cast<std::size_t>(level)] += points;
    nearBefore = points;
    if (points == 0)
      continue;
    // Forces are linear in the area: blending levels is a stiffness per level.
    const double area = AreaShare(shell, level, this->Now.finest);
    const ContactSettings settings = Grown(this->Now.contact, pair.grown, area);
    ContactSums part;
    this->Kernels[terms](runs, at, pair.view, settings, part);
    part.contactArea *= area;
    part.attractedArea *= area;
    sums += part;
    this->Done += points;
  }
  // Levels that were not asked about: as dense near the body as the one before.
  for (int level = levels; level < shell.Levels() && level > 0; ++level)
  {
    const double denser =
      static_cast<double>(shell.Level(level).count) / shell.Level(level - 1).count;
    nearBefore *= denser;
    this->Near[static_cast<std::size_t>(level)] += static_cast<std::uint32_t>(nearBefore);
  }
  return pair.coarse->Asked().clearanceMm;
}

void HapticScene::TakeGrowth(HapticScene* before) noexcept
{
  const auto same = [](const RigidPose& a, const RigidPose& b)
  { return a.position == b.position && a.orientation == b.orientation; };
  for (Pair& pair : this->Pairs)
  {
    pair.grown = 0.0;
    const HapticShell& shell = this->Shells[pair.shell];
    const HapticBody& body = this->Bodies[pair.body];
    if (before == nullptr)
      continue;
    for (Pair& old : before->Pairs)
    {
      const HapticShell& oldShell = before->Shells[old.shell];
      const HapticBody& oldBody = before->Bodies[old.body];
      if (oldShell.shell != shell.shell || oldShell.dynamic != shell.dynamic ||
          !same(oldShell.shellInTool, shell.shellInTool) || oldBody.map != body.map ||
          !same(oldBody.mapInWorld, body.mapInWorld))
        continue;
      pair.grown = old.grown;
      std::swap(pair.dynamic, old.dynamic);
      break;
    }
  }
}

void HapticScene::Grow(double share) noexcept
{
  for (Pair& pair : this->Pairs)
    pair.grown = std::min(1.0, pair.grown + share);
}

void HapticScene::ListResources(ResourceList& list) const
{
  std::size_t bytes = 0;
  for (const Pair& pair : this->Pairs)
    if (pair.dynamic)
      pair.dynamic->ListResources(list);
    else
      bytes += pair.coarse->Bytes();
  if (bytes > 0)
    list.push_back({ "haptic coarse phases", bytes, 0.0, "which points may touch" });
}

} // namespace hasp
