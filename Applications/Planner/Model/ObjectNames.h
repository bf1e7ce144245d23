#pragma once
#include "Planning/PlanLists.h"

#include <QCoreApplication>

#include <cstdint>
#include <string>

namespace hasp
{

/// What is called how, in the user's language, until the user calls it otherwise: always with the
/// number that messages, files and lists say of it. Any thread.
class ObjectNames
{
  Q_DECLARE_TR_FUNCTIONS(hasp::ObjectNames)
public:
  /// Of a new object: "cut 4" of the one whose CalledObject is "cut 4".
  template <typename T>
  static std::string Of(PlanId id)
  {
    return ObjectNames::Of(PlanListOf<T>().noun, id);
  }
  static std::string Of(const std::string& noun, PlanId id);
  /// Whether it is called otherwise than new ones are, here or in a file: by words of the user's.
  template <typename T>
  static bool IsGiven(const T& object)
  {
    const std::string noun = PlanListOf<T>().noun;
    return !object.name.empty() && object.name != Of(noun, object.id) &&
           object.name != noun + ' ' + std::to_string(object.id);
  }
  static bool IsGiven(const LabelName& label);
  /// Of a label that is painted: it is no fragment yet, whose number would be another.
  static std::string OfLabel(std::uint16_t label);
  /// Of the fragment that a label becomes: the label's name, if it was given one.
  static std::string OfFragment(PlanId id, std::uint16_t label, const std::string& labelName);
};

} // namespace hasp
