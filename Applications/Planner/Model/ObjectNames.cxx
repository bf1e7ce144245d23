#include "Model/ObjectNames.h"

#include "Grid/LabelTable.h"

#include <map>

namespace hasp
{

std::string ObjectNames::Of(const std::string& noun, PlanId id)
{
  static const std::map<std::string, const char*> names{
    { "volume", QT_TRANSLATE_NOOP("hasp::ObjectNames", "scan %1") },
    { "segmentation", QT_TRANSLATE_NOOP("hasp::ObjectNames", "segmentation %1") },
    { "surface", QT_TRANSLATE_NOOP("hasp::ObjectNames", "surface %1") },
    { "fragment", QT_TRANSLATE_NOOP("hasp::ObjectNames", "fragment %1") },
    { "group", QT_TRANSLATE_NOOP("hasp::ObjectNames", "group %1") },
    { "cut", QT_TRANSLATE_NOOP("hasp::ObjectNames", "cut %1") },
    { "guide", QT_TRANSLATE_NOOP("hasp::ObjectNames", "guide %1") },
    { "plate", QT_TRANSLATE_NOOP("hasp::ObjectNames", "plate %1") },
    { "implant", QT_TRANSLATE_NOOP("hasp::ObjectNames", "implant %1") },
    { "transplant", QT_TRANSLATE_NOOP("hasp::ObjectNames", "transplant %1") },
    { "mitre-guide", QT_TRANSLATE_NOOP("hasp::ObjectNames", "mitre-guide %1") },
    { "measure", QT_TRANSLATE_NOOP("hasp::ObjectNames", "measure %1") },
    { "mirror", QT_TRANSLATE_NOOP("hasp::ObjectNames", "mirror %1") },
  };
  return tr(names.at(noun)).arg(id).toStdString();
}

std::string ObjectNames::OfLabel(std::uint16_t label)
{
  return tr("label %1").arg(label).toStdString();
}

bool ObjectNames::IsGiven(const LabelName& label)
{
  return !label.name.empty() && label.name != OfLabel(label.label) &&
         (label.label == 1 || label.name != UnnamedLabel(label.label).name);
}

std::string ObjectNames::OfFragment(PlanId id, std::uint16_t label, const std::string& labelName)
{
  return IsGiven(LabelName{ label, labelName, {} }) ? labelName : Of<PlanFragment>(id);
}

} // namespace hasp
