#include "vtkHaspLabelTable.h"

#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedShortArray.h"

#include <set>
#include <stdexcept>

namespace hasp
{
namespace
{

constexpr const char* Values = "LabelValues";
constexpr const char* Names = "LabelNames";
constexpr const char* Colors = "LabelColors";
constexpr const char* OfBone = "LabelsOfBone";

/// nullptr if there is none of that name.
template <typename T>
T* ArrayOf(vtkFieldData* fields, const char* name, int components)
{
  vtkAbstractArray* array = fields->GetAbstractArray(name);
  T* typed = T::SafeDownCast(array);
  if (array && (!typed || typed->GetNumberOfComponents() != components))
    throw std::invalid_argument(std::string("the field data ") + name +
                                " is of another type or number of components than a label table's");
  return typed;
}

} // namespace

void SetLabelTable(vtkDataObject* data, const LabelTable& table)
{
  vtkFieldData* fields = data->GetFieldData();
  for (const char* name : { Values, Names, Colors, OfBone })
    fields->RemoveArray(name);
  if (table.empty())
    return;
  vtkNew<vtkUnsignedShortArray> values;
  vtkNew<vtkStringArray> names;
  vtkNew<vtkUnsignedCharArray> colors, ofBone;
  values->SetName(Values);
  names->SetName(Names);
  colors->SetName(Colors);
  colors->SetNumberOfComponents(3);
  ofBone->SetName(OfBone);
  for (const LabelEntry& entry : table)
  {
    values->InsertNextValue(entry.value);
    names->InsertNextValue(entry.name);
    colors->InsertNextTypedTuple(entry.colour.data());
    ofBone->InsertNextValue(entry.bone);
  }
  fields->AddArray(values);
  fields->AddArray(names);
  fields->AddArray(colors);
  fields->AddArray(ofBone);
}

LabelTable GetLabelTable(vtkDataObject* data)
{
  vtkFieldData* fields = data->GetFieldData();
  auto* values = ArrayOf<vtkUnsignedShortArray>(fields, Values, 1);
  auto* names = ArrayOf<vtkStringArray>(fields, Names, 1);
  auto* colors = ArrayOf<vtkUnsignedCharArray>(fields, Colors, 3);
  auto* ofBone = ArrayOf<vtkUnsignedCharArray>(fields, OfBone, 1);
  if (!values && !names && !colors)
    return {};
  const vtkIdType count = values ? values->GetNumberOfTuples() : 0;
  if (!values || !names || !colors || names->GetNumberOfTuples() != count ||
      colors->GetNumberOfTuples() != count || (ofBone && ofBone->GetNumberOfTuples() != count))
    throw std::invalid_argument(
      "a label table needs LabelValues, LabelNames and LabelColors of as many tuples each");
  LabelTable table;
  std::set<std::uint16_t> seen;
  for (vtkIdType n = 0; n < count; ++n)
  {
    LabelEntry entry{ values->GetValue(n), names->GetValue(n) };
    colors->GetTypedTuple(n, entry.colour.data());
    entry.bone = ofBone && ofBone->GetValue(n) != 0;
    if (entry.value == 0 || !seen.insert(entry.value).second)
      throw std::invalid_argument("LabelValues hold " + std::to_string(entry.value) +
                                  (entry.value == 0 ? ", which is nothing: must be in [1, 65535]"
                                                    : " twice: each label has one name"));
    table.push_back(entry);
  }
  return table;
}

} // namespace hasp
