#pragma once
#include "Planning/DerivedPart.h"
#include "View/MeshProp.h"
#include "View/SceneEntries.h"
#include "View/SceneJob.h"

#include <map>
#include <memory>
#include <string>

namespace hasp
{

/// A part's file.
struct PartBlob
{
  std::string blob; ///< empty: none
  PartFormat format = PartFormat::Stl;

  bool operator==(const PartBlob&) const = default;
};

struct PartEntry
{
  PartBlob part; ///< what is to be shown
  bool inDate = false;
  glm::dvec3 colour{ 1.0 };
  std::string shownBlob, failedBlob;
  std::unique_ptr<MeshProp> shown;
};

/// Guides, plates, implants, transplants and mitre guides as they were made: the newest part that
/// is in date, or else the newest, grey and translucent. Read on the WORKER; until one is read the
/// one before it stays. Threads: RENDER.
class PartProps : public SceneEntries<PartEntry>
{
public:
  explicit PartProps(SceneContext& of) : SceneEntries(of), Job(of.jobs) {}

  void Forget(); ///< another plan

  bool Sync() override;
  void ListResources(ResourceList& list) const override;

private:
  struct Read
  {
    vtkSmartPointer<vtkPolyData> mesh;
    std::string fault; ///< why there is none
  };
  template <typename T>
  void Follow(const std::vector<T>& objects, const glm::dvec3& colour);
  void Place(PlanId object, const PartEntry& entry);
  void ReadMissing(const std::map<PlanId, PartBlob>& missing);
  void Take(const std::map<PlanId, PartBlob>& asked, const std::map<PlanId, Read>& read);

  SceneJob Job;
  std::map<PlanId, PartBlob> Asked; ///< of the job
};

} // namespace hasp
